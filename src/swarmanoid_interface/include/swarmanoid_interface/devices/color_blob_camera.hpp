/// Sensors: cameras that report blobs of colour instead of images, as the robots' own image filter does (thesis 3.3).
#pragma once

#include <cmath>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/span.hpp"

namespace swarmanoid {

/// One blob: a lit LED, a prey, a laser spot or a coloured floor patch.
struct ColorBlob {
  Color color;
  float bearing = 0.0F;   ///< direction in the robot's frame [rad], counter-clockwise from ahead, in (-pi, pi]
  float distance = 0.0F;  ///< horizontal distance from the camera's vertical axis [m]
};

template <class Visitor>
void fields(Visitor& visit, ColorBlob& blob) {
  visit(blob.color, {"color", "", "of the thing that is seen"});
  visit(blob.bearing,
        {"bearing", "rad", "direction in the robot's frame, counter-clockwise from ahead", {-M_PI, M_PI}, true});
  visit(blob.distance, {"distance", "m", "horizontal, from the camera's vertical axis", {0.0, kInfinity}});
}

/// The reading of a colour-blob camera in this tick. LEDs on the far side of their own robot are hidden. Blobs come in
/// the order of their sources: entities by number (the LEDs of one entity by LED number), then laser spots, then floor
/// patches. If more blobs are in sight than the camera reports, the nearest are reported, in the same order. The span
/// is valid until the next tick.
struct ColorBlobs {
  Span<const ColorBlob> blobs;
  bool overflowed = false;  ///< more was in sight than is reported; the farthest is left out (and an event reports it)
};

/// Describes the fields of both cameras.
template <class Visitor>
void fields(Visitor& visit, ColorBlobs& camera) {
  visit(camera.blobs, {"blobs"});
  visit(camera.overflowed, {"overflowed", "", "more was in sight than is reported; what is farthest is left out"});
}

/// The footbot's omnidirectional camera ("pie camera").
struct FootbotCamera : ColorBlobs {
  static constexpr const char* kType = "footbot_camera";
  static constexpr const char* kRobot = "footbot";
  static constexpr double kUsualRange = 2.0;  ///< horizontal distance beyond which it sees nothing [m]
};

REGISTER_DEVICE(FootbotCamera, kSensor, "An omnidirectional camera that reports blobs of colour.")

/// The eyebot's camera, which looks down: its field of view is a circle on the ground under the robot.
struct EyebotCamera : ColorBlobs {
  static constexpr const char* kType = "eyebot_camera";
  static constexpr const char* kRobot = "eyebot";
  static constexpr double kUsualRange = 10.0;           ///< horizontal distance beyond which it sees nothing [m]
  static constexpr double kUsualAperture = M_PI / 4.0;  ///< half the opening angle of its cone [rad]
  static constexpr double kMount = 0.15;                ///< height of the camera in the robot's frame [m]
};

REGISTER_DEVICE(EyebotCamera, kSensor, "A camera that looks down into a cone and reports blobs of colour.")

}  // namespace swarmanoid
