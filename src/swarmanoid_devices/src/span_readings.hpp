/// Sensors with as many readings as the robot has parts: the readings are a span, whose elements the instance keeps.
#pragma once

#include <cstddef>
#include <vector>

#include "swarmanoid_interface/span.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {

template <class Device, class Element>
struct SpanReadings : BasicSensorInstance<Device> {
  std::vector<Element> buffer;

  /// @return the elements, at rest, which stay where they are when the instance moves
  Span<const Element> makeRoom(std::size_t count) {
    buffer.resize(count);
    return buffer;
  }
};

}  // namespace swarmanoid::devices
