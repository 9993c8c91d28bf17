// A handbot that stands at its place, or hangs by its rope. A hand that reaches out at its own height touches an
// object, if the world has one there.
#include <algorithm>
#include <cmath>

#include "mock_robot.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"

namespace swarmanoid::mock {
namespace {

class MockHandbot final : public MockRobot {
 public:
  MockHandbot(World world, Pose start) : MockRobot(std::move(world), std::move(start)) {
    provideSensor(arms_state_);
    provideSensor(hands_state_);
    provideSensor(rope_state_);
    provideActuator(arms_);
    provideActuator(hands_);
    provideActuator(rope_);
    sense();
  }

 private:
  static constexpr double kLauncher = 0.29;  // [m] of the rope, over the ground
  static constexpr double kWeight = 28.4;    // [N]

  void move(double dt) override {
    const double before = pose_.position.z();
    moveArms(dt);
    moveHands();
    moveRope(dt);
    twist_.linear.z() = dt > 0.0 ? (pose_.position.z() - before) / dt : 0.0;
  }

  void moveArms(double dt) {
    constexpr double kFastest = 2.0;  // [rad/s]
    struct Bounds {
      double low;
      double high;
    };
    constexpr std::array<Bounds, 3> kBounds{{{-1.57, 0.7}, {-1.2, 1.2}, {-3.14, 3.14}}};
    const std::array<double, HandbotArmsState::kJoints> wanted{arms_.left.shoulder, arms_.left.elbow,
                                                               arms_.left.wrist,    arms_.right.shoulder,
                                                               arms_.right.elbow,   arms_.right.wrist};
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      HandbotArmsState::Joint& joint = arms_state_.joints[i];
      const Bounds& bounds = kBounds[i % kBounds.size()];
      const double way = std::clamp(wanted[i], bounds.low, bounds.high) - joint.angle;
      const double turn = std::clamp(way, -kFastest * dt, kFastest * dt);
      joint.angle += turn;
      joint.speed = dt > 0.0 ? turn / dt : 0.0;
    }
  }

  void moveHands() {
    constexpr double kLevel = 0.1;  // [rad] of the shoulder: the arm counts as stretched out
    constexpr double kForce = 5.0;  // [N]
    const auto hold = [&](bool is_on, bool is_something, std::size_t shoulder, HandbotHandsState::Hand& hand) {
      hand.holding = is_on && is_something && (hand.holding || std::abs(arms_state_.joints[shoulder].angle) < kLevel);
      hand.force = hand.holding ? kForce : 0.0;
    };
    constexpr std::size_t kLeft = 0;
    constexpr std::size_t kRight = 3;
    hold(hands_.left, world_.is_something_left, kLeft, hands_state_.left);
    hold(hands_.right, world_.is_something_right, kRight, hands_state_.right);
  }

  void moveRope(double dt) {
    constexpr double kFlight = 0.5;   // [s] to the ceiling
    constexpr double kFastest = 0.2;  // [m/s] of winding
    constexpr double kFall = 1.0;     // [m/s]
    const double straight = world_.ceiling - pose_.position.z() - kLauncher;
    if (!rope_.shot) {
      flown_ = 0.0;
      rope_state_ = HandbotRopeState{};
      pose_.position.z() = std::max(0.0, pose_.position.z() - kFall * dt);
      return;
    }
    flown_ += dt;
    if (flown_ < kFlight) {
      return;
    }
    if (!rope_state_.attached) {
      rope_state_.attached = true;
      rope_state_.length = straight;
    }
    const double most = world_.ceiling - kLauncher;
    rope_state_.length -= std::clamp(rope_.winding_speed, -kFastest, kFastest) * dt;
    rope_state_.length = std::max(0.0, rope_state_.length);
    pose_.position.z() = std::max(0.0, most - rope_state_.length);
    rope_state_.tension = pose_.position.z() > 0.0 ? kWeight : 0.0;
  }

  void sense() override {}

  HandbotArms arms_;
  HandbotHands hands_;
  HandbotRope rope_;
  HandbotArmsState arms_state_;
  HandbotHandsState hands_state_;
  HandbotRopeState rope_state_;
  double flown_ = 0.0;  // [s] since the rope was shot
};

}  // namespace

std::unique_ptr<MockRobot> makeMockHandbot(World world, Pose start) {
  return std::make_unique<MockHandbot>(std::move(world), std::move(start));
}

}  // namespace swarmanoid::mock
