// A footbot on flat ground: it drives through walls, but its proximity sensors and its camera depend on its pose.
#include <algorithm>
#include <cmath>

#include "mock_robot.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid::mock {
namespace {

class MockFootbot final : public MockRobot {
 public:
  MockFootbot(World world, Pose start) : MockRobot(std::move(world), std::move(start)) {
    provideSensor(proximity_);
    provideSensor(camera_);
    provideSensor(gripper_state_);
    provideSensor(turret_state_);
    provideActuator(wheels_);
    provideActuator(gripper_);
    provideActuator(turret_);
    provideActuator(leds_);
    sense();
  }

 private:
  void move(double dt) override {
    constexpr double kFastestWheel = 10.3;  // [rad/s]
    FootbotWheels wheels = wheels_;
    wheels.left = std::clamp(wheels.left, -kFastestWheel, kFastestWheel);
    wheels.right = std::clamp(wheels.right, -kFastestWheel, kFastestWheel);
    twist_.linear = {wheels.speed(), 0.0, 0.0};
    twist_.yaw_rate = wheels.turnRate();
    // along the chord of the arc
    const double half_turn = 0.5 * twist_.yaw_rate * dt;
    const double chord = half_turn == 0.0 ? 1.0 : std::sin(half_turn) / half_turn;
    pose_.yaw += half_turn;
    pose_.position = pose_.toWorld(twist_.linear * (dt * chord));
    pose_.yaw = wrapAngle(pose_.yaw + half_turn);
    turn(dt);
    grip();
  }

  void turn(double dt) {
    constexpr double kFastest = 3.0;  // [rad/s]
    double speed = 0.0;
    if (turret_.mode == FootbotTurret::Mode::kAngle && dt > 0.0) {
      speed = wrapAngle(turret_.angle - turret_state_.angle) / dt;
    } else if (turret_.mode == FootbotTurret::Mode::kSpeed) {
      speed = turret_.speed;
    }
    turret_state_.speed = std::clamp(speed, -kFastest, kFastest);
    turret_state_.angle = wrapAngle(turret_state_.angle + turret_state_.speed * dt);
  }

  Eigen::Vector3d gripperTip() const {
    constexpr double kReach = 0.11;  // [m] from the robot's axis
    return pose_.toWorld({kReach * std::cos(turret_state_.angle), kReach * std::sin(turret_state_.angle), 0.0});
  }

  void grip() {
    constexpr double kNear = 0.06;  // [m] from the tip
    if (!gripper_.closed) {
      held_ = nullptr;
      return;
    }
    const Eigen::Vector3d tip = gripperTip();
    if (held_ == nullptr) {
      for (Beacon& beacon : world_.beacons) {
        if (beacon.can_be_gripped && (beacon.at - tip).head<2>().norm() < kNear) {
          held_ = &beacon;
          break;
        }
      }
    }
    if (held_ != nullptr) {
      held_->at.head<2>() = tip.head<2>();
    }
  }

  void sense() override {
    constexpr double kRadius = 0.085;      // [m]
    constexpr double kRange = 0.1;         // [m] of the proximity sensors
    constexpr double kCameraRange = 10.0;  // [m]
    for (std::size_t i = 0; i < FootbotProximity::kCount; ++i) {
      const double distance =
          distanceToWall(world_, pose_.position.head<2>(), pose_.yaw + FootbotProximity::angle(i)) - kRadius;
      proximity_.value[i] = static_cast<float>(std::clamp(1.0 - distance / kRange, 0.0, 1.0));
    }
    blobs_.clear();
    for (const Beacon& beacon : world_.beacons) {
      const ColorBlob blob = blobOf(beacon, pose_);
      if (static_cast<double>(blob.distance) <= kCameraRange) {
        blobs_.push_back(blob);
      }
    }
    camera_.blobs = blobs_;
    gripper_state_.gripping = held_ != nullptr;
  }

  FootbotWheels wheels_;
  FootbotGripper gripper_;
  FootbotTurret turret_;
  FootbotLeds leds_;
  FootbotProximity proximity_;
  FootbotCamera camera_;
  FootbotGripperState gripper_state_;
  FootbotTurretState turret_state_;
  std::vector<ColorBlob> blobs_;
  Beacon* held_ = nullptr;
};

}  // namespace

std::unique_ptr<MockRobot> makeMockFootbot(World world, Pose start) {
  return std::make_unique<MockFootbot>(std::move(world), std::move(start));
}

}  // namespace swarmanoid::mock
