/// Events of a tick, for Python.
#pragma once

#include <pybind11/pybind11.h>

#include "python/python_text.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::bindings {

/// A list of dictionaries with the keys kind, entity, other, text.
inline pybind11::list eventsOf(const Space& space) {
  using pybind11::operator""_a;
  pybind11::list events;
  for (const Event& event : space.events) {
    events.append(pybind11::dict("kind"_a = toString(event.kind), "entity"_a = event.entity, "other"_a = event.other,
                                 "text"_a = pythonText(event.text)));
  }
  return events;
}

}  // namespace swarmanoid::bindings
