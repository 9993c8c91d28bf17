// The formulas of docs/reference/models.md, "Wheels that slip": drift of odometry from the truth, as mean and deviation
// over many robots; and equal slip in each engine.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "model_world.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"
#include "swarmanoid_interface/devices/odometry.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kDriftTick = 0.1;      // s
constexpr double kDriftHeading = 23.0;  // deg
constexpr int kSide = 30;               // robots along each side of the field
constexpr double kSpacing = 0.611;      // m

std::string slipping(double left, double right, double noise) {
  return join("<differential_drive><implementation>slipping</implementation><slip_left>", left,
              "</slip_left><slip_right>", right, "</slip_right><slip_noise>", noise,
              "</slip_noise></differential_drive>");
}

struct Statistics {
  double mean = 0.0;
  double deviation = 0.0;

  explicit Statistics(const std::vector<double>& values) {
    const auto count = static_cast<double>(values.size());
    for (const double value : values) {
      mean += value / count;
    }
    for (const double value : values) {
      deviation += (value - mean) * (value - mean) / count;
    }
    deviation = std::sqrt(deviation);
  }
};

/// A normal distribution fails this in 1 of 10,000 tests.
void expectDistribution(const std::vector<double>& values, double mean, double deviation, const std::string& what) {
  constexpr double kFar = 4.0;  // standard errors
  const Statistics found(values);
  const auto count = static_cast<double>(values.size());
  EXPECT_NEAR(found.mean, mean, kFar * deviation / std::sqrt(count)) << what;
  EXPECT_NEAR(found.deviation, deviation, kFar * deviation / std::sqrt(2.0 * count)) << what;
}

/// Results of many robots that drive straight ahead according to their odometry.
struct Drift {
  std::vector<double> ahead;     // true position ahead, m
  std::vector<double> aside;     // true position to the left, m
  std::vector<double> heading;   // rad
  std::vector<double> believed;  // distance by odometry, m
};

Drift driveStraight(const std::string& wheels, double v, int ticks) {
  ModelWorld world;
  world.wheels = wheels;
  world.footbot_sensors = "<odometry/>";
  world.seed = 41;
  for (int i = 0; i < kSide * kSide; ++i) {
    const std::string name = "fb" + std::to_string(i);
    world.entities +=
        robot("footbot", name, 1.0 + kSpacing * (i % kSide), 1.0 + kSpacing * (i / kSide), 0.0, kDriftHeading);
    world.members += name + " ";
  }
  std::map<std::string, Odometry> readings;
  double speed = v;
  setProgram([&](Robot& robot) {
    readings[robot.name()] = robot.sensor<Odometry>();
    robot.actuator<DifferentialDrive>().drive(speed, 0.0);
  });
  auto simulation = world.start();
  tick(*simulation, ticks);
  speed = 0.0;
  tick(*simulation);
  Drift drift;
  const Eigen::Vector2d along(std::cos(kDriftHeading * kDegree), std::sin(kDriftHeading * kDegree));
  for (int i = 0; i < kSide * kSide; ++i) {
    const std::string name = "fb" + std::to_string(i);
    const Eigen::Vector2d start(1.0 + kSpacing * (i % kSide), 1.0 + kSpacing * (i / kSide));
    const Eigen::Vector2d way = poseOf(*simulation, name).position.head<2>() - start;
    drift.ahead.push_back(along.dot(way));
    drift.aside.push_back(along.x() * way.y() - along.y() * way.x());
    drift.heading.push_back(headingOf(*simulation, name) - kDriftHeading * kDegree);
    drift.believed.push_back(readings.at(name).x);
    EXPECT_NEAR(readings.at(name).y, 0.0, 1e-9) << name;
    EXPECT_NEAR(readings.at(name).heading, 0.0, 1e-9) << name;
  }
  return drift;
}

TEST(ModelsPageTest, WheelsThatSlip) {
  constexpr double kSpeed = 0.127;  // m/s
  constexpr int kTicks = 26;
  const double way = kSpeed * kDriftTick * kTicks;

  // different slips: the heading
  const Drift turned = driveStraight(slipping(0.083, 0.031, 0.047), kSpeed, kTicks);
  expectDistribution(turned.heading, way * (0.083 - 0.031) / kSeparation,
                     0.047 * way / kSeparation * std::sqrt(2.0 / kTicks), "heading");
  for (const double believed : turned.believed) {
    EXPECT_NEAR(believed, way, 1e-9) << "encoders count what wheels turn";
  }

  // equal slips: the position, to first order in the heading, which stays below 0.1 rad
  constexpr double kSlip = 0.064;
  constexpr double kNoise = 0.029;
  const Drift shifted = driveStraight(slipping(kSlip, kSlip, kNoise), kSpeed, kTicks);
  expectDistribution(shifted.ahead, (1.0 - kSlip) * way, kNoise * way / std::sqrt(2.0 * kTicks), "ahead");
  const double n = kTicks;
  const double step = kSpeed * kDriftTick;
  expectDistribution(shifted.aside, 0.0,
                     (1.0 - kSlip) * step * kNoise * step / kSeparation * std::sqrt(2.0 * (n * n * n / 3.0 - n / 12.0)),
                     "aside");
}

TEST(SlippingWheelsTest, TheGroundIsSlowerThanTheWheelsInEachEngine) {
  constexpr double kSlip = 0.17;
  for (const char* engine : {"kinematics2d", "dynamics2d", "dynamics3d"}) {
    ModelWorld world;
    world.engine = engine;
    world.engine_parameters = "<subclock>10</subclock>";
    world.wheels = slipping(kSlip, kSlip, 0.0);
    world.footbot_sensors = "<odometry/>";
    world.entities = robot("footbot", "fb", 5.0, 5.0, 0.0);
    world.members = "fb";
    Odometry read;
    double speed = 0.113;
    setProgram([&](Robot& robot) {
      read = robot.sensor<Odometry>();
      robot.actuator<DifferentialDrive>().drive(speed, 0.0);
    });
    auto simulation = world.start();
    tick(*simulation, 50);
    speed = 0.0;
    tick(*simulation, 10);  // until the robot is at rest
    const double way = poseOf(*simulation, "fb").position.x() - 5.0;
    EXPECT_NEAR(read.x, 0.565, 0.01) << engine;
    EXPECT_NEAR(way, (1.0 - kSlip) * read.x, 0.005) << engine;
    EXPECT_NEAR(poseOf(*simulation, "fb").position.y(), 5.0, 0.005) << engine;
  }
}

}  // namespace
}  // namespace swarmanoid::test
