/// What a colour-blob camera has in sight: lit LEDs, coloured preys, laser spots and floor patches, if nothing stands
/// between: neither anything else nor the robot that carries the LED (hiddenLeds). Shared by all cameras; they differ
/// in what `inView` says.
#pragma once

#include <cstddef>

#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// An angle as ColorBlob has it, in (-pi, pi] [rad].
float toBearing(double angle);

/// One camera of one robot, at this tick.
struct BlobView {
  Row self = kNoRow;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of the camera, in W [m]
  double heading = 0.0;                                ///< of the robot's x axis in W [rad]
  double range = 0.0;                                  ///< nothing is seen further away than this, horizontally [m]
  double slope = 0.0;  ///< nothing is seen outside the cone below: horizontal <= slope * depth; 0: no cone
  bool sees_floor = false;

  bool inView(const Eigen::Vector3d& point) const;
};

struct FoundBlobs {
  std::size_t count = 0;    ///< of the blobs that were filled in
  bool overflowed = false;  ///< more were in sight than there was room for
};

/// Fills `blobs` (room for `capacity`) in the order that ColorBlobs promises. Of more the nearest are kept, as seen
/// from above; of equally near ones those that come first in that order. Thread-safe.
FoundBlobs findBlobs(const Space& space, const BlobView& view, ColorBlob* blobs, std::size_t capacity);

}  // namespace swarmanoid::devices
