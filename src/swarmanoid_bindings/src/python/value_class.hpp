/// Value classes for Python: constructor arguments are properties, and repr gives an expression that recreates the
/// value.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "plugins/object_rules.hpp"

namespace swarmanoid::bindings {

/// A class whose constructor takes the named properties as positional arguments, in that order.
/// Objects are compared and hashed by them, and printed as `Move(entity='fb_1', position=(1.0, 2.0, 0.0))`.
template <class Value>
pybind11::class_<Value> valueClass(pybind11::module_& module, const char* name, const char* text,
                                   const std::vector<std::string>& properties) {
  namespace py = pybind11;
  const auto valuesOf = [properties](const py::object& self) {
    py::tuple values(properties.size());
    for (std::size_t i = 0; i < properties.size(); ++i) {
      values[i] = self.attr(properties[i].c_str());
    }
    return values;
  };
  py::class_<Value> type(module, name, text);
  refuseUnmade<Value>();
  type.def("__repr__",
           [name, properties](const py::object& self) {
             std::string line;
             for (const std::string& property : properties) {
               line += (line.empty() ? "" : ", ") + property + "=" + std::string(py::repr(self.attr(property.c_str())));
             }
             return name + ("(" + line + ")");
           })
      .def("__eq__",
           [valuesOf](const py::object& self, const py::object& other) {
             return py::isinstance<Value>(other) && valuesOf(self).equal(valuesOf(other));
           })
      .def("__hash__", [](const py::object& self) { return py::hash(py::repr(self)); })
      .def("__reduce__",
           [valuesOf](const py::object& self) { return py::make_tuple(py::type::of(self), valuesOf(self)); });
  return type;
}

}  // namespace swarmanoid::bindings
