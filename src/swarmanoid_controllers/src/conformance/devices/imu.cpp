// The sensor of any level robot at rest measures gravity upwards and no rotation; a robot with a differential drive
// also turns to either side.
#include "swarmanoid_interface/devices/imu.hpp"

#include "../checks.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr double kTurningTime = 2.0;  // s

/// Turns, and judges during the turn.
Stage turnAndFeel(Bench& bench, const char* side, double rate) {
  constexpr double kLeastRate = 0.05;  // rad/s, allowed error
  return {std::string("turning to the ") + side,
          kTurningTime,
          nullptr,
          [&bench, rate] { bench.actuator<DifferentialDrive>()->drive(0.0, rate); },
          nullptr,
          [&bench, side, rate](double) {
            bench.expectAbout(std::string("turn rate about z while it turns to the ") + side,
                              bench.sensor<Imu>()->angular_velocity.z(), rate, kLeastRate, "rad/s");
          }};
}

std::vector<Check> imuChecks(Bench& bench) {
  Check at_rest{"imu_at_rest", {Imu::kType}, "", {}, {}};
  at_rest.stages.push_back(settle(bench, [&bench] {
    constexpr double kUneven = 1.0;    // m/s2, for a floor with a slope of 6 degrees
    constexpr double kDrifting = 0.1;  // rad/s
    const Imu& imu = *bench.sensor<Imu>();
    bench.expectAbout("acceleration upwards at rest", imu.linear_acceleration.z(), Imu::kGravity, kUneven, "m/s2");
    bench.expectNear("acceleration along the ground at rest", imu.linear_acceleration.head<2>().norm(), 0.0, kUneven,
                     "m/s2");
    bench.expectNear("turn rate at rest", imu.angular_velocity.norm(), 0.0, kDrifting, "rad/s");
  }));
  std::vector<Check> checks{at_rest};
  if (bench.isListed(DifferentialDrive::kType)) {
    constexpr double kRate = 0.5;  // rad/s
    Check turns{"imu_turns", {Imu::kType, DifferentialDrive::kType}, "", {}, {}};
    turns.follows = {DifferentialDrive::kType};  // that check begins at the start pose
    turns.stages = {turnAndFeel(bench, "left", kRate), turnAndFeel(bench, "right", -kRate)};
    checks.push_back(turns);
  }
  return checks;
}

const ChecksRegistration imu_checks({Imu::kType, imuChecks});

}  // namespace
}  // namespace swarmanoid::conformance
