/// What keeps objects of Python for a run, as Python's collector of garbage sees it: a controller that knows its
/// simulation, and the simulation the controller, are given back once nothing else refers to them.
///
/// Threads  under Python's lock.
#pragma once

#include <pybind11/pybind11.h>

namespace swarmanoid::bindings {

class HoldsObjects {
 public:
  virtual ~HoldsObjects() = default;

  /// Calls visit(object, argument) once for each reference. @return what the first such call returned that was not 0
  virtual int visitObjects(visitproc visit, void* argument) const = 0;
  /// Gives all of them up. Nothing is called afterwards.
  virtual void releaseObjects() = 0;

 protected:
  HoldsObjects() = default;
  HoldsObjects(const HoldsObjects&) = default;
  HoldsObjects& operator=(const HoldsObjects&) = default;
};

/// For visitObjects of so many objects.
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
