/// Rules for all classes of the module: clear errors for objects that were not constructed or cannot be copied.
///
/// Python can create objects without calling their constructor: by `Class.__new__`, by copy and pickle, and in a
/// subclass that uses `self` before `super().__init__()`. pybind11 would give such an object uninitialized memory.
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <string>

namespace swarmanoid::bindings {

/// Reason why a part of a simulation cannot be copied.
constexpr const char* kOfAMoment = "it is good for one moment of its simulation";

/// Makes any use of an object that was not constructed a TypeError.
template <class Value>
void refuseUnmade() {
  // pybind11 calls this for such objects only: its own constructors use `new`
  pybind11::detail::get_type_info(typeid(Value), true)->operator_new = [](std::size_t) -> void* {
    throw pybind11::type_error(
        "this object has not been made: only its constructor makes it, in a subclass "
        "super().__init__()");
  };
}

/// Makes copy, deepcopy and pickle a TypeError. @param why reason for the message, such as kOfAMoment
template <class Value, class... Options>
void refuseCopies(pybind11::class_<Value, Options...>& type, const std::string& why) {
  type.def("__reduce_ex__", [why](const pybind11::object& self, const pybind11::object&) -> pybind11::object {
    throw pybind11::type_error("a " + std::string(pybind11::str(pybind11::type::of(self).attr("__name__"))) +
                               " cannot be copied or pickled: " + why);
  });
}

}  // namespace swarmanoid::bindings
