/// Detects whether entities were added or deleted since the last call, so that lists of rows are rebuilt only then.
#pragma once

#include <cstdint>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

class Population {
 public:
  /// @return whether entities were added or deleted since the last call; true in the first call
  bool hasChanged(const Space& space) {
    const Entities& entities = space.entities;
    const bool is_empty = entities.order.empty();
    // numbers only grow in a run: an equal last number means no additions, and an equal size then means no deletions
    const Population now{space.run + 1, entities.size(), is_empty ? kNoEntity : entities.number[entities.order.back()]};
    const bool has_changed = now.run_ != run_ || now.size_ != size_ || now.last_ != last_;
    *this = now;
    return has_changed;
  }

  Population() = default;

 private:
  Population(std::uint64_t run, std::size_t size, EntityNumber last) : run_(run), size_(size), last_(last) {}

  std::uint64_t run_ = 0;  // Space::run + 1; 0: not called yet
  std::size_t size_ = 0;
  EntityNumber last_ = kNoEntity;
};

}  // namespace swarmanoid::devices
