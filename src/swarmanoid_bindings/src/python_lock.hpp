/// Python's lock, for calls from the threads of a run.
#pragma once

#include <pybind11/pybind11.h>

namespace swarmanoid::bindings {

/// This thread is one of Python's from its first call on: what Python keeps for a thread, such as NumPy's settings of
/// errors, stays from one call to the next.
class PythonThread {
 public:
  PythonThread() { static thread_local const Known known; }

 private:
  struct Known {
    Known() {
      if (PyGILState_GetThisThreadState() == nullptr) {
        PyGILState_Ensure();
        PyEval_SaveThread();
      }
    }
  };
};

/// Python's lock is held for as long as this lives.
class PythonLock {
  PythonThread thread_;  // before the lock
  pybind11::gil_scoped_acquire lock_;
};

}  // namespace swarmanoid::bindings
