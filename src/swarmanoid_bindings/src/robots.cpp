#include "robots.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <set>

#include "swarmanoid_interface/configuration.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {
namespace {

std::vector<Row> rowsOf(Span<const GroupMember> members) {
  std::vector<Row> rows;
  for (const GroupMember& member : members) {
    rows.push_back(member.row);
  }
  return rows;
}

/// A table with a line of `width` numbers a row, which fill(row, numbers) fills.
template <class Fill>
py::array_t<double> tableOf(const std::vector<Row>& rows, py::ssize_t width, Fill fill) {
  py::array_t<double> table({static_cast<py::ssize_t>(rows.size()), width});
  double* line = table.mutable_data();
  for (const Row row : rows) {
    fill(row, line);
    line += width;
  }
  return table;
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
  return std::any_of(rows_.begin(), rows_.end(), [&](Row row) { return banks_->find(type, row) != nullptr; });
}

std::vector<std::string> Devices::types() const {
  moment_.require();
  std::set<std::string> types;
  for (const Row row : rows_) {
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
  auto records = std::make_shared<Records>(Records{moment_, {}});
  for (const Row row : rows_) {
    if (const void* device = banks_->find(type, row)) {
      // Space holds the banks const for whoever looks; FieldArrays says what may be written
      records->places.push_back(static_cast<std::byte*>(const_cast<void*>(device)));
    }
  }
  const DeviceType* described = findDeviceType(type);
  if (described == nullptr || (records->places.empty() && !rows_.empty())) {
    throw py::key_error(unknownName("the device", type, types()));
  }
  return known_.emplace(type, FieldArrays(std::move(records), fieldTableOf(*described), type, "", is_writable_))
      .first->second;
}

py::array_t<std::int64_t> Devices::owners(const std::string& type) const {
  moment_.require();
  std::vector<std::int64_t> owners;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (banks_->find(type, rows_[i]) != nullptr) {
      owners.push_back(static_cast<std::int64_t>(i));
    }
  }
  return py::array_t<std::int64_t>(static_cast<py::ssize_t>(owners.size()), owners.data());
}

Robots::Robots(const Space& space, std::shared_ptr<const Moment> moment, std::vector<Row> rows)
    : Robots(space, std::move(moment), std::move(rows), false) {}

Robots::Robots(const Space& space, std::shared_ptr<const Moment> moment, std::vector<Row> rows, bool is_writable)
    : space_(&space),
      moment_(std::move(moment)),
      rows_(std::move(rows)),
      readings_(moment_, space.readings, rows_, false),
      commands_(moment_, space.commands, rows_, is_writable) {}

std::vector<std::string> Robots::names() const {
  std::vector<std::string> names;
  for (const Row row : rows_) {
    names.push_back(space().entities.name[row]);
  }
  return names;
}

std::vector<std::string> Robots::types() const {
  std::vector<std::string> types;
  for (const Row row : rows_) {
    const auto& robot = space().robots[row];
    types.push_back(robot == nullptr ? space().entities.model[row]->type : robot->type());
  }
  return types;
}

py::array_t<double> Robots::poses() const {
  const auto& poses = space().entities.pose;
  return tableOf(rows_, 7, [&](Row row, double* line) {
    Eigen::Map<Eigen::Vector3d>{line} = poses[row].position;
    Eigen::Map<Eigen::Vector4d>{line + 3} = poses[row].orientation.coeffs();
  });
}

py::array_t<double> Robots::twists() const {
  const auto& twists = space().entities.twist;
  return tableOf(rows_, 6, [&](Row row, double* line) {
    Eigen::Map<Eigen::Vector3d>{line} = twists[row].linear;
    Eigen::Map<Eigen::Vector3d>{line + 3} = twists[row].angular;
  });
}

SteppedRobots::SteppedRobots(const Space& space, std::shared_ptr<const Moment> moment, Span<const GroupMember> members)
    : Robots(space, std::move(moment), rowsOf(members), true) {
  for (const GroupMember& member : members) {
    robots_.push_back(member.robot);
  }
}

py::array_t<double> SteppedRobots::uniform(double low, double high) const {
  space();
  return drawn(robots_, [&](RandomStream& random) { return random.uniform(low, high); });
}

py::array_t<double> SteppedRobots::gaussian(double mean, double standard_deviation) const {
  space();
  return drawn(robots_, [&](RandomStream& random) { return random.gaussian(mean, standard_deviation); });
}

Robot& SteppedRobots::at(std::size_t robot) const {
  space();
  if (robot >= robots_.size()) {
    throw py::index_error("found the robot " + std::to_string(robot) + ", allowed: less than " +
                          std::to_string(robots_.size()));
  }
  return *robots_[robot];
}

void SteppedRobots::log(std::size_t robot, const std::string& text) const { at(robot).log(text); }

void SteppedRobots::debug(std::size_t robot, const std::string& key, const std::string& value) const {
  at(robot).debug(key, value);
}

void bindRobots(py::module_& module) {
  constexpr auto kInternal = py::return_value_policy::reference_internal;
  py::class_<Devices>(module, "Devices", "The devices of robots, by type.")
      .def("__getitem__", &Devices::at, kInternal)
      .def("__contains__", &Devices::has)
      .def("keys", &Devices::types, "The types that any of the robots has, sorted.")
      .def("__iter__", [](const Devices& devices) { return py::iter(py::cast(devices.types())); })
      .def("__len__", [](const Devices& devices) { return devices.types().size(); })
      .def("owners", &Devices::owners, py::arg("type"), "The places, among the robots, of those that have the device.");
  py::class_<Robots>(module, "Robots", "Robots of a simulation in one moment, by entity number.")
      .def("__len__", &Robots::size)
      .def_property_readonly("names", &Robots::names)
      .def_property_readonly("types", &Robots::types)
      .def_property_readonly("poses", &Robots::poses,
                             "(robots, 7): position [m] and orientation as a quaternion x, y, z, w, in W.")
      .def_property_readonly("twists", &Robots::twists, "(robots, 6): linear [m/s] and angular velocity [rad/s], in W.")
      .def_property_readonly("readings", &Robots::readings, kInternal)
      .def_property_readonly("commands", &Robots::commands, kInternal);
  py::class_<SteppedRobots, Robots>(module, "SteppedRobots", "The robots of a controller, in its step.")
      .def_property_readonly("tick", &SteppedRobots::tick)
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
