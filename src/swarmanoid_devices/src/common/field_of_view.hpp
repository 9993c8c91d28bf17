/// Field of view of a camera, as one of a few shapes: all around, a cone below, or a pyramid around the optical axis.
/// Another shape is another class here. The maximum range is not part of it.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/random.hpp"
#include "swarmanoid_space/device_drawing.hpp"

namespace swarmanoid::devices {

/// Pose of a camera at this tick.
struct Eye {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< in W [m]
  Eigen::Vector2d forward = Eigen::Vector2d::UnitX();  ///< the robot's x axis seen from above, in W, of length 1
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< of the camera frame in W; x is the optical axis
  double height = 0.0;                                              ///< above the ground [m]
};

class FieldOfView {
 public:
  virtual ~FieldOfView() = default;

  /// @param way from the camera to a point, in W [m] @param horizontal horizontal length of `way` [m]
  virtual bool contains(const Eye& eye, const Eigen::Vector3d& way, double horizontal) const = 0;
  /// Whether it contains every point.
  virtual bool isAll() const { return false; }
  /// Whether the position of a blob in the picture determines its distance.
  virtual bool knowsDistance() const { return true; }
  /// Draws a random way within view, for a false blob. @param range [m] @return from the camera, in W [m]
  virtual Eigen::Vector3d drawWay(const Eye& eye, double range, RandomStream& random) const = 0;
  /// Draws the outline of the field of view up to a range [m].
  virtual void draw(const Eye& eye, double range, DeviceDrawing& drawing) const = 0;

 protected:
  static Eigen::Vector3d below(const Eye& eye) {
    return {eye.position.x(), eye.position.y(), eye.position.z() - eye.height};
  }
  /// Draws the way to a point of the ground around the camera, uniformly distributed over the disc.
  static Eigen::Vector3d drawOnGround(const Eye& eye, double radius, RandomStream& random) {
    const double bearing = random.uniform(-M_PI, M_PI);
    const double distance = radius * std::sqrt(random.uniform());
    return {distance * std::cos(bearing), distance * std::sin(bearing), -eye.height};
  }
};

/// All around, at any height: a camera that looks into a mirror.
class RingView final : public FieldOfView {
 public:
  bool contains(const Eye& /*eye*/, const Eigen::Vector3d& /*way*/, double /*horizontal*/) const override {
    return true;
  }
  bool isAll() const override { return true; }
  Eigen::Vector3d drawWay(const Eye& eye, double range, RandomStream& random) const override {
    return drawOnGround(eye, range, random);
  }
  void draw(const Eye& eye, double range, DeviceDrawing& drawing) const override {
    drawing.circle(below(eye), range * Eigen::Vector3d::UnitX(), range * Eigen::Vector3d::UnitY(),
                   DeviceDrawing::kOutline);
  }
};

/// An upright cone below the camera, independent of its tilt.
class ConeView final : public FieldOfView {
 public:
  ConeView() = default;
  /// @param aperture half its opening angle [rad]
  explicit ConeView(double aperture) : slope_(std::tan(aperture)) {}

  bool contains(const Eye& /*eye*/, const Eigen::Vector3d& way, double horizontal) const override {
    return horizontal <= slope_ * -way.z();
  }
  Eigen::Vector3d drawWay(const Eye& eye, double range, RandomStream& random) const override {
    return drawOnGround(eye, radiusOnGround(eye, range), random);
  }
  void draw(const Eye& eye, double range, DeviceDrawing& drawing) const override {
    const double radius = radiusOnGround(eye, range);
    drawing.cone(eye.position, below(eye), radius * Eigen::Vector3d::UnitX(), radius * Eigen::Vector3d::UnitY(),
                 DeviceDrawing::kOutline);
  }

 private:
  double radiusOnGround(const Eye& eye, double range) const {
    return std::min(range, slope_ * std::max(0.0, eye.height));
  }

  double slope_ = 1.0;
};

/// The picture of a camera with a lens.
class PyramidView final : public FieldOfView {
 public:
  PyramidView() = default;
  explicit PyramidView(const Picture& picture) : picture_(picture) {}

  bool contains(const Eye& eye, const Eigen::Vector3d& way, double /*horizontal*/) const override {
    return picture_.shows(eye.orientation.conjugate() * way);
  }
  bool knowsDistance() const override { return false; }
  Eigen::Vector3d drawWay(const Eye& eye, double range, RandomStream& random) const override {
    const double across = picture_.across() * random.uniform(-1.0, 1.0);
    const double up = picture_.up() * random.uniform(-1.0, 1.0);
    const double length = range * (1.0 - random.uniform());
    return length * (eye.orientation * Eigen::Vector3d(1.0, across, up).normalized());
  }
  void draw(const Eye& eye, double range, DeviceDrawing& drawing) const override {
    const auto corner = [&](double across, double up) {
      return Eigen::Vector3d(eye.position + range * (eye.orientation * Eigen::Vector3d(1.0, across, up).normalized()));
    };
    const double across = picture_.across();
    const double up = picture_.up();
    const std::array corners{corner(across, up), corner(-across, up), corner(-across, -up), corner(across, -up)};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      drawing.line(eye.position, corners[i], DeviceDrawing::kOutline);
      drawing.line(corners[i], corners[(i + 1) % corners.size()], DeviceDrawing::kOutline);
    }
  }

 private:
  Picture picture_;
};

}  // namespace swarmanoid::devices
