// The checks of a handbot, with a board in front of its left hand, and a ceiling. It has no camera, so the motion of
// its joints is measured by their own encoders only.
#include <array>
#include <cmath>
#include <memory>

#include "checks.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr double kArmPatience = 10.0;  // s

/// Moves each joint to an angle of its own, so that no two can be confused.
Check arms(Bench& bench) {
  Check check{HandbotArms::kType, {HandbotArms::kType, HandbotArmsState::kType}, "", {}, {}};
  using Angles = std::array<double, HandbotArmsState::kJoints>;
  for (const Angles& angles : {Angles{-0.6, 0.3, 0.5, -0.9, -0.4, -0.7}, Angles{-0.9, -0.1, -0.2, -0.5, 0.15, 0.1},
                               Angles{-0.3, 0.0, 0.0, -0.3, 0.0, 0.0}}) {
    constexpr double kClose = 0.08;  // rad
    check.stages.push_back({"moving both arms", 2.0,
                            [&bench, angles] {
                              HandbotArms& command = *bench.actuator<HandbotArms>();
                              command.left = {angles[0], angles[1], angles[2]};
                              command.right = {angles[3], angles[4], angles[5]};
                            },
                            nullptr, nullptr, nullptr});
    check.stages.push_back(settle(bench, [&bench, angles] {
      for (std::size_t i = 0; i < angles.size(); ++i) {
        bench.expectNear(HandbotArmsState::kNames[i], bench.sensor<HandbotArmsState>()->joints[i].angle, angles[i],
                         kClose, "rad");
      }
    }));
  }
  return check;
}

/// Checks that the left hand touches an object when suction is on.
Check hands(Bench& bench) {
  Check check{HandbotHands::kType,
              {HandbotHands::kType, HandbotHandsState::kType, HandbotArms::kType},
              "",
              {HandbotArms::kType},
              {}};
  if (!bench.surroundings().has_board) {
    check.obstacle = "there is no board before the left hand (board is false)";
  }
  const auto state = [&bench] { return bench.sensor<HandbotHandsState>(); };
  check.stages.push_back({"stretching the left arm until its hand holds", kArmPatience,
                          [&bench] {
                            *bench.actuator<HandbotHands>() = {true, false};
                            bench.actuator<HandbotArms>()->left = {0.1, 0.0, 0.0};
                          },
                          nullptr, [state] { return state()->left.holding; }, nullptr});
  check.stages.push_back(settle(bench, [&bench, state] {
    bench.expectTrue("the left hand holds, the right one does not", state()->left.holding && !state()->right.holding);
  }));
  check.stages.push_back({"letting go", 2.0,
                          [&bench] {
                            *bench.actuator<HandbotHands>() = {false, false};
                          },
                          nullptr, [state] { return !state()->left.holding; }, nullptr});
  check.stages.push_back({"raising the arm", 1.0, [&bench] { bench.actuator<HandbotArms>()->left.shoulder = -0.3; },
                          nullptr, nullptr, nullptr});
  check.tidy_up = [&bench] {
    *bench.actuator<HandbotHands>() = {false, false};
    bench.actuator<HandbotArms>()->left.shoulder = -0.3;
  };
  return check;
}

Check rope(Bench& bench) {
  Check check{HandbotRope::kType, {HandbotRope::kType, HandbotRopeState::kType}, "", {}, {}};
  if (!bench.surroundings().has_ceiling) {
    check.obstacle = "there is no ferromagnetic ceiling (ceiling is false)";
  }
  const auto state = [&bench] { return bench.sensor<HandbotRopeState>(); };
  const auto before = std::make_shared<double>(0.0);
  const auto took = std::make_shared<double>(0.0);
  check.stages.push_back({"shooting the rope to the ceiling", kArmPatience,
                          [&bench] { bench.actuator<HandbotRope>()->shot = true; }, nullptr,
                          [state] { return state()->attached; }, nullptr});
  for (const double speed : {0.05, -0.05}) {
    check.stages.push_back({"winding", 2.0, [state, before] { *before = state()->length; },
                            [&bench, speed] { bench.actuator<HandbotRope>()->winding_speed = speed; }, nullptr,
                            [took](double seconds) { *took = seconds; }});
    check.stages.push_back(settle(bench, [&bench, state, before, took, speed] {
      bench.expectAbout(speed > 0.0 ? "wound in, the rope is shorter by" : "wound out, the rope is shorter by",
                        *before - state()->length, speed * *took, 0.02, "m");
      if (speed > 0.0) {
        bench.expectTrue("it pulls: " + withUnit(state()->tension, "N"), state()->tension > 1.0);
      }
    }));
  }
  check.stages.push_back({"letting go", 2.0, [&bench] { bench.actuator<HandbotRope>()->shot = false; }, nullptr,
                          [state] { return !state()->attached; }, nullptr});
  check.tidy_up = [&bench] { bench.actuator<HandbotRope>()->shot = false; };
  return check;
}

}  // namespace

std::vector<Check> handbotChecks(Bench& bench) { return {arms(bench), hands(bench), rope(bench)}; }

}  // namespace swarmanoid::conformance
