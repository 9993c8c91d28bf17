#include "robots.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <limits>
#include <set>

#include "plugins/object_rules.hpp"
#include "swarmanoid_interface/configuration.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {
namespace {

/// A table with `width` numbers per row, which fill(row, numbers) writes.
template <class Fill>
py::array_t<double> tableOf(const std::vector<Row>& rows, py::ssize_t width, Fill fill) {
  py::array_t<double> table({static_cast<py::ssize_t>(rows.size()), width});
  double* line = table.mutable_data();
  for (const Row row : rows) {
    fill(row, line);
    line += width;
  }
  return withoutWriting(std::move(table));
}

template <class Draw>
py::array_t<double> drawn(const std::vector<Robot*>& robots, Draw draw) {
  py::array_t<double> numbers(static_cast<py::ssize_t>(robots.size()));
  std::transform(robots.begin(), robots.end(), numbers.mutable_data(),
                 [&](Robot* robot) { return draw(robot->random()); });
  return numbers;
}

}  // namespace

bool Devices::has(const std::string& type) const {
  moment_.require();
  return std::any_of(rows_->begin(), rows_->end(), [&](Row row) { return banks_->find(type, row) != nullptr; });
}

std::vector<std::string> Devices::types() const {
  moment_.require();
  std::set<std::string> types;
  for (const Row row : *rows_) {
    banks_->visit(row, [&](const std::string& type, const void*) { types.insert(type); });
  }
  return {types.begin(), types.end()};
}

const FieldArrays& Devices::at(const std::string& type) {
  moment_.require();
  const auto known = known_.find(type);
  if (known != known_.end()) {
    return known->second;
  }
  const Places places = placesOf(type);
  const DeviceType* described = findDeviceType(type);
  if (described == nullptr || (places->empty() && !rows_->empty())) {
    throw py::key_error(unknownName("the device", type, types()));
  }
  auto records = std::make_shared<Records>(Records{moment_, places, {}});
  return known_.emplace(type, FieldArrays(std::move(records), fieldTableOf(*described), type, "", use_)).first->second;
}

void Devices::writeBack() const {
  for (const auto& [type, arrays] : known_) {
    arrays.writeBack();
  }
}

Places Devices::placesOf(const std::string& type) {
  Places& places = (*places_)[type];
  if (places == nullptr) {
    auto found = std::make_shared<std::vector<std::byte*>>();
    found->reserve(rows_->size());
    for (const Row row : *rows_) {
      if (const void* device = banks_->find(type, row)) {
        // Space gives only const banks; FieldArrays prevents forbidden writes
        found->push_back(static_cast<std::byte*>(const_cast<void*>(device)));
      }
    }
    places = std::move(found);
  }
  return places;
}

py::array_t<std::int64_t> Devices::owners(const std::string& type) const {
  moment_.require();
  std::vector<std::int64_t> owners;
  for (std::size_t i = 0; i < rows_->size(); ++i) {
    if (banks_->find(type, (*rows_)[i]) != nullptr) {
      owners.push_back(static_cast<std::int64_t>(i));
    }
  }
  return withoutWriting(py::array_t<std::int64_t>(static_cast<py::ssize_t>(owners.size()), owners.data()));
}

namespace {

std::shared_ptr<RobotSelection> selectionOf(std::vector<Row> rows) {
  auto selection = std::make_shared<RobotSelection>();
  selection->rows = std::move(rows);
  return selection;
}

/// The rows of a selection; the pointer keeps the selection alive.
std::shared_ptr<const std::vector<Row>> rowsIn(const std::shared_ptr<RobotSelection>& selection) {
  return {selection, &selection->rows};
}

}  // namespace

Robots::Robots(const Space& space, std::shared_ptr<const Moment> moment, std::vector<Row> rows)
    : Robots(space, std::move(moment), selectionOf(std::move(rows)), ArrayUse::kLook) {}

