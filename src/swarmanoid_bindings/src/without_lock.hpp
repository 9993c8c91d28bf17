/// Ticks without Python's lock, also while Python ends.
///
/// A daemon thread that ticks when the main thread ends cannot have the lock again: Python ends such a thread by
/// unwinding its stack, through code of a run, which aborts the process. So the thread that ends Python waits for ticks
/// under way, and other threads that come later wait for the end of the process, as those of newer versions of Python
/// do.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>

namespace swarmanoid::bindings {

/// Other threads have Python's lock for as long as this lives. @pre this thread has it
class WithoutLock {
 public:
  WithoutLock();
  ~WithoutLock();
  WithoutLock(const WithoutLock&) = delete;
  WithoutLock& operator=(const WithoutLock&) = delete;

  /// Whether another thread waits for this one, so that Python can end. Any thread.
  static bool mustEnd();

 private:
  std::optional<pybind11::gil_scoped_release> unlocked_;
};

/// Has Python wait for ticks under way before it ends, at most 10 s.
void waitForTicksAtExit();

}  // namespace swarmanoid::bindings
