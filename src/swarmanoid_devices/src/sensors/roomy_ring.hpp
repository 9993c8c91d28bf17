/// What rings with as many sensors as the robot has have in common: their readings are spans of values with the angles
/// in which the sensors look, and stand in a buffer of the instance.
#pragma once

#include <cmath>
#include <vector>

#include "color_blob_finder.hpp"
#include "ring_geometry.hpp"

namespace swarmanoid::devices {

/// An instance of a ring with room for the readings of all its sensors. @tparam Reading has `value` and `angle`
template <class Instance, class Reading>
struct RoomyInstance : Instance {
  std::vector<Reading> buffer;

  /// @pre the ring is known
  void makeRoom() {
    for (Eigen::Index i = 0; i < this->ring->direction.cols(); ++i) {
      const Eigen::Vector3d direction = this->ring->direction.col(i);
      buffer.push_back({0.0F, toBearing(std::atan2(direction.y(), direction.x()))});
    }
    // the buffer stays where it is when the instance moves
    this->readings->sensors = Span<const Reading>(buffer.data(), buffer.size());
  }
};

}  // namespace swarmanoid::devices
