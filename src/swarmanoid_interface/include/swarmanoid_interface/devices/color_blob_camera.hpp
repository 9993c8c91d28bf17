/// Sensors: cameras that report blobs of colour instead of images, as the robots' own image filter does (thesis 3.3).
///
/// The cameras are those of thesis 1.3: omnidirectional cameras of footbots and eyebots, the downward camera of
/// eyebots, and cameras with a lens of all three robots. Angles of view and ranges are typical of small cameras of 640
/// x 480 pixels.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "swarmanoid_interface/arctangent.hpp"
#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/span.hpp"

namespace swarmanoid {

/// One blob: a lit LED or lamp, a prey, a laser spot or a coloured floor patch. Directions are from the camera to the
/// blob, in an upright frame with the heading of the robot's x axis, wherever the camera looks.
struct ColorBlob {
  Color color;
  float bearing = 0.0F;    ///< direction [rad], counter-clockwise from ahead, in (-pi, pi]
  float distance = 0.0F;   ///< horizontal distance from the camera's vertical axis [m]; NaN: not measured
  float elevation = 0.0F;  ///< direction over the camera's horizon [rad], negative below, from -pi/2 to pi/2
  float size = 0.0F;       ///< angle that the source takes in the picture, from edge to edge [rad]

  /// Angular size of a ball or disc that is fully visible: 2 atan(radius / way). @param radius [m] @param way distance
  /// from the camera to the centre [m] @return [rad]
  static float sizeOf(float radius, float way) { return 2.0F * arctangent(radius, way); }

  /// Radius of LEDs, lamps and laser spots [m].
  static constexpr double kPointRadius = 0.005;
};

template <class Visitor>
void fields(Visitor& visit, ColorBlob& blob) {
  visit(blob.color, {"color", "", "of the blob"});
  visit(blob.bearing,
        {"bearing", "rad", "direction in the robot's frame, counter-clockwise from ahead", {-M_PI, M_PI}, true});
  visit(blob.distance,
        orUnknown(
            {"distance", "m", "horizontal, from the camera's vertical axis; NaN if it cannot know", {0.0, kInfinity}}));
  visit(blob.elevation, {"elevation", "rad", "direction over the camera's horizon", {-M_PI_2, M_PI_2}});
  visit(blob.size, {"size", "rad", "angle that the blob subtends", {0.0, kInfinity}});
}

/// The reading of a colour-blob camera in this tick. Omnidirectional and downward cameras measure distances; cameras
/// with a lens report NaN instead, which is how REP-117 marks a missing measurement. LEDs on the far side of their
/// own robot are hidden. Blobs come in the order of their sources: entities by number (the LEDs of one entity by LED
/// number), then laser spots, then floor patches. If more blobs are in sight than the camera reports, the nearest are
/// reported, in the same order. The span is valid until the next tick.
struct ColorBlobs {
  Span<const ColorBlob> blobs;
  bool overflowed = false;  ///< more blobs in sight than reported; the farthest are left out (and an event reports it)
};

/// Describes the fields of all cameras.
template <class Visitor>
void fields(Visitor& visit, ColorBlobs& camera) {
  visit(camera.blobs, {"blobs"});
  visit(camera.overflowed, {"overflowed", "", "more blobs were in sight than reported; the farthest are left out"});
}

/// The footbot's omnidirectional camera ("pie camera").
struct FootbotCamera : ColorBlobs {
  static constexpr const char* kType = "footbot_camera";
  static constexpr const char* kRobot = "footbot";
  static constexpr double kUsualRange = 2.0;  ///< maximum horizontal distance [m]
  static constexpr double kMount = 0.28;      ///< height of the camera in the robot's frame [m]
};

REGISTER_DEVICE_OF_SUITE(FootbotCamera, kSensor, "An omnidirectional camera that reports blobs of colour.")

/// The eyebot's camera, which looks down: its field of view is a circle on the ground under the robot.
struct EyebotCamera : ColorBlobs {
  static constexpr const char* kType = "eyebot_camera";
  static constexpr const char* kRobot = "eyebot";
  static constexpr double kUsualRange = 10.0;           ///< maximum horizontal distance [m]
  static constexpr double kUsualAperture = M_PI / 4.0;  ///< half the opening angle of its cone [rad]
  static constexpr double kMount = 0.15;                ///< height of the camera in the robot's frame [m]
};

REGISTER_DEVICE_OF_SUITE(EyebotCamera, kSensor, "A camera that looks down into a cone and reports blobs of colour.")

/// The eyebot's omnidirectional camera, on its mast: it sees in all directions and at any height, other eyebots too.
struct EyebotOmnidirectionalCamera : ColorBlobs {
  static constexpr const char* kType = "eyebot_omnidirectional_camera";
  static constexpr const char* kRobot = "eyebot";
  static constexpr double kUsualRange = 10.0;  ///< maximum horizontal distance [m]
  static constexpr double kMount = 0.42;       ///< height of the camera in the robot's frame [m]
};

REGISTER_DEVICE_OF_SUITE(EyebotOmnidirectionalCamera, kSensor,
                         "A camera that sees all around at any height and reports blobs of colour.")

/// Field of view of a camera with a lens: a pyramid around its optical axis.
class Picture {
 public:
  static constexpr double kUsualWidth = M_PI / 3.0;   ///< [rad]
  static constexpr double kUsualHeight = M_PI / 4.0;  ///< [rad]

