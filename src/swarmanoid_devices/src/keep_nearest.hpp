/// For sensors that report a limited number of things: the nearest ones, in the order in which they were found.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace swarmanoid::devices {

/// Leaves the nearest; of equally near ones the first. The order stays. Allocates nothing.
/// @param found each has `place`, its rank in their order @param distance_of of one of them, in any unit
/// @return whether some were left out
template <class Found, class DistanceOf>
bool keepNearest(std::vector<Found>& found, std::size_t capacity, DistanceOf distance_of) {
  if (found.size() <= capacity) {
    return false;
  }
  const auto end = found.begin() + static_cast<std::ptrdiff_t>(capacity);
  std::nth_element(found.begin(), end, found.end(), [&](const Found& a, const Found& b) {
    return std::pair(distance_of(a), a.place) < std::pair(distance_of(b), b.place);
  });
  std::sort(found.begin(), end, [](const Found& a, const Found& b) { return a.place < b.place; });
  found.resize(capacity);
  return true;
}

}  // namespace swarmanoid::devices
