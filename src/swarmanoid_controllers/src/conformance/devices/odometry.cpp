// Driven along an arc, the odometry of a robot is where the formula of the arc says, and its encoders have turned for
// it.
#include "swarmanoid_interface/devices/odometry.hpp"

#include <cmath>
#include <functional>
#include <memory>

#include "../checks.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/wheel_encoders.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr double kArcSpeed = 0.06;  // m/s
constexpr double kArcRate = 0.45;   // rad/s, to the left
constexpr double kArcTime = 2.0;    // s

/// How it drives, by what is listed; null if it has no such device.
std::function<void(double, double)> driverOf(const Bench& bench) {
  if (auto* wheels = bench.actuator<FootbotWheels>()) {
    return [wheels](double speed, double turn_rate) { wheels->drive(speed, turn_rate); };
  }
  if (auto* drive = bench.actuator<DifferentialDrive>()) {
    return [drive](double speed, double turn_rate) { drive->drive(speed, turn_rate); };
  }
  return nullptr;
}

std::string driveDevice(const Bench& bench) {
  return bench.isListed(FootbotWheels::kType) ? FootbotWheels::kType : DifferentialDrive::kType;
}

/// Drives an arc and the same way back.
Check arc(Bench& bench, const char* name, const char* device, const std::function<void()>& remember,
          const std::function<void(double speed, double rate, double seconds)>& judge) {
  Check check{name, {device, driveDevice(bench)}, "", {}, {}};
  const auto driver = driverOf(bench);
  if (!driver) {
    check.obstacle = "no device that drives it by speed and turn rate is listed";
  } else {
    check.follows = {bench.isListed(FootbotWheels::kType) ? "wheels_left" : DifferentialDrive::kType};
  }
  for (const double sign : {1.0, -1.0}) {
    const auto took = std::make_shared<double>(0.0);
    check.stages.push_back({"driving an arc", kArcTime, remember,
                            [driver, sign] { driver(sign * kArcSpeed, sign * kArcRate); }, nullptr,
                            [took](double seconds) { *took = seconds; }});
    check.stages.push_back(settle(bench, [took, sign, judge] { judge(sign * kArcSpeed, sign * kArcRate, *took); }));
  }
  return check;
}

std::vector<Check> odometryChecks(Bench& bench) {
  const auto before = std::make_shared<Odometry>();
  const auto remember = [&bench, before] { *before = *bench.sensor<Odometry>(); };
  return {
      arc(bench, "odometry", Odometry::kType, remember, [&bench, before](double speed, double rate, double seconds) {
        const Odometry& now = *bench.sensor<Odometry>();
        const double cosine = std::cos(before->heading);
        const double sine = std::sin(before->heading);
        const double x = now.x - before->x;
        const double y = now.y - before->y;
        const double turn = rate * seconds;
        const double radius = speed / rate;
        bench.expectAbout("way ahead by odometry", cosine * x + sine * y, radius * std::sin(turn), kLeastWay, "m");
        bench.expectAbout("way to the left by odometry", cosine * y - sine * x, radius * (1.0 - std::cos(turn)),
                          kLeastWay, "m");
        bench.expectAngle("turned by odometry", wrapTurn(now.heading - before->heading), turn, kLeastAngle);
        bench.expectNear("speed by odometry, at rest", now.speed, 0.0, 0.01, "m/s");
      })};
}

std::vector<Check> encoderChecks(Bench& bench) {
  const auto before = std::make_shared<WheelEncoders>();
  const auto remember = [&bench, before] { *before = *bench.sensor<WheelEncoders>(); };
  return {arc(bench, "wheel_encoders", WheelEncoders::kType, remember, [&bench, before](double speed, double, double) {
    const WheelEncoders& now = *bench.sensor<WheelEncoders>();
    const double left = now.left.turned - before->left.turned;
    const double right = now.right.turned - before->right.turned;
    // the wheels' size is not known here: on an arc to the left the right one turns further, either way
    bench.expectTrue("both wheels have turned the way that it drove", left * speed > 0.0 && right * speed > 0.0);
    bench.expectTrue("the outer wheel has turned further", std::abs(right) > std::abs(left));
    bench.expectNear("speed of the left wheel, at rest", now.left.speed, 0.0, 0.2, "rad/s");
  })};
}

const ChecksRegistration odometry_checks({Odometry::kType, odometryChecks});
const ChecksRegistration encoder_checks({WheelEncoders::kType, encoderChecks});

}  // namespace
}  // namespace swarmanoid::conformance
