// After a drive along an arc, a robot's odometry and positioning match the formula of the arc. During the drive the
// speeds of the odometry and the angles of the encoders match the motion.
#include "swarmanoid_interface/devices/odometry.hpp"

#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "../checks.hpp"
#include "../driving.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/positioning.hpp"
#include "swarmanoid_interface/devices/wheel_encoders.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr double kArcSpeed = 0.06;  // m/s
constexpr double kArcRate = 0.45;   // rad/s, to the left
constexpr double kArcTime = 2.0;    // s

/// Callbacks of a check during an arc.
struct Arc {
  std::function<void()> remember;                                        ///< before the robot drives
  std::function<void()> watch;                                           ///< in each tick of the drive
  std::function<void(double seconds)> moving;                            ///< at its end, with the robot still moving
  std::function<void(double speed, double rate, double seconds)> judge;  ///< at rest after the drive
};

/// Drives an arc and the same way back.
Check driveArc(Bench& bench, const char* device, const Arc& arc) {
  Check check{device, {device}, "", {}, {}};
  const std::optional<Drive> driver = driveOf(bench);
  if (!driver) {
    check.obstacle = "no device that drives it by speed and turn rate is listed";
    return check;
  }
  check.devices.push_back(driver->device);
  check.follows = {driver->check};
  for (const double sign : {1.0, -1.0}) {
    const auto took = std::make_shared<double>(0.0);
    const double speed = sign * kArcSpeed;
    const double rate = sign * kArcRate;
    check.stages.push_back({"driving an arc", kArcTime, arc.remember,
                            [driver, arc, speed, rate] {
                              driver->command(speed, rate);
                              arc.watch();
                            },
                            nullptr,
                            [took, arc](double seconds) {
                              *took = seconds;
                              arc.moving(seconds);
                            }});
    check.stages.push_back(settle(bench, [took, arc, speed, rate] { arc.judge(speed, rate, *took); }));
  }
  return check;
}

/// Mean speed during a drive: with encoders the speed of a single tick has a coarse resolution.
struct Mean {
  double sum = 0.0;
  double ticks = 0.0;

  void add(double speed) {
    sum += speed;
    ticks += 1.0;
  }
  double value() const { return ticks > 0.0 ? sum / ticks : 0.0; }
};

/// Odometry readings of a drive.
struct Driven {
  Odometry before;
  Odometry there;  ///< at the end of the drive
  Mean speed;
  Mean turn_rate;
};

/// The speeds must match the change of the pose, which is compared with the commands elsewhere.
void judgeSpeeds(Bench& bench, const Driven& driven, double seconds) {
  const Odometry& now = driven.there;
  const double turned = wrapTurn(now.heading - driven.before.heading);
  const double along = driven.before.heading + 0.5 * turned;
  const double way = std::cos(along) * (now.x - driven.before.x) + std::sin(along) * (now.y - driven.before.y);
  bench.expectAbout("way by the speeds of odometry", driven.speed.value() * seconds, way, kLeastWay, "m");
  bench.expectAbout("turned by the turn rates of odometry", driven.turn_rate.value() * seconds, turned, kLeastAngle,
                    "rad");
}

/// Pose that a sensor reports, in its own frame [m, rad].
struct PlanarPose {
  double x, y, heading;
};

/// @param sensor its name for the message: "odometry"
void judgePlace(Bench& bench, const std::string& sensor, const PlanarPose& before, const PlanarPose& now, double radius,
                double turn) {
  const double cosine = std::cos(before.heading);
  const double sine = std::sin(before.heading);
  const double x = now.x - before.x;
  const double y = now.y - before.y;
  bench.expectAbout("way ahead by " + sensor, cosine * x + sine * y, radius * std::sin(turn), kLeastWay, "m");
  bench.expectAbout("way to the left by " + sensor, cosine * y - sine * x, radius * (1.0 - std::cos(turn)), kLeastWay,
                    "m");
  bench.expectAngle("turned by " + sensor, wrapTurn(now.heading - before.heading), turn, kLeastAngle);
}

