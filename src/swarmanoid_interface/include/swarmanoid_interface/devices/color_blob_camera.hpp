/// Sensors: cameras that report blobs of colour instead of images, as the robots' own image filter does (thesis 3.3).
#pragma once

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/span.hpp"

namespace swarmanoid {

/// One blob: a lit LED, a prey, a laser spot or a coloured floor patch.
struct ColorBlob {
  Color color;
  float bearing = 0.0F;   ///< direction in the robot's frame [rad], counter-clockwise from ahead, in (-pi, pi]
  float distance = 0.0F;  ///< horizontal distance from the camera's vertical axis [m]
};

/// What a colour-blob camera saw this tick. LEDs on the far side of their own robot are hidden. Blobs come in the order
/// of what they belong to: entities by number (the LEDs of one by theirs), then laser spots, then floor patches. If
/// more is in sight than the camera reports, the nearest are reported, in the same order. The span is valid until the
/// next tick.
struct ColorBlobs {
  Span<const ColorBlob> blobs;
  bool overflowed = false;  ///< more was in sight than is reported; the farthest is left out (and an event says so)
};

/// The footbot's omnidirectional camera ("pie camera").
struct FootbotCamera : ColorBlobs {
  static constexpr const char* kType = "footbot_camera";
};

/// The eyebot's camera, looking down: what it sees lies in a circle on the ground under the robot.
struct EyebotCamera : ColorBlobs {
  static constexpr const char* kType = "eyebot_camera";
};

}  // namespace swarmanoid
