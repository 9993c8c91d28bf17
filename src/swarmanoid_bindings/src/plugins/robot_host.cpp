#include "robot_host.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "object_rules.hpp"
#include "swarmanoid_space/space.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {

RobotHost::RobotHost(const Space& space, std::shared_ptr<const Moment> moment, std::shared_ptr<RobotSelection> robots,
                     const std::vector<std::string>& sensors, const std::vector<std::string>& actuators)
    : space_(&space),
      moment_(std::move(moment)),
      robots_(std::move(robots)),
      sensors_(devicesOf(space.readings, *robots_, sensors)),
      actuators_(devicesOf(space.commands, *robots_, actuators)) {}

std::vector<RobotHost::Device> RobotHost::devicesOf(const Banks& banks, const RobotSelection& robots,
                                                    const std::vector<std::string>& types) {
  std::vector<Device> devices;
  for (const std::string& type : types) {
    Device device{type, &fieldTableOf(*findDeviceType(type)), nullptr, {}};
    auto places = std::make_shared<std::vector<std::byte*>>();
    for (const Row row : robots.rows) {
      // Space gives only const banks; readings are never written, commands only in the phase that may write them
      places->push_back(static_cast<std::byte*>(const_cast<void*>(banks.find(type, row))));
    }
    device.places = std::move(places);
    for (const FieldPlaces& field : device.table->fields) {
      device.arrays.push_back(arrayFor(field, robots.rows.size()));
    }
    devices.push_back(std::move(device));
  }
  return devices;
}

void RobotHost::begin() {
  step_.emplace(moment_);
  for (std::vector<Device>* devices : {&sensors_, &actuators_}) {
    for (Device& device : *devices) {
      for (std::size_t i = 0; i < device.arrays.size(); ++i) {
        gather(*device.places, device.table->fields[i], device.arrays[i].mutable_data());
      }
    }
  }
}

py::array RobotHost::handOut(const py::array& row) {
  if (!step_) {
    return withoutWriting(py::array(row.attr("copy")()));
  }
  const auto known = handed_out_.find(row.ptr());
  if (known != handed_out_.end()) {
    return known->second.array;
  }
  return handed_out_.emplace(row.ptr(), HandedOut{row, py::array(row.attr("copy")())}).first->second.array;
}

void RobotHost::end() {
  for (auto& [key, handed] : handed_out_) {
    if (handed.array.nbytes() == handed.row.nbytes()) {  // Python code can change its shape
      std::memcpy(handed.row.mutable_data(), handed.array.data(), static_cast<std::size_t>(handed.row.nbytes()));
    }
    withoutWriting(handed.array);
  }
  handed_out_.clear();
  for (Device& device : actuators_) {
    for (std::size_t i = 0; i < device.arrays.size(); ++i) {
      scatter(device.arrays[i].data(), device.table->fields[i], *device.places);
    }
  }
  step_.reset();
}

void RobotHost::require() const {
  if (!step_) {
    throw std::runtime_error("the robot is between two steps: this can be done in a step of its controller");
  }
  step_->require();
}

py::dict RobotHost::dictionaryOf(const std::vector<Device>& devices) {
  py::dict result;
  for (const Device& device : devices) {
    py::dict arrays;
    for (std::size_t i = 0; i < device.arrays.size(); ++i) {
      arrays[py::str(device.table->fields[i].name)] = device.arrays[i];
    }
    py::list lists;
    for (const ListPlaces& list : device.table->lists) {
      lists.append(list.name);
    }
    result[py::str(device.type)] = py::make_tuple(arrays, lists);
  }
  return result;
}

py::object RobotHost::elements(const std::string& device, const std::string& list, std::size_t robot) const {
  require();
  for (const std::vector<Device>* devices : {&sensors_, &actuators_}) {
    const auto found = std::find_if(devices->begin(), devices->end(),
                                    [&](const Device& candidate) { return candidate.type == device; });
    if (found != devices->end()) {
      auto place = std::make_shared<std::vector<std::byte*>>(1, found->places->at(robot));
      return py::cast(ListArrays({*step_, std::move(place), {}}, *found->table->findList(list), device));
    }
  }
  throw py::key_error(device);
}

void bindRobotHost(py::module_& module) {
  py::class_<RobotHost, std::shared_ptr<RobotHost>> host_class(module, "RobotHost", "For _single.py.");
  refuseUnmade<RobotHost>();
  refuseCopies(host_class, kOfAMoment);
  host_class.def_property_readonly("sensors", &RobotHost::sensors)
      .def_property_readonly("actuators", &RobotHost::actuators)
      .def("hand_out", &RobotHost::handOut)
      .def_property_readonly("is_in_step", &RobotHost::isInStep)
      .def("elements", &RobotHost::elements)
      .def("name", &RobotHost::name)
      .def("type", &RobotHost::type)
      .def("uniform", &RobotHost::uniform)
      .def("gaussian", &RobotHost::gaussian)
      .def("log", &RobotHost::log)
      .def("debug", &RobotHost::debug)
      .def_property_readonly("tick", [](const RobotHost& host) { return host.space().tick; })
      .def_property_readonly("time", [](const RobotHost& host) { return toSeconds(host.space().time - kEpoch); })
      .def_property_readonly("dt", [](const RobotHost& host) { return toSeconds(host.space().clocktick); });
}

}  // namespace swarmanoid::bindings
