/// Sensors with a variable number of readings, one for each part of the robot or for each detection: the readings are a
/// span over a buffer of the instance.
#pragma once

#include <cstddef>
#include <vector>

#include "swarmanoid_interface/span.hpp"
#include "swarmanoid_space/archive_device.hpp"

namespace swarmanoid::devices {

/// @tparam Instance instance of the sensor without the buffer
template <class Instance, class Element>
struct SpanReadings : Instance {
  std::vector<Element> buffer;

  /// @return the elements, with default values; their addresses stay valid when the instance is moved
  Span<const Element> makeRoom(std::size_t count) {
    buffer.resize(count);
    return buffer;
  }

  /// For snapshots.
  void archive(StateArchive& state) {
    if constexpr (StateArchive::kIsDefinedBy<Instance>) {
      Instance::archive(state);
    }
    archiveSpan(state, *this->readings, buffer);
  }
};

}  // namespace swarmanoid::devices
