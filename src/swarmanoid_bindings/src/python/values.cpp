#include "values.hpp"

#include <cmath>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {
namespace {

bool isText(const py::handle& value) { return py::isinstance<py::str>(value); }

/// Whether the value is a bool of Python or NumPy, which are different types.
bool isTruth(const py::handle& value) {
  return py::isinstance<py::bool_>(value) || py::isinstance(value, py::module_::import("numpy").attr("bool_"));
}

/// Whether the value is a sequence other than a string. Arrays count, although they are no collections.abc.Sequence.
bool hasItems(const py::handle& value) { return !isText(value) && py::hasattr(value, "__getitem__"); }

[[noreturn]] void refuse(const std::string& what, const py::handle& found, const std::string& allowed) {
  throw py::value_error(what + ": found " + std::string(py::repr(found)) + ", allowed: " + allowed);
}

std::vector<double> numbers(const py::handle& value, std::size_t count, const char* what) {
  const std::string allowed = std::to_string(count) + " finite numbers";
  std::vector<double> result;
  if (!hasItems(value) || !py::hasattr(value, "__len__") || py::len(value) != count) {
    refuse(what, value, allowed);
  }
  for (const py::handle item : value) {
    const double number = PyFloat_AsDouble(item.ptr());
    if (PyErr_Occurred() != nullptr) {
      PyErr_Clear();
      refuse(what, value, allowed);
    }
    if (!std::isfinite(number)) {
      refuse(what, value, allowed);
    }
    result.push_back(number);
  }
  return result;
}

}  // namespace

std::string fileText(const py::handle& value) {
  if (isTruth(value)) {
    return value.cast<bool>() ? "true" : "false";
  }
  if (hasItems(value)) {
    std::string text;
    for (const py::handle item : value) {
      text += (text.empty() ? "" : ", ") + fileText(item);
    }
    return text;
  }
  return py::str(value);
}

NamedValues namedValues(const py::dict& values) {
  NamedValues result;
  for (const auto& [name, value] : values) {
    result.emplace_back(py::str(name), fileText(value));
  }
  return result;
}

py::dict toPython(const NamedValues& values) {
  py::dict result;
  for (const auto& [name, value] : values) {
    result[py::str(name)] = value;
  }
  return result;
}

Eigen::Vector2d vector2(const py::handle& value, const char* what) {
  const std::vector<double> found = numbers(value, 2, what);
  return {found[0], found[1]};
}

Eigen::Vector3d vector3(const py::handle& value, const char* what) {
  const std::vector<double> found = numbers(value, 3, what);
  return {found[0], found[1], found[2]};
}

Eigen::Quaterniond orientation(const py::handle& quaternion, const py::handle& heading) {
  if (!heading.is_none()) {
    if (!quaternion.is_none()) {
      throw py::type_error("found orientation beside heading, allowed: one of them");
    }
    const double angle = heading.cast<double>();
    if (!std::isfinite(angle)) {
      refuse("heading", heading, "a finite number [rad]");
    }
    return {std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle)};
  }
  if (quaternion.is_none()) {
    return Eigen::Quaterniond::Identity();
  }
  const std::vector<double> found = numbers(quaternion, 4, "orientation");
  Eigen::Quaterniond result(found[3], found[0], found[1], found[2]);
  constexpr double kLeastNorm = 1e-6;
  if (result.norm() < kLeastNorm) {
    refuse("orientation", quaternion, "a quaternion x, y, z, w that is not 0");
  }
  return result;
}

py::tuple toPython(const Eigen::Vector2d& vector) { return py::make_tuple(vector.x(), vector.y()); }

py::tuple toPython(const Eigen::Vector3d& vector) { return py::make_tuple(vector.x(), vector.y(), vector.z()); }

py::tuple toPython(const Eigen::Quaterniond& quaternion) {
  return py::make_tuple(quaternion.x(), quaternion.y(), quaternion.z(), quaternion.w());
}

Color color(const py::handle& value) {
  try {
    return parseColorOrThrow(fileText(value), "color", {});
  } catch (const ConfigError& error) {
    throw py::value_error(error.what());
  }
}

}  // namespace swarmanoid::bindings
