// The beacon comes nearer while the robot drives ahead, and moves to the right while it turns left.
#include <cmath>
#include <memory>

#include "../checks.hpp"
#include "../driving.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

namespace swarmanoid::conformance {
namespace {

Check wheelsAhead(Bench& bench) {
  Check check{
      "wheels_ahead", {FootbotWheels::kType, FootbotCamera::kType}, needsBeacon(bench), {FootbotCamera::kType}, {}};
  const Color beacon = bench.surroundings().beacon_color;
  const auto took = std::make_shared<double>(0.0);
  for (const double speed : {kSpeed, -kSpeed}) {
    const Place before = place();
    check.stages.push_back(drive(bench, speed, 0.0, took, rememberPlace(bench, beacon, "what it looks at", before)));
    check.stages.push_back(settle(bench, [&bench, beacon, before, took, speed] {
      const Eigen::Vector2d after = bench.find(beacon, "the beacon");
      bench.expectAbout(speed > 0.0 ? "driven ahead, the beacon is nearer by" : "driven back, the beacon is nearer by",
                        before->norm() - after.norm(), speed * *took, kLeastWay, "m");
      bench.expectAngle("its bearing is still", bearingOf(after), bearingOf(*before), kLeastAngle);
    }));
  }
  return check;
}

Check wheelsLeft(Bench& bench) {
  Check check{
      "wheels_left", {FootbotWheels::kType, FootbotCamera::kType}, needsBeacon(bench), {FootbotCamera::kType}, {}};
  const Color beacon = bench.surroundings().beacon_color;
  const auto took = std::make_shared<double>(0.0);
  for (const double rate : {kTurnRate, -kTurnRate}) {
    const Place before = place();
    check.stages.push_back(drive(bench, 0.0, rate, took, rememberPlace(bench, beacon, "what it looks at", before)));
    check.stages.push_back(settle(bench, [&bench, beacon, before, took, rate] {
      const Eigen::Vector2d after = bench.find(beacon, "the beacon");
      bench.expectAbout(
          rate > 0.0 ? "turned left, the beacon's bearing changed by" : "turned right, the beacon's bearing changed by",
          wrapTurn(bearingOf(after) - bearingOf(*before)), -rate * *took, kLeastAngle, "rad");
    }));
  }
  return check;
}

std::vector<Check> wheelsChecks(Bench& bench) { return {wheelsAhead(bench), wheelsLeft(bench)}; }

const ChecksRegistration wheels_checks({FootbotWheels::kType, wheelsChecks, nullptr, restAtOnce<FootbotWheels>});

}  // namespace
}  // namespace swarmanoid::conformance