std::vector<Check> odometryChecks(Bench& bench) {
  const auto driven = std::make_shared<Driven>();
  Arc arc;
  arc.remember = [&bench, driven] { *driven = {*bench.sensor<Odometry>(), {}, {}, {}}; };
  arc.watch = [&bench, driven] {
    driven->speed.add(bench.sensor<Odometry>()->speed);
    driven->turn_rate.add(bench.sensor<Odometry>()->turn_rate);
  };
  arc.moving = [&bench, driven](double) { driven->there = *bench.sensor<Odometry>(); };
  arc.judge = [&bench, driven](double speed, double rate, double seconds) {
    const Odometry& now = *bench.sensor<Odometry>();
    const Odometry& before = driven->before;
    judgePlace(bench, "odometry", {before.x, before.y, before.heading}, {now.x, now.y, now.heading}, speed / rate,
               rate * seconds);
    bench.expectNear("speed by odometry, at rest", now.speed, 0.0, 0.01, "m/s");
    judgeSpeeds(bench, *driven, seconds);
  };
  return {driveArc(bench, Odometry::kType, arc)};
}

std::vector<Check> positioningChecks(Bench& bench) {
  const auto before = std::make_shared<Positioning>();
  const auto planarPoseOf = [](const Positioning& said) {
    return PlanarPose{said.position.x(), said.position.y(), said.heading};
  };
  Arc arc;
  arc.remember = [&bench, before] { *before = *bench.sensor<Positioning>(); };
  arc.watch = [] {};
  arc.moving = [](double) {};
  arc.judge = [&bench, before, planarPoseOf](double speed, double rate, double seconds) {
    const Positioning& now = *bench.sensor<Positioning>();
    judgePlace(bench, "positioning", planarPoseOf(*before), planarPoseOf(now), speed / rate, rate * seconds);
    constexpr double kLevel = 0.05;  // [m, rad]
    bench.expectNear("change of height by positioning", now.position.z() - before->position.z(), 0.0, kLevel, "m");
    bench.expectNear("roll by positioning", now.roll, before->roll, kLevel, "rad");
    bench.expectNear("pitch by positioning", now.pitch, before->pitch, kLevel, "rad");
  };
  return {driveArc(bench, Positioning::kType, arc)};
}

/// Encoder readings of a drive.
struct Turned {
  WheelEncoders before;
  Mean left;   ///< speed [rad/s]
  Mean right;  ///< speed [rad/s]
};

/// The wheels' size is not known here: comparing their speeds and angles detects a wrong unit in one of them. The
/// duration of a step depends on the driver, so only its direction is judged.
void judgeWheel(Bench& bench, const std::string& name, const WheelEncoders::Wheel& now, double turned,
                double expected) {
  constexpr double kLeast = 0.4;  // rad, allowed error: two ticks in which the wheel accelerates
  bench.expectAbout("the " + name + " wheel has turned by", turned, expected, kLeast, "rad");
  bench.expectTrue("the last step of the " + name + " wheel goes the way that it turns", now.step * turned >= 0.0);
}

std::vector<Check> encoderChecks(Bench& bench) {
  const auto seen = std::make_shared<Turned>();
  Arc arc;
  arc.remember = [&bench, seen] { *seen = {*bench.sensor<WheelEncoders>(), {}, {}}; };
  arc.watch = [&bench, seen] {
    seen->left.add(bench.sensor<WheelEncoders>()->left.speed);
    seen->right.add(bench.sensor<WheelEncoders>()->right.speed);
  };
  arc.moving = [&bench, seen](double seconds) {
    const WheelEncoders& now = *bench.sensor<WheelEncoders>();
    judgeWheel(bench, "left", now.left, now.left.turned - seen->before.left.turned, seen->left.value() * seconds);
    judgeWheel(bench, "right", now.right, now.right.turned - seen->before.right.turned, seen->right.value() * seconds);
  };
  arc.judge = [&bench, seen](double speed, double, double) {
    const WheelEncoders& now = *bench.sensor<WheelEncoders>();
    const double left = now.left.turned - seen->before.left.turned;
    const double right = now.right.turned - seen->before.right.turned;
    // on an arc to the left the right wheel turns further, forwards and backwards
    bench.expectTrue("both wheels have turned the way that it drove", left * speed > 0.0 && right * speed > 0.0);
    bench.expectTrue("the outer wheel has turned further", std::abs(right) > std::abs(left));
    bench.expectNear("speed of the left wheel, at rest", now.left.speed, 0.0, 0.2, "rad/s");
  };
  return {driveArc(bench, WheelEncoders::kType, arc)};
}

const ChecksRegistration odometry_checks({Odometry::kType, odometryChecks});
const ChecksRegistration positioning_checks({Positioning::kType, positioningChecks});
const ChecksRegistration encoder_checks({WheelEncoders::kType, encoderChecks});

}  // namespace
}  // namespace swarmanoid::conformance
