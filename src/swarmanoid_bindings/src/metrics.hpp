/// Metrics of a run as a dictionary of Python.
///
/// Threads  the GIL must be held.
#pragma once

#include <pybind11/pybind11.h>

#include "swarmanoid_space/metrics.hpp"

namespace swarmanoid::bindings {

/// Adds each metric to a dictionary, by "id.name".
void addMetrics(const Metrics& metrics, pybind11::dict& values);

}  // namespace swarmanoid::bindings
