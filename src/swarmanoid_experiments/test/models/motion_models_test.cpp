// The formulas of docs/reference/models.md, "Driving" and "Sliding and touching".
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "model_world.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kGravity = 9.81;

TEST(ModelsPageTest, WheelsToVelocity) {
  const double left = 3.7;
  const double right = 5.9;
  const double v = kWheelRadius * (left + right) / 2.0;
  const double omega = kWheelRadius * (right - left) / kSeparation;
  ModelWorld world;
  world.entities = robot("footbot", "fb", 5.0, 6.0, 0.0, 71.0);
  world.members = "fb";
  setProgram([&](Robot& robot) { robot.actuator<FootbotWheels>().setAngularVelocity(left, right); });
  auto simulation = world.start();
  tick(*simulation, 23);
  const double start = 71.0 * kDegree;
  const double end = start + omega * 2.3;
  const Pose& pose = poseOf(*simulation, "fb");
  EXPECT_NEAR(pose.position.x(), 5.0 + v / omega * (std::sin(end) - std::sin(start)), 1e-9);
  EXPECT_NEAR(pose.position.y(), 6.0 - v / omega * (std::cos(end) - std::cos(start)), 1e-9);
  EXPECT_NEAR(std::remainder(headingOf(*simulation, "fb") - end, 2.0 * M_PI), 0.0, 1e-9);
}

TEST(ModelsPageTest, WheelNoise) {
  const double speed = 0.11;
  ModelWorld world;
  world.wheels = "<footbot_wheels><noise>0.07</noise></footbot_wheels>";
  world.engine_parameters = "<subclock>3</subclock>";
  world.entities = robot("footbot", "fb", 5.0, 5.0, 0.0);
  world.members = "fb";
  setProgram([&](Robot& robot) { robot.actuator<FootbotWheels>().drive(speed, 0.0); });
  auto simulation = world.start();
  double sum = 0.0;
  double squares = 0.0;
  double product = 0.0;
  double before = 0.0;
  constexpr int kTicks = 1500;
  for (int i = 0; i < kTicks; ++i) {
    tick(*simulation);
    // the turn in one tick comes from the difference of the two wheels' factors
    const double factor = twistOf(*simulation, "fb").angular.z() * kSeparation / speed;
    sum += factor;
    squares += factor * factor;
    product += factor * before;
    before = factor;
  }
  const double variance = 2.0 * 0.07 * 0.07;
  EXPECT_NEAR(sum / kTicks, 0.0, 5.0 * std::sqrt(variance / kTicks));
  EXPECT_NEAR(squares / kTicks, variance, 5.0 * variance * std::sqrt(2.0 / kTicks))
      << "one draw for a tick's three steps";
  EXPECT_NEAR(product / kTicks, 0.0, 5.0 * variance / std::sqrt(kTicks)) << "a new one for each tick";
}

TEST(ModelsPageTest, TreelAcceleration) {
  const double wanted = 0.253;
  ModelWorld world;
  world.engine = "dynamics3d";
  world.engine_parameters = "<subclock>16</subclock>";
  world.entities = robot("footbot", "fb", 5.0, 5.0, 0.0, 37.0);
  world.members = "fb";
  setProgram([&](Robot& robot) { robot.actuator<FootbotWheels>().drive(wanted, 0.0); });
  auto simulation = world.start();
  const double step = 0.1 / 16.0;
  double way = 0.0;
  for (int n = 1; n <= 48; ++n) {
    way += step * std::min(wanted, 3.0 * n * step);
    if (n % 16 == 0) {
      tick(*simulation);
      const Eigen::Vector3d moved = poseOf(*simulation, "fb").position - Eigen::Vector3d(5.0, 5.0, 0.0);
      EXPECT_NEAR(moved.head<2>().norm(), way, 2e-5) << "after " << n << " steps";
    }
  }
}

