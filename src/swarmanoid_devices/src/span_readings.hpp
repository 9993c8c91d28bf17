/// Sensors with as many readings as the robot has parts, or as there is something to report: the readings are a span,
/// whose elements the instance keeps.
#pragma once

#include <cstddef>
#include <vector>

#include "swarmanoid_interface/span.hpp"

namespace swarmanoid::devices {

/// @tparam Instance of the sensor, but for its elements
template <class Instance, class Element>
struct SpanReadings : Instance {
  std::vector<Element> buffer;

  /// @return the elements, at rest, which stay where they are when the instance moves
  Span<const Element> makeRoom(std::size_t count) {
    buffer.resize(count);
    return buffer;
  }
};

}  // namespace swarmanoid::devices
