/// Python's global interpreter lock (GIL), for calls from the threads of a run.
#pragma once

#include <pybind11/pybind11.h>

namespace swarmanoid::bindings {

/// Registers the calling thread with Python once, so that thread-local state of Python, such as NumPy's error settings,
/// persists between calls.
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

/// Holds the GIL during its lifetime.
class PythonLock {
  PythonThread thread_;  // before the lock
  pybind11::gil_scoped_acquire lock_;
};

}  // namespace swarmanoid::bindings
