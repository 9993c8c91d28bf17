/// What holds for all classes of the module: an object that was not made, or that cannot be copied, says so.
///
/// Python makes objects without their constructor, by `Class.__new__`, by copy and pickle, and in a subclass that uses
/// itself before `super().__init__()`. pybind11 would give such an object memory without values.
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <string>

namespace swarmanoid::bindings {

/// Why a part of a simulation cannot be copied.
constexpr const char* kOfAMoment = "it is good for one moment of its simulation";

/// Any use of an object that was not made is a TypeError.
template <class Value>
void refuseUnmade() {
  // pybind11 calls this for such an object only: those that it makes itself come from `new`
  pybind11::detail::get_type_info(typeid(Value), true)->operator_new = [](std::size_t) -> void* {
    throw pybind11::type_error(
        "this object has not been made: only its constructor makes it, in a subclass "
        "super().__init__()");
  };
}

/// copy, deepcopy and pickle are a TypeError. @param why such as "a Robots is of one moment of its simulation"
template <class Value, class... Options>
void refuseCopies(pybind11::class_<Value, Options...>& type, const std::string& why) {
  type.def("__reduce_ex__", [why](const pybind11::object& self, const pybind11::object&) -> pybind11::object {
    throw pybind11::type_error("a " + std::string(pybind11::str(pybind11::type::of(self).attr("__name__"))) +
                               " cannot be copied or pickled: " + why);
  });
}

}  // namespace swarmanoid::bindings
