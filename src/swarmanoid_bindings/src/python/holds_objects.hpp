/// Interface of parts of a run that hold Python objects, for Python's garbage collector. It frees cycles such as a
/// controller that refers to its simulation, which in turn holds the controller.
///
/// Threads  the GIL must be held.
#pragma once

#include <pybind11/pybind11.h>

namespace swarmanoid::bindings {

class HoldsObjects {
 public:
  virtual ~HoldsObjects() = default;

  /// Calls visit(object, argument) once per reference. @return the first result that is not 0, else 0
  virtual int visitObjects(visitproc visit, void* argument) const = 0;
  /// Releases all references. No function of the part may be called afterwards.
  virtual void releaseObjects() = 0;

 protected:
  HoldsObjects() = default;
  HoldsObjects(const HoldsObjects&) = default;
  HoldsObjects& operator=(const HoldsObjects&) = default;
};

/// Implements visitObjects for the given objects.
template <class... Objects>
int visitEach(visitproc visit, void* argument, const Objects&... objects) {
  int result = 0;
  const auto one = [&](PyObject* object) {
    if (result == 0 && object != nullptr) {
      result = visit(object, argument);
    }
  };
  (one(objects.ptr()), ...);
  return result;
}

}  // namespace swarmanoid::bindings
