// The encoders of any robot's joints measure the commanded angles and speeds. The angles are small, so that no joint
// reaches a stop, and all different, so that no joint can be mistaken for another.
#include "swarmanoid_interface/devices/joints.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "../checks.hpp"
#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::conformance {
namespace {

using Angles = std::vector<double>;

/// Commanded angle of a joint, in the first or the second motion [rad].
double angleOf(std::size_t joint, bool is_first) {
  const double angle = 0.15 + 0.05 * static_cast<double>(joint);
  return (joint % 2 == 0) == is_first ? -angle : angle;
}

std::string nameOf(std::size_t joint) { return "joint " + std::to_string(joint); }

Angles anglesNow(const Bench& bench) {
  Angles angles;
  for (const JointStates::Joint& joint : bench.sensor<JointStates>()->joints) {
    angles.push_back(joint.angle);
  }
  return angles;
}

void turnToAngles(Check& check, Bench& bench, bool is_first) {
  constexpr double kClose = 0.06;  // rad
  Stage turn{"turning joints to angles", 2.0, nullptr, nullptr, nullptr, nullptr};
  turn.begin = [&bench, is_first] {
    for (std::size_t i = 0; i < Joints::kMost; ++i) {
      bench.actuator<Joints>()->joints[i].holdAngle(angleOf(i, is_first));
    }
  };
  check.stages.push_back(std::move(turn));
  check.stages.push_back(settle(bench, [&bench, is_first] {
    const auto& joints = bench.sensor<JointStates>()->joints;
    bench.expectTrue("there are joints", joints.size() > 0);
    for (std::size_t i = 0; i < joints.size(); ++i) {
      bench.expectAngle("angle of " + nameOf(i), joints[i].angle, angleOf(i, is_first), kClose);
    }
  }));
}

/// Turns from the second angles to angles between both, where no joint has a stop.
void turnAtSpeeds(Check& check, Bench& bench) {
  constexpr double kTime = 1.0;         // s
  constexpr double kLeastSpeed = 0.06;  // rad/s, allowed error
  constexpr double kLeastWay = 0.06;    // rad, allowed error
  const auto before = std::make_shared<Angles>();
  const auto speedOf = [](std::size_t joint) { return angleOf(joint, true); };  // rad/s: back in a second
  Stage turn{"turning joints at speeds", kTime, nullptr, nullptr, nullptr, nullptr};
  turn.begin = [&bench, before, speedOf] {
    *before = anglesNow(bench);
    for (std::size_t i = 0; i < Joints::kMost; ++i) {
      bench.actuator<Joints>()->joints[i].turnAt(speedOf(i));
    }
  };
  turn.end = [&bench, before, speedOf](double took) {
    const auto& joints = bench.sensor<JointStates>()->joints;
    for (std::size_t i = 0; i < std::min(joints.size(), before->size()); ++i) {
      bench.expectAbout("speed of " + nameOf(i), joints[i].speed, speedOf(i), kLeastSpeed, "rad/s");
      bench.expectAbout("way of " + nameOf(i), wrapTurn(joints[i].angle - (*before)[i]), speedOf(i) * took, kLeastWay,
                        "rad");
    }
  };
  check.stages.push_back(std::move(turn));
}

std::vector<Check> jointsChecks(Bench& bench) {
  if (!bench.isListed(Joints::kType)) {
    return {};
  }
  Check check{Joints::kType, {Joints::kType, JointStates::kType}, "", {}, {}};
  check.is_at_start = true;
  turnToAngles(check, bench, true);
  turnToAngles(check, bench, false);
  turnAtSpeeds(check, bench);
  check.stages.push_back(settle(bench, nullptr));
  check.stages.back().begin = [&bench] { *bench.actuator<Joints>() = {}; };
  check.tidy_up = [&bench] { *bench.actuator<Joints>() = {}; };
  return {check};
}

const ChecksRegistration joints_checks({Joints::kType, jointsChecks});

}  // namespace
}  // namespace swarmanoid::conformance
