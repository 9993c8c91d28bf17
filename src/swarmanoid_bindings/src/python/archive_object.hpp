/// State of Python objects for snapshots of a run.
#pragma once

#include <pybind11/pybind11.h>

#include "swarmanoid_interface/state_archive.hpp"

namespace swarmanoid::bindings {

/// Saves or loads the attributes of a controller or a rule, pickled, besides its robot and the robot's devices.
/// Functions have those that were given to them; variables that a function shares with other code are not saved.
/// @throws std::runtime_error if an attribute cannot be pickled @pre the GIL is held
void archiveObject(StateArchive& state, const pybind11::object& object);

}  // namespace swarmanoid::bindings
