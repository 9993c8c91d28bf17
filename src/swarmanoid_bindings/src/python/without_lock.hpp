/// Ticks without the GIL, also while Python ends.
///
/// A daemon thread that ticks when the main thread ends cannot reacquire the GIL: Python terminates such a thread by
/// unwinding its stack through code of a run, which aborts the process. So the thread that ends Python waits for
/// running ticks, and other threads that begin ticks later block until the process ends, as in newer versions of
/// Python.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>

namespace swarmanoid::bindings {

/// Releases the GIL during its lifetime. @pre this thread holds it
class WithoutLock {
 public:
  WithoutLock();
  ~WithoutLock();
  WithoutLock(const WithoutLock&) = delete;
  WithoutLock& operator=(const WithoutLock&) = delete;

  /// Whether another thread ends Python and waits for this one. Callable from any thread.
  static bool mustEnd();

 private:
  std::optional<pybind11::gil_scoped_release> unlocked_;
};

/// Registers an exit handler that waits up to 10 s for running ticks.
void waitForTicksAtExit();

}  // namespace swarmanoid::bindings