Robots::Robots(const Space& space, std::shared_ptr<const Moment> moment, std::shared_ptr<RobotSelection> selection,
               ArrayUse use_of_commands)
    : space_(&space),
      whole_moment_(std::move(moment)),
      moment_(whole_moment_),
      selection_(std::move(selection)),
      readings_(moment_, space.readings, rowsIn(selection_), selection_->readings, ArrayUse::kLook),
      commands_(moment_, space.commands, rowsIn(selection_), selection_->commands, use_of_commands) {}

Robots robotsOf(const Space& space, std::shared_ptr<const Moment> moment) {
  std::vector<Row> rows;
  for (const Row row : space.entities.order) {
    if (space.robots[row] != nullptr) {
      rows.push_back(row);
    }
  }
  return {space, std::move(moment), std::move(rows)};
}

Robots entitiesOf(const Space& space, std::shared_ptr<const Moment> moment) {
  return {space, std::move(moment), space.entities.order};
}

std::vector<std::string> Robots::names() const {
  std::vector<std::string> names;
  for (const Row row : rows()) {
    names.push_back(space().entities.name[row]);
  }
  return names;
}

std::vector<std::string> Robots::types() const {
  std::vector<std::string> types;
  for (const Row row : rows()) {
    const auto& robot = space().robots[row];
    types.push_back(robot == nullptr ? space().entities.model[row]->type : robot->type());
  }
  return types;
}

std::vector<std::string> Robots::controllers() const {
  std::vector<std::string> controllers;
  for (const Row row : rows()) {
    const ControllerDescription* description = space().controllers[row].description;
    controllers.push_back(description == nullptr ? "" : description->id);
  }
  return controllers;
}

py::array_t<std::int64_t> Robots::numbers() const {
  py::array_t<std::int64_t> numbers(static_cast<py::ssize_t>(rows().size()));
  std::transform(rows().begin(), rows().end(), numbers.mutable_data(),
                 [&](Row row) { return static_cast<std::int64_t>(space().entities.number[row]); });
  return withoutWriting(std::move(numbers));
}

Robots Robots::take(const std::vector<std::size_t>& places) const {
  std::vector<Row> some;
  for (const std::size_t place : places) {
    if (place >= rows().size()) {
      throw py::index_error("found the robot " + std::to_string(place) + ", allowed: less than " +
                            std::to_string(rows().size()));
    }
    some.push_back(rows()[place]);
  }
  return {space(), whole_moment_, std::move(some)};
}

py::array_t<double> Robots::poses() const {
  const auto& poses = space().entities.pose;
  return tableOf(rows(), 7, [&](Row row, double* line) {
    Eigen::Map<Eigen::Vector3d>{line} = poses[row].position;
    Eigen::Map<Eigen::Vector4d>{line + 3} = poses[row].orientation.coeffs();
  });
}

py::array_t<double> Robots::twists() const {
  const auto& twists = space().entities.twist;
  return tableOf(rows(), 6, [&](Row row, double* line) {
    Eigen::Map<Eigen::Vector3d>{line} = twists[row].linear;
    Eigen::Map<Eigen::Vector3d>{line + 3} = twists[row].angular;
  });
}

py::array_t<double> Robots::property(const std::string& name) const {
  py::array_t<double> values(static_cast<py::ssize_t>(rows().size()));
  std::transform(rows().begin(), rows().end(), values.mutable_data(), [&](Row row) {
    return space().property(row, name).value_or(std::numeric_limits<double>::quiet_NaN());
  });
  return withoutWriting(std::move(values));
}

py::array_t<double> SteppedRobots::uniform(double low, double high) const {
  space();
  return drawn(robots(), [&](RandomStream& random) { return random.uniform(low, high); });
}

py::array_t<double> SteppedRobots::gaussian(double mean, double standard_deviation) const {
  space();
  return drawn(robots(), [&](RandomStream& random) { return random.gaussian(mean, standard_deviation); });
}

