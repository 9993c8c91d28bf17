/// Thread pool of a simulation (oneTBB). With one thread all work runs on the caller's thread, without the library.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>

#include "swarmanoid_space/parallel.hpp"

namespace swarmanoid {

class Workers final : public Parallel {
 public:
  explicit Workers(int threads) {
    if (threads > 1) {
      // by default TBB has at most one thread per core, even if more are requested
      limit_ = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                     static_cast<std::size_t>(threads));
      arena_ = std::make_unique<tbb::task_arena>(threads);
    }
  }

  std::size_t threads() const override {
    return arena_ == nullptr ? 1 : static_cast<std::size_t>(arena_->max_concurrency());
  }

 private:
  void runRanges(std::size_t count, std::size_t grain, const void* work, Call call) const override {
    run(tbb::blocked_range<std::size_t>(0, count, grain), work, call, tbb::static_partitioner());
  }
  void runEach(std::size_t count, const void* work, Call call) const override {
    run(tbb::blocked_range<std::size_t>(0, count), work, call, tbb::simple_partitioner());
  }

  /// Repeats TBB's synchronisation between the caller and the ranges with atomics, because ThreadSanitizer does not see
  /// it. Ranges do not synchronise with each other.
  struct Handover {
    std::atomic<bool> has_begun{false};
    std::atomic<unsigned> ended{0};
  };

  /// Runs the ranges isolated: a thread that waits for an engine's inner ranges does not start work of another engine.
  template <class Partitioner>
  void run(const tbb::blocked_range<std::size_t>& all, const void* work, Call call,
           const Partitioner& partitioner) const {
    Handover handover;
    handover.has_begun.store(true, std::memory_order_release);
    const auto body = [&](const tbb::blocked_range<std::size_t>& range) {
      handover.has_begun.load(std::memory_order_acquire);
      call(work, range.begin(), range.end());
      handover.ended.fetch_add(1, std::memory_order_release);
    };
    arena_->execute([&] { tbb::this_task_arena::isolate([&] { tbb::parallel_for(all, body, partitioner); }); });
    handover.ended.load(std::memory_order_acquire);
  }

  std::unique_ptr<tbb::global_control> limit_;
  std::unique_ptr<tbb::task_arena> arena_;
};

}  // namespace swarmanoid
