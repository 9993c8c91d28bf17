/// The threads of a simulation, for plugins that have much to do at once.
///
/// Threads  may be used in the phases in which the plugin is called, from the thread that calls it. Whatever the work
///          of a range writes, no other range may read or write.
/// Repeats  how ranges are cut depends on the threads and on chance: results must not.
#pragma once

#include <cstddef>

namespace swarmanoid {

class Parallel {
 public:
  Parallel() = default;
  virtual ~Parallel() = default;
  Parallel(const Parallel&) = delete;
  Parallel& operator=(const Parallel&) = delete;

  /// Calls work(first, last) on disjoint ranges that cover 0 .. count - 1, of at least `grain` but for the last ones;
  /// with one thread, and for up to `grain`, once and on the caller's thread.
  template <class Work>
  void forRanges(std::size_t count, std::size_t grain, const Work& work) const {
    if (isSerial() || count <= grain) {
      work(std::size_t{0}, count);
      return;
    }
    run(count, grain, &work,
        [](const void* each, std::size_t first, std::size_t last) { (*static_cast<const Work*>(each))(first, last); });
  }

 protected:
  using Call = void (*)(const void* work, std::size_t first, std::size_t last);

  virtual bool isSerial() const = 0;
  virtual void run(std::size_t count, std::size_t grain, const void* work, Call call) const = 0;
};

}  // namespace swarmanoid
