/// The class Simulation of the module.
#pragma once

#include <pybind11/pybind11.h>

namespace swarmanoid::bindings {

void bindSimulation(pybind11::module_& module);

}  // namespace swarmanoid::bindings
