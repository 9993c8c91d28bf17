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

#include "swarmanoid_space/parallel.hpp"

namespace swarmanoid {

class Workers final : public Parallel {
 public:
  explicit Workers(int threads) {
    if (threads > 1) {
      // without this there would be no more threads than cores, whatever was asked for
      limit_ = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                     static_cast<std::size_t>(threads));
      arena_ = std::make_unique<tbb::task_arena>(threads);
    }
  }

 private:
  bool isSerial() const override { return arena_ == nullptr; }
  void run(std::size_t count, std::size_t grain, const void* work, Call call) const override {
    const tbb::blocked_range<std::size_t> all(0, count, grain);
    const auto body = [&](const tbb::blocked_range<std::size_t>& range) { call(work, range.begin(), range.end()); };
    // Of many equal parts each thread gets those in each phase and tick that it had in the one before, and has in its
    // cache. Few parts, such as engines, are unequal: who is done takes another one.
    constexpr std::size_t kMany = 8;
    const bool are_many = count >= kMany * grain;
    // isolated: a thread that waits for the end of an engine's own ranges does not begin with another engine meanwhile
    arena_->execute([&] {
      tbb::this_task_arena::isolate([&] {
        if (are_many) {
          tbb::parallel_for(all, body, tbb::static_partitioner());
        } else {
          tbb::parallel_for(all, body);
        }
      });
    });
  }

  std::unique_ptr<tbb::global_control> limit_;
  std::unique_ptr<tbb::task_arena> arena_;
};

}  // namespace swarmanoid