  /// @param width angle from the left edge to the right one [rad], less than pi @param height angle from the lower edge
  /// to the upper one [rad], less than pi
  explicit Picture(double width = kUsualWidth, double height = kUsualHeight)
      : across_(std::tan(0.5 * width)), up_(std::tan(0.5 * height)) {}

  /// @param seen a point in the camera's frame, which looks along x, y to the left, z up
  bool shows(const Eigen::Vector3d& seen) const {
    return seen.x() > 0.0 && std::abs(seen.y()) <= across_ * seen.x() && std::abs(seen.z()) <= up_ * seen.x();
  }
  /// Distances of the edges from the middle of the picture, at a distance of 1.
  double across() const { return across_; }
  double up() const { return up_; }

 private:
  double across_;
  double up_;
};

/// The eyebot's camera that is panned and tilted (EyebotPanTilt). Its blobs have directions in the robot's frame, and
/// no distance.
struct EyebotPanTiltCamera : ColorBlobs {
  static constexpr const char* kType = "eyebot_pan_tilt_camera";
  static constexpr const char* kRobot = "eyebot";
  static constexpr double kUsualRange = 10.0;                       ///< maximum horizontal distance [m]
  static constexpr std::array<double, 3> kMount{0.085, 0.0, 0.17};  ///< in the robot's frame [m]
};

REGISTER_DEVICE_OF_SUITE(EyebotPanTiltCamera, kSensor,
                         "A camera that is panned and tilted and reports blobs of colour.")

/// The footbot's camera that looks ahead, for objects near its gripper. Its blobs have no distance.
struct FootbotFrontCamera : ColorBlobs {
  static constexpr const char* kType = "footbot_front_camera";
  static constexpr const char* kRobot = "footbot";
  static constexpr double kUsualRange = 2.0;                       ///< maximum horizontal distance [m]
  static constexpr std::array<double, 3> kMount{0.08, 0.0, 0.09};  ///< in the robot's frame [m]
};

REGISTER_DEVICE_OF_SUITE(FootbotFrontCamera, kSensor, "A camera that looks ahead and reports blobs of colour.")

/// The handbot's camera, in its head, which looks ahead. Its blobs have no distance.
struct HandbotCamera : ColorBlobs {
  static constexpr const char* kType = "handbot_camera";
  static constexpr const char* kRobot = "handbot";
  static constexpr double kUsualRange = 3.0;                        ///< maximum horizontal distance [m]
  static constexpr std::array<double, 3> kMount{0.105, 0.0, 0.16};  ///< in the robot's frame [m]
};

REGISTER_DEVICE_OF_SUITE(HandbotCamera, kSensor, "A camera in the head that looks ahead and reports blobs of colour.")

}  // namespace swarmanoid
