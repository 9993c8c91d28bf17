/// Parameters of the experiment file for Python.
#pragma once

#include <pybind11/pybind11.h>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid::bindings {

/// An element's text, or the dictionary of its children and attributes, with its text under "" if it has one besides.
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

/// Those of a plugin: a dictionary, empty if there are none.
inline pybind11::dict parametersOf(const Configuration& parameters) {
  const pybind11::object values = toPython(parameters);
  return pybind11::isinstance<pybind11::dict>(values) ? pybind11::dict(values) : pybind11::dict();
}

}  // namespace swarmanoid::bindings
