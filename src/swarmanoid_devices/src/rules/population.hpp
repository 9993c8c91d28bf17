/// Whether others are in the space than when somebody looked last: then lists of rows are to be made anew, and else
/// not.
#pragma once

#include <cstdint>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

class Population {
 public:
  /// @return whether anybody has come or gone since it was asked last; at first, yes
  bool hasChanged(const Space& space) {
    const Entities& entities = space.entities;
    const bool is_empty = entities.order.empty();
    // numbers only grow in a run: if the last is the same nobody has come, and if as many are there nobody has gone
    const Population now{space.run + 1, entities.size(), is_empty ? kNoEntity : entities.number[entities.order.back()]};
    const bool has_changed = now.run_ != run_ || now.size_ != size_ || now.last_ != last_;
    *this = now;
    return has_changed;
  }

  Population() = default;

 private:
  Population(std::uint64_t run, std::size_t size, EntityNumber last) : run_(run), size_(size), last_(last) {}

  std::uint64_t run_ = 0;  // one more than the space's; 0: it was not asked yet
  std::size_t size_ = 0;
  EntityNumber last_ = kNoEntity;
};

}  // namespace swarmanoid::devices