TEST(ModelsPageTest, Tipping) {
  const double limit = std::atan(0.05075 / ((1.6 * 0.07 + 0.2 * 0.029) / 1.8)) / kDegree;
  ASSERT_NEAR(limit, 37.8, 0.1);
  for (const double slope : {limit - 1.5, limit + 1.5}) {
    // on a plate tilted about y; the footbot faces uphill, and does not slide
    const double sine = std::sin(slope * kDegree);
    const double cosine = std::cos(slope * kDegree);
    const auto turned = [&](const char* type, const char* id, double above, const std::string& more) {
      return join("<", type, " id='", id, "'><position>", 5.0 - above * sine, ",5,", 2.0 + above * cosine,
                  "</position><orientation>0,", -slope, ",0</orientation>", more, "</", type, ">");
    };
    ModelWorld world;
    world.engine = "dynamics3d";
    world.engine_parameters = "<subclock>20</subclock><treel_friction>4</treel_friction>";
    world.entities = turned("block", "plate", -0.1, "<size>2,2,0.2</size>") +
                     turned("footbot", "fb", 0.0, "<controller>footbot</controller>");
    world.members = "plate fb";
    setProgram([](Robot&) {});
    auto simulation = world.start();
    tick(*simulation, 10);
    const Eigen::Vector3d up = poseOf(*simulation, "fb").orientation * Eigen::Vector3d::UnitZ();
    const double tilted = std::atan2(-up.x(), up.z()) / kDegree - slope;
    EXPECT_EQ(tilted > 4.0, slope > limit) << "slope " << slope << ", tilted by " << tilted;
  }
}

/// A footbot pulls or turns a prey and releases it in tick 300 of 10 ms.
std::unique_ptr<Simulation> letGo(int subclock, double speed, double turn_rate) {
  ModelWorld world;
  world.engine = "dynamics2d";
  world.clocktick = 10;
  world.engine_parameters = join("<subclock>", subclock, "</subclock><ground_friction>0.31</ground_friction>");
  world.entities = robot("footbot", "fb", 5.0, 5.0, 0.0, 28.0) + prey("p", 5.0 + 0.4 * std::cos(28.0 * kDegree),
                                                                      5.0 + 0.4 * std::sin(28.0 * kDegree), 0.29, 0.1,
                                                                      "<mass>0.21</mass>");
  world.members = "fb p";
  int ticks = 0;
  setProgram([=](Robot& robot) mutable {
    robot.actuator<FootbotGripper>().closed = ticks < 300;
    const bool goes_away = ticks > 300;  // so that the prey does not hit it
    robot.actuator<FootbotWheels>().drive(goes_away ? -0.29 : speed, goes_away ? 0.0 : turn_rate);
    ++ticks;
  });
  auto simulation = world.start();
  tick(*simulation, 301);
  return simulation;
}

TEST(ModelsPageTest, Sliding) {
  for (const int subclock : {1, 3}) {
    auto simulation = letGo(subclock, -0.27, 0.0);
    const Eigen::Vector3d start = poseOf(*simulation, "p").position;
    double v = twistOf(*simulation, "p").linear.norm();
    EXPECT_NEAR(v, 0.27, 1e-3);
    const double h = 0.01 / subclock;
    double way = 0.0;
    for (v -= 0.31 * kGravity * h; v > 0.0; v -= 0.31 * kGravity * h) {
      way += v * h;
    }
    tick(*simulation, 30);
    EXPECT_NEAR((poseOf(*simulation, "p").position - start).norm(), way, 5e-5) << "subclock " << subclock;
    EXPECT_NEAR(way, 0.27 * 0.27 / (2.0 * 0.31 * kGravity), 0.5 * 0.27 * h + 1e-4);
  }
}

/// Decelerations, linear and angular, of an evenly loaded disc that slides and turns. The disc is divided into rings of
/// equal area.
std::pair<double, double> slowingOf(double v, double omega, double radius, double friction) {
  constexpr int kRings = 20;
  constexpr int kAround = 36;
  double force = 0.0;
  double torque = 0.0;
  for (int ring = 0; ring < kRings; ++ring) {
    const double r = radius * std::sqrt((ring + 0.5) / kRings);
    for (int k = 0; k < kAround; ++k) {
      const double angle = 2.0 * M_PI * (k + 0.5) / kAround;
      const Eigen::Vector2d slip(v - omega * r * std::sin(angle), omega * r * std::cos(angle));
      const Eigen::Vector2d rubs = slip / std::max(slip.norm(), 1e-12) / (kRings * kAround);
      force += rubs.x();
      torque += r * (std::cos(angle) * rubs.y() - std::sin(angle) * rubs.x());
    }
  }
  return {friction * kGravity * force, friction * kGravity * torque / (0.5 * radius * radius)};
}