Robot& SteppedRobots::at(std::size_t robot) const {
  space();
  if (robot >= robots().size()) {
    throw py::index_error("found the robot " + std::to_string(robot) + ", allowed: less than " +
                          std::to_string(robots().size()));
  }
  return *robots()[robot];
}

void SteppedRobots::log(std::size_t robot, const std::string& text) const { at(robot).log(text); }

void SteppedRobots::debug(std::size_t robot, const std::string& key, const std::string& value) const {
  at(robot).debug(key, value);
}

void bindRobots(py::module_& module) {
  constexpr auto kInternal = py::return_value_policy::reference_internal;
  py::class_<Devices> devices_class(module, "Devices", "The devices of robots, by type.");
  refuseUnmade<Devices>();
  refuseCopies(devices_class, kOfAMoment);
  devices_class.def("__getitem__", &Devices::at, kInternal)
      .def("__contains__", &Devices::has)
      .def("keys", &Devices::types, "The types that any of the robots has, sorted.")
      .def("__iter__", [](const Devices& devices) { return py::iter(py::cast(devices.types())); })
      .def("__len__", [](const Devices& devices) { return devices.types().size(); })
      .def("owners", &Devices::owners, py::arg("type"), "The places, among the robots, of those that have the device.");
  py::class_<Robots> robots_class(module, "Robots", "Robots of a simulation in one moment, by entity number.");
  refuseUnmade<Robots>();
  refuseCopies(robots_class, kOfAMoment);
  robots_class.def("__len__", &Robots::size)
      .def_property_readonly("names", &Robots::names, "Their names, a list of str.")
      .def_property_readonly("types", &Robots::types, "Their types, such as 'footbot', a list of str.")
      .def_property_readonly("controllers", &Robots::controllers,
                             "The id of each one's controller configuration; '' for none.")
      .def_property_readonly("numbers", &Robots::numbers,
                             "(robots,): entity numbers, which rise and are never used again.")
      .def("take", &Robots::take, py::arg("places"), "Those at some places among these, of the same moment.")
      .def_property_readonly("poses", &Robots::poses,
                             "(robots, 7): position [m] and orientation as a quaternion x, y, z, w, in W.")
      .def_property_readonly("twists", &Robots::twists, "(robots, 6): linear [m/s] and angular velocity [rad/s], in W.")
      .def("property", &Robots::property, py::arg("name"),
           "(robots,): a property of each, such as 'intensity'; NaN for robots without it.")
      .def_property_readonly("readings", &Robots::readings, kInternal,
                             "Sensors by type: readings['footbot_proximity'].value is (robots that have it, 24).")
      .def_property_readonly("commands", &Robots::commands, kInternal,
                             "Actuators by type: commands['footbot_wheels'].left is (robots that have it,), in rad/s.");
  py::class_<SteppedRobots, Robots> stepped_class(module, "SteppedRobots", "The robots of a controller, in its step.");
  refuseUnmade<SteppedRobots>();
  stepped_class.def_property_readonly("tick", &SteppedRobots::tick, "Number of this tick; the first one is 0.")
      .def_property_readonly("time", &SteppedRobots::time, "Simulated time since the start [s].")
      .def_property_readonly("dt", &SteppedRobots::dt, "Time of a tick [s].")
      .def("uniform", &SteppedRobots::uniform, py::arg("low") = 0.0, py::arg("high") = 1.0,
           "(robots,): a number of each robot's own random stream, from low to high.")
      .def("gaussian", &SteppedRobots::gaussian, py::arg("mean") = 0.0, py::arg("standard_deviation") = 1.0,
           "(robots,): the same, normally distributed.")
      .def("log", &SteppedRobots::log, py::arg("robot"), py::arg("text"), "A line in the log of one robot.")
      .def("debug", &SteppedRobots::debug, py::arg("robot"), py::arg("key"), py::arg("value"),
           "A value of one robot that people see.");
}

}  // namespace swarmanoid::bindings
