/// Conversion of parameters of the experiment file to Python.
#pragma once

#include <pybind11/pybind11.h>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid::bindings {

/// An element's text, or a dictionary of its children and attributes. If it has both, the text has the key "".
inline pybind11::object toPython(const Configuration& element) {
  if (element.children().empty()) {
    return pybind11::str(element.text());
  }
  pybind11::dict children;
  for (const Configuration& child : element.children()) {
    children[pybind11::str(child.name())] = toPython(child);
  }
  if (!element.text().empty()) {
    children[""] = pybind11::str(element.text());
  }
  return children;
}

/// Parameters of a plugin: a dictionary, empty if there are none.
inline pybind11::dict parametersOf(const Configuration& parameters) {
  const pybind11::object values = toPython(parameters);
  return pybind11::isinstance<pybind11::dict>(values) ? pybind11::dict(values) : pybind11::dict();
}

}  // namespace swarmanoid::bindings
