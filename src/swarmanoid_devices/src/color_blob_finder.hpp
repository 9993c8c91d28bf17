/// Finds the blobs that a colour-blob camera has in sight: lit LEDs, coloured preys, laser spots and floor patches,
/// unless another entity or the robot that carries the LED (hiddenLeds) is in between. All cameras share it; they
/// differ in the result of `inView`.
#pragma once

#include <cstddef>

#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// A surface this near to the point looked at is the point's own surface, not an obstacle (fraction of the way).
constexpr double kOwnSurface = 1e-6;

/// Converts an angle to the form of ColorBlob, in (-pi, pi] [rad].
float toBearing(double angle);

/// One camera of one robot, at this tick.
struct BlobView {
  Row self = kNoRow;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of the camera, in W [m]
  double heading = 0.0;                                ///< of the robot's x axis in W [rad]
  double range = 0.0;                                  ///< maximum horizontal distance of a blob [m]
  double slope = 0.0;  ///< blobs are in the cone below the camera: horizontal <= slope * depth; 0: no cone
  bool sees_floor = false;

  bool inView(const Eigen::Vector3d& point) const;
};

struct FoundBlobs {
  std::size_t count = 0;    ///< number of blobs that were written
  bool overflowed = false;  ///< more blobs were in sight than the capacity
};

/// Fills `blobs` (room for `capacity`) in the order defined by ColorBlobs. If more are in sight the nearest are kept,
/// by horizontal distance; of equally near ones the first in that order. Thread-safe.
FoundBlobs findBlobs(const Space& space, const BlobView& view, ColorBlob* blobs, std::size_t capacity);

}  // namespace swarmanoid::devices
