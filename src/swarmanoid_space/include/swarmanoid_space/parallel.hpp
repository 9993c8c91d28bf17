/// The threads of a simulation, for plugins that have much to do at once.
///
/// Threads  may be used in the phases in which the plugin is called, from the thread that calls it. Whatever the work
///          of a range writes, no other range may read or write.
/// Repeats  how ranges are cut depends on the threads, and who does what on chance: results must not.
#pragma once

#include <cstddef>

namespace swarmanoid {

class Parallel {
 public:
  Parallel() = default;
  virtual ~Parallel() = default;
  Parallel(const Parallel&) = delete;
  Parallel& operator=(const Parallel&) = delete;

  /// How many there are, that of the caller included.
  virtual std::size_t threads() const = 0;

  /// Calls work(first, last) on disjoint ranges that cover 0 .. count - 1, of half of `grain` or more; with one thread,
  /// and for up to `grain`, once and on the caller's thread. Ranges are equal, and as a rule each thread gets those
  /// that it had the last time, and has in its cache.
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

  /// Calls work(k) for 0 .. count - 1, for few that take unequal times: a thread that is done takes another one.
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
