/// Interventions in a running world as Python values: one class per kind of intervention
/// (swarmanoid_space/intervention.hpp). Values are immutable, compare by content, and can be pickled.
#pragma once

#include <pybind11/pybind11.h>

#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid::bindings {

/// @throws pybind11::type_error if the value is no intervention
Intervention toIntervention(const pybind11::handle& value);

void bindInterventions(pybind11::module_& module);

}  // namespace swarmanoid::bindings
