// During a flight the beacon moves the opposite way in the robot's frame; the laser measures the height.
#include <cmath>
#include <memory>

#include "../checks.hpp"
#include "../pointing.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"

namespace swarmanoid::conformance {
namespace {

Stage fly(Bench& bench, const Eigen::Vector3d& velocity, double yaw_rate, const std::shared_ptr<double>& took,
          std::function<void()> begin) {
  constexpr double kTime = 1.5;  // s
  return {"flying",
          kTime,
          std::move(begin),
          [&bench, velocity, yaw_rate] {
            EyebotVelocity& command = *bench.actuator<EyebotVelocity>();
            command.linear = velocity;
            command.yaw_rate = yaw_rate;
          },
          nullptr,
          [took](double seconds) { *took = seconds; }};
}

/// Flies ahead, to the left, and back: objects on the ground move the other way in the robot's frame.
Check velocity(Bench& bench) {
  Check check{"velocity_in_the_plane",
              {EyebotVelocity::kType, EyebotCamera::kType},
              needsBeacon(bench),
              {EyebotCamera::kType},
              {}};
  const Color beacon = bench.surroundings().beacon_color;
  const auto took = std::make_shared<double>(0.0);
  const std::pair<const char*, Eigen::Vector3d> kDirections[] = {
      {"ahead", {0.2, 0.0, 0.0}}, {"left", {0.0, 0.2, 0.0}}, {"right", {0.0, -0.2, 0.0}}, {"back", {-0.2, 0.0, 0.0}}};
  for (const auto& [name, speed] : kDirections) {
    const Place before = place();
    check.stages.push_back(fly(bench, speed, 0.0, took, rememberPlace(bench, beacon, "the beacon", before)));
    check.stages.push_back(settle(bench, [&bench, before, beacon, took, name = std::string(name), speed = speed] {
      const Eigen::Vector2d moved = *before - bench.find(beacon, "the beacon");
      bench.expectAbout("flown " + name + ", the way along x", moved.x(), speed.x() * *took, kLeastFlownWay, "m");
      bench.expectAbout("flown " + name + ", the way along y", moved.y(), speed.y() * *took, kLeastFlownWay, "m");
    }));
  }
  return check;
}

Check yaw(Bench& bench) {
  Check check{"yaw_left", {EyebotVelocity::kType, EyebotCamera::kType}, needsBeacon(bench), {EyebotCamera::kType}, {}};
  const Color beacon = bench.surroundings().beacon_color;
  const auto took = std::make_shared<double>(0.0);
  for (const double rate : {0.4, -0.4}) {
    const Place before = place();
    check.stages.push_back(
        fly(bench, Eigen::Vector3d::Zero(), rate, took, rememberPlace(bench, beacon, "the beacon", before)));
    check.stages.push_back(settle(bench, [&bench, before, beacon, took, rate] {
      bench.expectAbout(
          rate > 0.0 ? "turned left, the beacon's bearing changed by" : "turned right, the beacon's bearing changed by",
          wrapTurn(bearingOf(bench.find(beacon, "the beacon")) - bearingOf(*before)), -rate * *took, kLeastAngle,
          "rad");
    }));
  }
  return check;
}

/// Measures the height with the laser: the displacement of the spot is the height times the tangent of the tilt.
Check upwards(Bench& bench) {
  Check check{"velocity_up",
              {EyebotVelocity::kType, EyebotLaser::kType, EyebotCamera::kType},
              needsRoomAbove(bench),
              {EyebotCamera::kType, EyebotLaser::kType},
              {}};
  const auto took = std::make_shared<double>(0.0);
  const auto height = std::make_shared<double>(0.0);
  const Place below = place();
  const auto measure = [&bench, below] {
    return (bench.find(colors::kRed, "the spot") - *below).norm() / std::tan(kTilt);
  };
  check.stages.push_back(point(bench, 0.0, 0.0, [&bench, below] { *below = bench.find(colors::kRed, "the spot"); }));
  for (const double speed : {0.2, -0.2}) {
    check.stages.push_back(point(bench, -M_PI / 2.0, kTilt, [height, measure] { *height = measure(); }));
    check.stages.push_back(fly(bench, {0.0, 0.0, speed}, 0.0, took, nullptr));
    check.stages.push_back(settle(bench, [&bench, height, measure, took, speed] {
      bench.expectAbout(speed > 0.0 ? "flown up, it is higher by" : "flown down, it is higher by", measure() - *height,
                        speed * *took, kLeastFlownWay, "m");
    }));
  }
  check.stages.push_back(settle(bench, nullptr));
  check.stages.back().begin = [&bench] { bench.actuator<EyebotLaser>()->on = false; };
  check.tidy_up = [&bench] { bench.actuator<EyebotLaser>()->on = false; };
  return check;
}

std::vector<Check> velocityChecks(Bench& bench) { return {velocity(bench), yaw(bench), upwards(bench)}; }

void usualFlight(Surroundings& usual) { usual.settling_time = 2.0; }

const ChecksRegistration velocity_checks({EyebotVelocity::kType, velocityChecks, usualFlight,
                                          restAtOnce<EyebotVelocity>});

}  // namespace
}  // namespace swarmanoid::conformance
