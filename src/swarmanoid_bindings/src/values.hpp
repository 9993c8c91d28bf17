/// Values between Python and the suite: vectors, colours, values as they would stand in an experiment file.
///
/// Errors  a TypeError or ValueError names the value, what was found and what is allowed.
#pragma once

#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid::bindings {

/// What a value would be in an experiment file: True is "true", 0.5 is "0.5", (1, 2, 0) is "1, 2, 0".
std::string fileText(const pybind11::handle& value);

/// A dictionary, each value by fileText.
NamedValues namedValues(const pybind11::dict& values);
pybind11::dict toPython(const NamedValues& values);

/// So many finite numbers, from any sequence or array of them. @param what "position [m]" @{
Eigen::Vector2d vector2(const pybind11::handle& value, const char* what);
Eigen::Vector3d vector3(const pybind11::handle& value, const char* what);
/// @}
/// A quaternion x, y, z, w, as in `poses`, or what turns by a heading about z; of any length but 0.
/// @param heading [rad], or None
Eigen::Quaterniond orientation(const pybind11::handle& quaternion, const pybind11::handle& heading);

/// Tuples of numbers. @{
pybind11::tuple toPython(const Eigen::Vector2d& vector);
pybind11::tuple toPython(const Eigen::Vector3d& vector);
pybind11::tuple toPython(const Eigen::Quaterniond& quaternion);
/// @}

/// A name ("red"), a text "r,g,b", or three numbers from 0 to 255.
Color color(const pybind11::handle& value);

}  // namespace swarmanoid::bindings
