/// The class swarmanoid.Worlds: many worlds of one experiment as arrays (swarmanoid_space/worlds/worlds.hpp).
#pragma once

#include <pybind11/pybind11.h>

namespace swarmanoid::bindings {

void bindWorlds(pybind11::module_& module);

}  // namespace swarmanoid::bindings
