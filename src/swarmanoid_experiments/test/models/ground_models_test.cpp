// The formula of docs/reference/models.md, "Sensing": the floor under a robot.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "model_world.hpp"
#include "swarmanoid_interface/devices/footbot_ground.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

namespace swarmanoid::test {
namespace {

/// Value of the last of the test's patches at that point, or of the white floor.
double floorValueAt(double x, double y) {
  if (std::abs(x - 5.31) <= 0.085 && std::abs(y - 5.2) <= 0.55) {
    return (10.0 + 70.0 + 31.0) / 765.0;
  }
  return std::hypot(x - 5.2, y - 5.1) <= 0.23 ? (200.0 + 90.0 + 17.0) / 765.0 : 1.0;
}

/// Along an arc over a disc and a strip across it.
TEST(ModelsPageTest, GroundReading) {
  ModelWorld world;
  world.footbot_sensors = "<footbot_ground/><footbot_base_ground/>";
  world.entities = robot("footbot", "fb", 4.9, 5.0, 0.0, 17.0);
  world.extras =
      "<floor_patch id='disc'><position>5.2,5.1,0</position><radius>0.23</radius><color>200,90,17</color></floor_patch>"
      "<floor_patch id='strip'><position>5.31,5.2,0</position><size>0.17,1.1</size><color>10,70,31</color>"
      "</floor_patch>";
  world.members = "fb";
  std::array<float, FootbotGround::kCount> around{};
  std::array<float, FootbotBaseGround::kCount> between{};
  setProgram([&](Robot& robot) {
    around = robot.sensor<FootbotGround>().value;
    between = robot.sensor<FootbotBaseGround>().value;
    robot.actuator<FootbotWheels>().setAngularVelocity(7.0, 8.0);
  });
  auto simulation = world.start();
  std::set<float> seen;
  for (int k = 0; k < 40; ++k) {
    const Eigen::Vector3d position = poseOf(*simulation, "fb").position;
    const double heading = headingOf(*simulation, "fb");
    tick(*simulation);
    for (std::size_t i = 0; i < around.size(); ++i) {
      const double angle = heading + (22.5 + 45.0 * static_cast<double>(i)) * kDegree;
      const double x = position.x() + 0.063 * std::cos(angle);
      const double y = position.y() + 0.063 * std::sin(angle);
      EXPECT_NEAR(around[i], floorValueAt(x, y), 1e-6) << "tick " << k << ", spot " << i;
      seen.insert(around[i]);
    }
    for (std::size_t i = 0; i < between.size(); ++i) {
      const double angle = heading + (45.0 + 90.0 * static_cast<double>(i)) * kDegree;
      const double x = position.x() + 0.03 * std::sqrt(2.0) * std::cos(angle);
      const double y = position.y() + 0.03 * std::sqrt(2.0) * std::sin(angle);
      EXPECT_NEAR(between[i], floorValueAt(x, y), 1e-6) << "tick " << k << ", spot " << i << " between the wheels";
    }
  }
  EXPECT_EQ(seen.size(), 3U);
}

/// Paint under a footbot at rest, applied twice, on a white floor; half of the paint remains after 1.7 s.
TEST(ModelsPageTest, Paint) {
  constexpr double kRounding = 0.5 / 255.0;  // of each channel
  ModelWorld world;
  world.footbot_sensors = "<footbot_ground/>";
  world.entities = robot("footbot", "fb", 5.0, 5.0, 0.0);
  world.extras = "<floor_paint><cell>0.05</cell><half_life>1.7</half_life></floor_paint>";
  world.members = "fb";
  float value = 0.0F;
  setProgram([&](Robot& robot) { value = robot.sensor<FootbotGround>().value[3]; });
  auto simulation = world.start();
  const double dt = toSeconds(simulation->space().clocktick);
  const double first = (200.0 + 90.0 + 17.0) / 765.0;
  const double second = (10.0 + 70.0 + 31.0) / 765.0;
  double strength = 0.35;
  double color = first;
  simulation->apply(PaintFloor{{{{5.0, 5.0}, 0.2, {200, 90, 17}, strength}}});
  for (int n = 0; n < 40; ++n) {
    if (n == 13) {
      const double left = strength * std::exp2(-n * dt / 1.7);
      color = (0.6 * second + 0.4 * left * color) / (0.6 + 0.4 * left);
      strength = 0.6 + 0.4 * left;
      simulation->apply(PaintFloor{{{{5.0, 5.0}, 0.2, {10, 70, 31}, 0.6}}});
    }
    tick(*simulation);
    const double seen = strength * std::exp2(-(n < 13 ? n : n - 13) * dt / 1.7);
    EXPECT_NEAR(value, 1.0 + seen * (color - 1.0), 2.0 * kRounding) << "tick " << n;
  }
}

}  // namespace
}  // namespace swarmanoid::test
