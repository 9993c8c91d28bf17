/// What may be done to a running world, as values in Python: a class for each kind of intervention
/// (swarmanoid_space/intervention.hpp). Values do not change; equal ones are equal, and they can be pickled.
#pragma once

#include <pybind11/pybind11.h>

#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid::bindings {

/// @throws pybind11::type_error if it is none
Intervention toIntervention(const pybind11::handle& value);

void bindInterventions(pybind11::module_& module);

}  // namespace swarmanoid::bindings
