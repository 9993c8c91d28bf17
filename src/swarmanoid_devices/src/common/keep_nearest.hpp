/// Selection of the nearest results, for sensors with a limited number of readings; the order is kept.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace swarmanoid::devices {

/// Keeps the `capacity` nearest elements, in their order; ties go to the first. Allocates nothing.
/// @param found elements with `place`, their rank in the order @param distance_of distance of an element, in any unit
/// @return whether elements were removed
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
