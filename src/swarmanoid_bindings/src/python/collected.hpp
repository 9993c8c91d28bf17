/// Garbage collection of objects that hold Python objects: Python finds cycles through them.
#pragma once

#include <pybind11/pybind11.h>

namespace swarmanoid::bindings {

/// @return null if the object was not constructed, or if it belongs to another one
template <class Owner>
Owner* madeIn(PyObject* self) {
  auto* const instance = reinterpret_cast<pybind11::detail::instance*>(self);
  const auto holder = instance->get_value_and_holder(pybind11::detail::get_type_info(typeid(Owner), true));
  return holder.holder_constructed() ? holder.template value_ptr<Owner>() : nullptr;
}

/// For py::custom_type_setup of a class with the functions visitObjects and releaseObjects (holds_objects.hpp).
template <class Owner>
void letBeCollected(PyHeapTypeObject* heap_type) {
  PyTypeObject& type = heap_type->ht_type;
  type.tp_flags |= Py_TPFLAGS_HAVE_GC;
  type.tp_traverse = [](PyObject* self, visitproc visit, void* argument) {
    const Owner* const owner = madeIn<Owner>(self);
    const int result = visit(reinterpret_cast<PyObject*>(Py_TYPE(self)), argument);
    return result != 0 || owner == nullptr ? result : owner->visitObjects(visit, argument);
  };
  type.tp_clear = [](PyObject* self) {
    if (Owner* const owner = madeIn<Owner>(self)) {
      owner->releaseObjects();
    }
    return 0;
  };
}

}  // namespace swarmanoid::bindings
