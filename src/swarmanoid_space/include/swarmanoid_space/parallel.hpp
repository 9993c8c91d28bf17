/// The threads of a simulation, for plugins with much parallel work.
///
/// Threads  may be used in the phases in which the plugin is called, from the calling thread. Data that the work of one
///          range writes must not be read or written by any other range.
/// Repeats  the partition into ranges depends on the number of threads, and the assignment of ranges to threads on
///          chance. Results must depend on neither.
#pragma once

#include <cstddef>

namespace swarmanoid {

class Parallel {
 public:
  Parallel() = default;
  virtual ~Parallel() = default;
  Parallel(const Parallel&) = delete;
  Parallel& operator=(const Parallel&) = delete;

  /// Number of threads, including the caller's.
  virtual std::size_t threads() const = 0;

  /// Calls work(first, last) on disjoint ranges that cover 0 .. count - 1, each of at least half of `grain`; with one
  /// thread, or for count <= grain, once on the caller's thread. Ranges are of equal size. As a rule each thread gets
  /// the ranges that it had the last time, which are in its cache.
  template <class Work>
  void forRanges(std::size_t count, std::size_t grain, const Work& work) const {
    if (threads() == 1 || count <= grain) {
      work(std::size_t{0}, count);
      return;
    }
    runRanges(count, grain, &work, [](const void* each, std::size_t first, std::size_t last) {
      (*static_cast<const Work*>(each))(first, last);
    });
  }

  /// Calls work(k) for k = 0 .. count - 1. For few items of unequal duration: a thread that is done takes the next one.
  template <class Work>
  void forEach(std::size_t count, const Work& work) const {
    if (threads() > 1 && count > 1) {
      runEach(count, &work, [](const void* each, std::size_t first, std::size_t last) {
        callEach(*static_cast<const Work*>(each), first, last);
      });
    } else {
      callEach(work, 0, count);
    }
  }

 protected:
  using Call = void (*)(const void* work, std::size_t first, std::size_t last);

  virtual void runRanges(std::size_t count, std::size_t grain, const void* work, Call call) const = 0;
  virtual void runEach(std::size_t count, const void* work, Call call) const = 0;

 private:
  template <class Work>
  static void callEach(const Work& work, std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      work(k);
    }
  }
};

}  // namespace swarmanoid
