// The gripper grips the prey, keeps its hold, and releases it.
#include <algorithm>
#include <cmath>
#include <memory>

#include "../checks.hpp"
#include "../driving.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

namespace swarmanoid::conformance {
namespace {

Check gripperCloses(Bench& bench) {
  const Color prey = bench.surroundings().prey_color;
  Check check{"gripper_closes",
              {FootbotGripper::kType, FootbotGripperState::kType, FootbotWheels::kType, FootbotCamera::kType},
              needsPrey(bench),
              {FootbotCamera::kType, "wheels_ahead", "wheels_left"},
              {}};
  check.follows = {FootbotProximity::kType};  // its sensor ahead would detect the held prey
  check.stages.push_back(settle(bench, [&bench] {
    bench.expectTrue("nothing is held at first", !bench.sensor<FootbotGripperState>()->gripping);
  }));
  check.stages.push_back(turnTo(bench, prey, [] { return 0.0; }));
  check.stages.push_back({"driving to the prey and gripping it", kDrivingPatience, nullptr,
                          [&bench, prey] {
                            constexpr double kReach = 0.22;  // m: slow with closed gripper below this
                            const Eigen::Vector2d seen = bench.see(prey).value_or(Eigen::Vector2d::Zero());
                            const bool is_near = seen.norm() < kReach;
                            bench.actuator<FootbotGripper>()->closed = is_near;
                            bench.actuator<FootbotWheels>()->drive(is_near ? 0.3 * kSpeed : kSpeed,
                                                                   std::clamp(bearingOf(seen), -kTurnRate, kTurnRate));
                          },
                          [&bench] { return bench.sensor<FootbotGripperState>()->gripping; }, nullptr});
  check.stages.push_back(settle(bench, [&bench, prey] {
    bench.expectTrue("it still holds the prey", bench.sensor<FootbotGripperState>()->gripping);
    bench.expectAngle("bearing of what is held", bearingOf(bench.find(prey, "the prey")), 0.0, 0.3);
  }));
  check.tidy_up = [&bench] { bench.actuator<FootbotGripper>()->open(); };
  return check;
}

Check gripperOpens(Bench& bench) {
  const Color prey = bench.surroundings().prey_color;
  const auto took = std::make_shared<double>(0.0);
  const Place before = place();
  Check check{"gripper_opens",
              {FootbotGripper::kType, FootbotGripperState::kType, FootbotWheels::kType, FootbotCamera::kType},
              needsPrey(bench),
              {"gripper_closes"},
              {}};
  check.follows = {FootbotTurret::kType};  // which turns the held prey
  check.stages.push_back({"letting go", 2.0, [&bench] { bench.actuator<FootbotGripper>()->open(); }, nullptr,
                          [&bench] { return !bench.sensor<FootbotGripperState>()->gripping; }, nullptr});
  check.stages.push_back(drive(bench, -kSpeed, 0.0, took, rememberPlace(bench, prey, "what it looks at", before)));
  check.stages.push_back(settle(bench, [&bench, prey, before, took] {
    bench.expectAbout("driven back, the prey is farther by", bench.find(prey, "the prey").norm() - before->norm(),
                      kSpeed * *took, kLeastWay, "m");
  }));
  return check;
}

std::vector<Check> gripperChecks(Bench& bench) { return {gripperCloses(bench), gripperOpens(bench)}; }

const ChecksRegistration gripper_checks({FootbotGripper::kType, gripperChecks});

}  // namespace
}  // namespace swarmanoid::conformance
