// An eyebot that flies with the commanded velocity, between ground and ceiling.
#include <algorithm>
#include <cmath>

#include "mock_robot.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/eyebot_laser.hpp"
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid::mock {
namespace {

class MockEyebot final : public MockRobot {
 public:
  MockEyebot(World world, Pose start) : MockRobot(std::move(world), std::move(start)) {
    provideSensor(camera_);
    provideSensor(magnet_state_);
    provideActuator(velocity_);
    provideActuator(laser_);
    provideActuator(magnet_);
    provideActuator(leds_);
    sense();
  }

 private:
  static constexpr double kHeight = 0.54;  // [m] from where it stands to its magnet

  void move(double dt) override {
    constexpr double kFastest = 1.0;  // [m/s]
    constexpr double kTouch = 1e-3;   // [m]
    const double top = std::max(0.0, world_.ceiling - kHeight);
    is_attached_ = magnet_.on && (is_attached_ || pose_.position.z() >= top - kTouch);
    twist_.linear = is_attached_ ? Eigen::Vector3d(0.0, 0.0, 0.0) : velocity_.linear;
    twist_.yaw_rate = is_attached_ ? 0.0 : velocity_.yaw_rate;
    if (twist_.linear.norm() > kFastest) {
      twist_.linear *= kFastest / twist_.linear.norm();
    }
    const double before = pose_.position.z();
    pose_.position = pose_.toWorld(twist_.linear * dt);
    pose_.position.z() = std::clamp(pose_.position.z(), 0.0, top);
    if (dt > 0.0) {
      twist_.linear.z() = (pose_.position.z() - before) / dt;
    }
    pose_.yaw = wrapAngle(pose_.yaw + twist_.yaw_rate * dt);
  }

  void sense() override {
    blobs_.clear();
    for (const Beacon& beacon : world_.beacons) {
      look(beacon);
    }
    if (laser_.on) {
      constexpr double kLaser = 0.15;  // [m] above where it stands
      const double distance = (pose_.position.z() + kLaser) * std::tan(laser_.tilt);
      Eigen::Vector3d spot = pose_.toWorld({distance * std::cos(laser_.pan), distance * std::sin(laser_.pan), 0.0});
      spot.z() = 0.0;
      look({"spot", spot, colors::kRed});
    }
    camera_.blobs = blobs_;
    magnet_state_.attached = is_attached_;
  }

  void look(const Beacon& beacon) {
    constexpr double kSlope = 1.0;  // the camera sees a cone with half an angle of 45 degrees
    const ColorBlob blob = blobOf(beacon, pose_);
    if (static_cast<double>(blob.distance) <= kSlope * (pose_.position.z() - beacon.at.z())) {
      blobs_.push_back(blob);
    }
  }

  EyebotVelocity velocity_;
  EyebotLaser laser_;
  EyebotMagnet magnet_;
  EyebotLeds leds_;
  EyebotCamera camera_;
  EyebotMagnetState magnet_state_;
  std::vector<ColorBlob> blobs_;
  bool is_attached_ = false;
};

}  // namespace

std::unique_ptr<MockRobot> makeMockEyebot(World world, Pose start) {
  return std::make_unique<MockEyebot>(std::move(world), std::move(start));
}

}  // namespace swarmanoid::mock
