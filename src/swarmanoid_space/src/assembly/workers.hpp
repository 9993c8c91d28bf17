/// The threads of a simulation (oneTBB). With one thread everything runs on the caller's, without any library in
/// between.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <memory>

namespace swarmanoid {

class Workers {
 public:
  explicit Workers(int threads) {
    if (threads > 1) {
      // without this there would be no more threads than cores, whatever was asked for
      limit_ = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                     static_cast<std::size_t>(threads));
      arena_ = std::make_unique<tbb::task_arena>(threads);
    }
  }

  /// Calls work(first, last) on disjoint ranges that cover 0 .. count - 1. The split must not change results.
  template <class Work>
  void forRanges(std::size_t count, std::size_t grain, Work work) const {
    if (!arena_ || count <= grain) {
      work(std::size_t{0}, count);
      return;
    }
    arena_->execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                        [&](const tbb::blocked_range<std::size_t>& range) { work(range.begin(), range.end()); });
    });
  }

 private:
  std::unique_ptr<tbb::global_control> limit_;
  std::unique_ptr<tbb::task_arena> arena_;
};

}  // namespace swarmanoid
