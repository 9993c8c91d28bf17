/// Conversion of values between Python and the suite: vectors, colours, and values as text of an experiment file.
///
/// Errors  a TypeError or ValueError with the name of the value, the value found and the values allowed.
#pragma once

#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid::bindings {

/// A value as text of an experiment file: True is "true", 0.5 is "0.5", (1, 2, 0) is "1, 2, 0".
std::string fileText(const pybind11::handle& value);

/// Converts a dictionary, each value by fileText.
NamedValues namedValues(const pybind11::dict& values);
pybind11::dict toPython(const NamedValues& values);

/// Finite numbers from any sequence or array of that length. @param what name for messages, "position [m]" @{
Eigen::Vector2d vector2(const pybind11::handle& value, const char* what);
Eigen::Vector3d vector3(const pybind11::handle& value, const char* what);
/// @}
/// An orientation from a quaternion x, y, z, w, as in `poses`, of any length but 0, or from a heading about z.
/// @param heading [rad], or None
Eigen::Quaterniond orientation(const pybind11::handle& quaternion, const pybind11::handle& heading);

/// Tuples of numbers. @{
pybind11::tuple toPython(const Eigen::Vector2d& vector);
pybind11::tuple toPython(const Eigen::Vector3d& vector);
pybind11::tuple toPython(const Eigen::Quaterniond& quaternion);
/// @}

/// A colour from a name ("red"), a string "r,g,b", or three numbers from 0 to 255.
Color color(const pybind11::handle& value);

}  // namespace swarmanoid::bindings
