// The checks of an eyebot, with a beacon on the ground ahead, an object on the ground to the left, a ceiling.
#include <cmath>
#include <memory>

#include "checks.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/eyebot_laser.hpp"
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr const char* kVelocity = EyebotVelocity::kType;
constexpr const char* kEyebotCamera = EyebotCamera::kType;
constexpr const char* kLaser = EyebotLaser::kType;
constexpr double kFlight = 1.5;  // s

Stage fly(Bench& bench, const Eigen::Vector3d& velocity, double yaw_rate, const std::shared_ptr<double>& took,
          std::function<void()> begin) {
  return {"flying",
          kFlight,
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
  Check check{"velocity_in_the_plane", {kVelocity, kEyebotCamera}, needsBeacon(bench), {kEyebotCamera}, {}};
  const Color beacon = bench.surroundings().beacon_color;
  const auto took = std::make_shared<double>(0.0);
  const std::pair<const char*, Eigen::Vector3d> kDirections[] = {
      {"ahead", {0.2, 0.0, 0.0}}, {"left", {0.0, 0.2, 0.0}}, {"right", {0.0, -0.2, 0.0}}, {"back", {-0.2, 0.0, 0.0}}};
  for (const auto& [name, speed] : kDirections) {
    const Place before = place();
    check.stages.push_back(
        fly(bench, speed, 0.0, took, [&bench, before, beacon] { *before = bench.find(beacon, "the beacon"); }));
    check.stages.push_back(settle(bench, [&bench, before, beacon, took, name = std::string(name), speed = speed] {
      const Eigen::Vector2d moved = *before - bench.find(beacon, "the beacon");
      bench.expectAbout("flown " + name + ", the way along x", moved.x(), speed.x() * *took, kLeastFlownWay, "m");
      bench.expectAbout("flown " + name + ", the way along y", moved.y(), speed.y() * *took, kLeastFlownWay, "m");
    }));
  }
  return check;
}

Check yaw(Bench& bench) {
  Check check{"yaw_left", {kVelocity, kEyebotCamera}, needsBeacon(bench), {kEyebotCamera}, {}};
  const Color beacon = bench.surroundings().beacon_color;
  const auto took = std::make_shared<double>(0.0);
  for (const double rate : {0.4, -0.4}) {
    const Place before = place();
    check.stages.push_back(fly(bench, Eigen::Vector3d::Zero(), rate, took,
                               [&bench, before, beacon] { *before = bench.find(beacon, "the beacon"); }));
    check.stages.push_back(settle(bench, [&bench, before, beacon, took, rate] {
      bench.expectAbout(
          rate > 0.0 ? "turned left, the beacon's bearing changed by" : "turned right, the beacon's bearing changed by",
          wrapTurn(bearingOf(bench.find(beacon, "the beacon")) - bearingOf(*before)), -rate * *took, kLeastAngle,
          "rad");
    }));
  }
  return check;
}

Stage point(Bench& bench, double pan, double tilt, std::function<void()> judge) {
  Stage stage = settle(bench, std::move(judge));
  stage.begin = [&bench, pan, tilt] { *bench.actuator<EyebotLaser>() = {true, pan, tilt}; };
  return stage;
}

constexpr double kTilt = 0.3;  // rad

/// Checks that the spot moves into the direction `pan`, farther with more tilt.
Check laser(Bench& bench) {
  Check check{kLaser, {kLaser, kEyebotCamera}, "", {kEyebotCamera}, {}};
  const Place below = place();
  const auto way = std::make_shared<double>(0.0);
  check.stages.push_back(
      settle(bench, [&bench] { bench.expectTrue("while it is off there is no red spot", !bench.see(colors::kRed)); }));
  check.stages.push_back(point(bench, 0.0, 0.0, [&bench, below] {
    constexpr double kMount = 0.1;  // m, from the middle of the robot at the most
    *below = bench.find(colors::kRed, "the spot");
    bench.expectNear("straight down, the spot's distance", below->norm(), 0.0, kMount, "m");
  }));
  for (const double pan : {0.0, M_PI / 2.0, -M_PI / 2.0}) {
    check.stages.push_back(point(bench, pan, kTilt, [&bench, below, pan, way] {
      const Eigen::Vector2d spot = bench.find(colors::kRed, "the spot") - *below;
      bench.expectAngle("direction of the tilted spot, pan " + withUnit(pan, "rad"), bearingOf(spot), pan, 0.15);
      *way = spot.norm();
      if (const double height = bench.surroundings().laser_height; height > 0.0) {
        bench.expectAbout("the tilted spot's way", *way, height * std::tan(kTilt), 0.05, "m");
      }
    }));
  }
  check.stages.push_back(point(bench, 0.0, 0.5 * kTilt, [&bench, below, way] {
    const double half = (bench.find(colors::kRed, "the spot") - *below).norm();
    const double expected = *way * std::tan(0.5 * kTilt) / std::tan(kTilt);
    bench.expectAbout("with half the tilt the spot's way", half, expected, 0.03, "m");
  }));
  check.stages.push_back(settle(bench, nullptr));
  check.stages.back().begin = [&bench] { bench.actuator<EyebotLaser>()->on = false; };
  check.stages.push_back(
      settle(bench, [&bench] { bench.expectTrue("switched off, the spot is gone", !bench.see(colors::kRed)); }));
  check.tidy_up = [&bench] { bench.actuator<EyebotLaser>()->on = false; };
  return check;
}

/// Measures the height with the laser: the displacement of the spot is the height times the tangent of the tilt.
Check upwards(Bench& bench) {
  Check check{"velocity_up", {kVelocity, kLaser, kEyebotCamera}, "", {kEyebotCamera, kLaser}, {}};
  if (!bench.surroundings().is_free_upwards) {
    check.obstacle = "the robot cannot move up and down here (upwards is false)";
  }
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

Check magnet(Bench& bench) {
  Check check{EyebotMagnet::kType, {EyebotMagnet::kType, EyebotMagnetState::kType, kVelocity}, "", {}, {}};
  if (!bench.surroundings().has_ceiling) {
    check.obstacle = "there is no ferromagnetic ceiling (ceiling is false)";
  }
  constexpr double kPatience = 20.0;  // s
  check.stages.push_back({"flying up to the ceiling and holding on to it", kPatience,
                          [&bench] { bench.actuator<EyebotMagnet>()->on = true; },
                          [&bench] {
                            bench.actuator<EyebotVelocity>()->linear = {0.0, 0.0, 0.2};
                          },
                          [&bench] { return bench.sensor<EyebotMagnetState>()->attached; }, nullptr});
  check.stages.push_back(settle(bench, [&bench] {
    bench.expectTrue("it still hangs at the ceiling", bench.sensor<EyebotMagnetState>()->attached);
  }));
  check.stages.push_back({"letting go", 2.0, [&bench] { bench.actuator<EyebotMagnet>()->on = false; }, nullptr,
                          [&bench] { return !bench.sensor<EyebotMagnetState>()->attached; }, nullptr});
  check.stages.push_back({"flying down", kFlight, nullptr,
                          [&bench] {
                            bench.actuator<EyebotVelocity>()->linear = {0.0, 0.0, -0.2};
                          },
                          nullptr,
                          [&bench](double) {
                            bench.expectTrue("it does not hang any more", !bench.sensor<EyebotMagnetState>()->attached);
                          }});
  check.tidy_up = [&bench] { bench.actuator<EyebotMagnet>()->on = false; };
  return check;
}

}  // namespace

std::vector<Check> eyebotChecks(Bench& bench) {
  const auto light = [&bench] {
    EyebotLeds& leds = *bench.actuator<EyebotLeds>();
    leds.setAll(colors::kBlack);
    leds.ring[0] = colors::kRed;
    leds.ring[EyebotLeds::kCount / 4] = colors::kBlue;
    leds.ring[EyebotLeds::kCount / 2] = colors::kGreen;
  };
  return {ledsShown(bench, EyebotLeds::kType, light),
          camera(bench, kEyebotCamera),
          velocity(bench),
          yaw(bench),
          laser(bench),
          upwards(bench),
          magnet(bench)};
}

}  // namespace swarmanoid::conformance
