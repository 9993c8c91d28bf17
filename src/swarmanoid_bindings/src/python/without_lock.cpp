#include "without_lock.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace py = pybind11;

namespace swarmanoid::bindings {
namespace {

constexpr std::chrono::seconds kLongestTick{10};  ///< maximum wait at the end of Python

struct Ticks {
  std::mutex mutex;
  std::condition_variable changed;
  int under_way = 0;
  std::atomic<bool> is_ending{false};
  std::thread::id ending;  ///< the thread that ends Python, which may still tick
};

/// Never destroyed: threads may wait on its members while the process ends.
Ticks& ticks() {
  static auto* const kTicks = new Ticks;
  return *kTicks;
}

/// Nesting depth of this thread: a Python controller may tick another simulation.
thread_local int depth = 0;

void endTicks() {
  const py::gil_scoped_release unlocked;
  std::unique_lock<std::mutex> lock(ticks().mutex);
  ticks().ending = std::this_thread::get_id();
  ticks().is_ending = true;
  ticks().changed.wait_for(lock, kLongestTick, [] { return ticks().under_way == 0; });
}

}  // namespace

WithoutLock::WithoutLock() {
  unlocked_.emplace();
  std::unique_lock<std::mutex> lock(ticks().mutex);
  ticks().changed.wait(lock, [] { return depth > 0 || !mustEnd(); });  // without end while Python ends
  ++ticks().under_way;
  ++depth;
}

WithoutLock::~WithoutLock() {
  unlocked_.reset();  // reacquires the GIL before under_way falls: endTicks waits for this thread meanwhile
  const std::lock_guard<std::mutex> lock(ticks().mutex);
  --depth;
  --ticks().under_way;
  ticks().changed.notify_all();
}

bool WithoutLock::mustEnd() { return ticks().is_ending && ticks().ending != std::this_thread::get_id(); }

void waitForTicksAtExit() { py::module_::import("atexit").attr("register")(py::cpp_function(&endTicks)); }

}  // namespace swarmanoid::bindings
