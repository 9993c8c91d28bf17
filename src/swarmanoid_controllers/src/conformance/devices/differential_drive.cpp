// Any robot with a differential drive and proximity sensors, and with a wall to the right. The wall alone is the
// reference, because the robot may have no camera.
#include <algorithm>
#include <cmath>

#include "../../differential_drive.hpp"
#include "../checks.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"
#include "swarmanoid_interface/devices/proximity.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr double kDriveSpeed = 0.05;    // m/s
constexpr double kDriveTurnRate = 0.5;  // rad/s
constexpr double kNearReading = 0.15;   // a reading
constexpr double kBearingError = 0.4;   // rad, allowed error: there may be few sensors

double strongestReading(const Bench& bench) {
  double level = 0.0;
  for (const ProximityReading& reading : bench.sensor<Proximity>()->sensors) {
    level = std::max(level, static_cast<double>(reading.value));
  }
  return level;
}

Stage turn(Bench& bench, double angle) {
  const double rate = std::copysign(kDriveTurnRate, angle);
  return {"turning", angle / rate, nullptr, [&bench, rate] { bench.actuator<DifferentialDrive>()->drive(0.0, rate); },
          nullptr,   nullptr};
}

Stage expectWall(Bench& bench, const std::string& where, double bearing) {
  return settle(bench, [&bench, where, bearing] {
    bench.expectAngle("bearing of the wall " + where, ObstacleVector(*bench.sensor<Proximity>()).bearing(), bearing,
                      kBearingError);
  });
}

std::vector<Check> driveChecks(Bench& bench) {
  const double way = bench.surroundings().wall_distance;
  Check check{DifferentialDrive::kType, {DifferentialDrive::kType, Proximity::kType}, needsWall(bench), {}, {}};
  check.stages.push_back(settle(bench, [&bench] {
    bench.expectNear("away from everything the strongest reading", strongestReading(bench), 0.0, kNearReading / 3.0,
                     "");
  }));
  check.stages.push_back(turn(bench, -M_PI / 2.0));
  check.stages.push_back({"driving to the wall until something is near", 1.5 * way / kDriveSpeed, nullptr,
                          [&bench] { bench.actuator<DifferentialDrive>()->drive(kDriveSpeed, 0.0); },
                          [&bench] { return strongestReading(bench) > kNearReading; },
                          [&bench, way](double took) {
                            // the robot's radius and its sensors' range, both unknown here, are part of the way
                            bench.expectNear("way to the wall", kDriveSpeed * took, 0.65 * way, 0.35 * way, "m");
                          }});
  check.stages.push_back(expectWall(bench, "ahead", 0.0));
  check.stages.push_back(turn(bench, M_PI / 2.0));
  check.stages.push_back(expectWall(bench, "to the right", -M_PI / 2.0));
  check.stages.push_back(turn(bench, M_PI / 2.0));
  check.stages.push_back(expectWall(bench, "behind", M_PI));
  check.stages.push_back({"driving away from the wall", 2.0 * way / kDriveSpeed, nullptr,
                          [&bench] { bench.actuator<DifferentialDrive>()->drive(kDriveSpeed, 0.0); },
                          [&bench] { return strongestReading(bench) < kNearReading / 3.0; }, nullptr});
  return {check};
}

const ChecksRegistration drive_checks({DifferentialDrive::kType, driveChecks, nullptr, restAtOnce<DifferentialDrive>});

}  // namespace
}  // namespace swarmanoid::conformance
