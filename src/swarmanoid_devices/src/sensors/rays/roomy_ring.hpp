/// Rings with as many sensors as the robot has: their readings are spans of values and bearings of the sensors, in a
/// buffer of the instance.
#pragma once

#include <cmath>

#include "common/span_readings.hpp"
#include "ring_geometry.hpp"
#include "surroundings/color_blob_finder.hpp"

namespace swarmanoid::devices {

/// An instance of a ring with a buffer for the readings of all its sensors. @tparam Reading has `value` and `angle`
template <class Instance, class Reading>
struct RoomyInstance : SpanReadings<Instance, Reading> {
  void archive(StateArchive& state) { SpanReadings<Instance, Reading>::archive(state); }
  /// @pre the ring is set
  void makeRoomForRing() {
    this->readings->sensors = this->makeRoom(this->ring->size());
    for (Eigen::Index i = 0; i < this->ring->direction.cols(); ++i) {
      const Eigen::Vector3d direction = this->ring->direction.col(i);
      this->buffer[static_cast<std::size_t>(i)].angle = toBearing(std::atan2(direction.y(), direction.x()));
    }
  }
};

}  // namespace swarmanoid::devices