TEST(ModelsPageTest, Spinning) {
  // it slides along the circle on which it was carried, and turns
  auto simulation = letGo(1, 0.0, 0.9);
  double omega = twistOf(*simulation, "p").angular.z();
  double v = twistOf(*simulation, "p").linear.norm();
  ASSERT_NEAR(omega, 0.9, 0.02);
  EXPECT_NEAR(slowingOf(0.0, 1.0, 0.29, 0.31).second, 4.0 / 3.0 * 0.31 * kGravity / 0.29, 0.02) << "on the spot";
  for (int i = 0; i < 5; ++i) {
    tick(*simulation);
    constexpr int kFine = 100;
    for (int k = 0; k < kFine; ++k) {
      const auto [brake, slowing] = slowingOf(v, omega, 0.29, 0.31);
      v -= brake * 0.01 / kFine;
      omega -= slowing * 0.01 / kFine;
    }
    EXPECT_NEAR(twistOf(*simulation, "p").angular.z(), omega, 4e-3) << "tick " << i;
    EXPECT_NEAR(twistOf(*simulation, "p").linear.norm(), v, 4e-3) << "tick " << i;
  }
}

/// Distance that a footbot keeps from a wall that it drives against. @param speed negative: backwards
double gapIn(const std::string& engine, int subclock, double speed) {
  ModelWorld world;
  world.engine = engine;
  world.engine_parameters = join("<subclock>", subclock, "</subclock>");
  world.entities =
      robot("footbot", "fb", 5.0, 5.0, 0.0, speed > 0.0 ? 0.0 : 180.0) + block("wall", 6.16, 5.0, 0.25, "0.2,4,0.5");
  world.members = "fb wall";
  setProgram([=](Robot& robot) { robot.actuator<FootbotWheels>().drive(speed, 0.0); });
  auto simulation = world.start();
  tick(*simulation, 150);
  const Pose& pose = poseOf(*simulation, "fb");
  double reach = pose.position.x() + 0.085;
  for (const double y : {-0.02, 0.02}) {
    for (const double z : {0.035, 0.065}) {  // corners of the gripper; a pushing footbot leans back
      reach = std::max(reach, (pose.position + pose.orientation * Eigen::Vector3d(0.11, y, z)).x());
    }
  }
  return 6.06 - reach;
}

TEST(ModelsPageTest, ContactGap) {
  for (const int subclock : {1, 7}) {
    EXPECT_NEAR(gapIn("kinematics2d", subclock, 0.17), 0.0, 1e-9);
    EXPECT_NEAR(gapIn("kinematics2d", subclock, -0.17), 0.0, 1e-9);
  }
  EXPECT_NEAR(gapIn("dynamics2d", 4, -0.17), 0.0, 0.2e-3) << "a circle and a polygon";
  EXPECT_NEAR(gapIn("dynamics2d", 4, 0.17), 0.0, 0.2e-3) << "two polygons";
  EXPECT_NEAR(gapIn("dynamics3d", 10, -0.17), 0.0, 0.1e-3);
  EXPECT_NEAR(gapIn("dynamics3d", 10, 0.17), 0.0, 0.1e-3);
}

TEST(ModelsPageTest, SlippingTreels) {
  for (const int subclock : {1, 6}) {
    ModelWorld world;
    world.engine = "dynamics2d";
    world.engine_parameters = join("<subclock>", subclock, "</subclock><treel_friction>0.043</treel_friction>");
    world.clocktick = 60;
    world.entities = robot("footbot", "fb", 5.0, 5.0, 0.0, 63.0);
    world.members = "fb";
    setProgram([](Robot& robot) { robot.actuator<FootbotWheels>().drive(0.13, 0.0); });
    auto simulation = world.start();
    for (int n = 1; n <= 8; ++n) {
      tick(*simulation);
      EXPECT_NEAR(twistOf(*simulation, "fb").linear.norm(), std::min(0.13, 0.043 * kGravity * 0.06 * n), 1e-4) << n;
    }
  }
}

}  // namespace
}  // namespace swarmanoid::test
