// The formulas of docs/reference/models.md, "Sensing".
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "model_world.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"

namespace swarmanoid::test {
namespace {

TEST(ModelsPageTest, ProximityResponse) {
  ModelWorld world;
  world.footbot_sensors = "<footbot_proximity><range>0.13</range></footbot_proximity>";
  world.entities =
      robot("footbot", "fb", 5.0, 5.0, 0.0, 17.0) + block("wall", 5.0 + 0.085 + 0.061 + 0.1, 5.0, 0.25, "0.2,3,0.5");
  FootbotProximity readings;
  setProgram([&](Robot& robot) { readings = robot.sensor<FootbotProximity>(); });
  auto simulation = world.start();
  tick(*simulation);
  int felt = 0;
  for (std::size_t i = 0; i < FootbotProximity::kCount; ++i) {
    const double cosine = std::cos(17.0 * kDegree + static_cast<double>(i) * 15.0 * kDegree);
    const double s = cosine > 0.0 ? (0.085 + 0.061) / cosine - 0.085 : 1.0;
    const double value = s < 0.13 ? std::pow(1.0 - s / 0.13, 3) : 0.0;
    EXPECT_NEAR(readings.value[i], value, 1e-6) << "sensor " << i;
    felt += value > 0.0 ? 1 : 0;
  }
  EXPECT_GE(felt, 5);
}

TEST(ModelsPageTest, ProximityNoise) {
  ModelWorld world;
  world.footbot_sensors = "<footbot_proximity><noise>0.3</noise></footbot_proximity>";
  const double s = 0.1 * (1.0 - std::cbrt(0.05));  // reads 0.05 without noise
  // sensor 6 faces left, perpendicular to the wall
  world.entities =
      robot("footbot", "fb", 5.0, 5.0, 0.0, -90.0) + block("wall", 5.0 + 0.085 + s + 0.1, 5.0, 0.25, "0.2,3,0.5");
  std::vector<double> values;
  std::vector<double> behind;
  setProgram([&](Robot& robot) {
    values.push_back(robot.sensor<FootbotProximity>().value[6]);
    behind.push_back(robot.sensor<FootbotProximity>().value[18]);
  });
  auto simulation = world.start();
  tick(*simulation, 4000);
  const auto zeros = static_cast<double>(std::count(values.begin(), values.end(), 0.0));
  EXPECT_NEAR(zeros / 4000.0, 0.25 / 0.6, 5.0 * std::sqrt(0.24 / 4000.0)) << "what falls below 0 is cut";
  EXPECT_LE(*std::max_element(values.begin(), values.end()), 0.35 + 1e-6);
  EXPECT_GT(*std::max_element(values.begin(), values.end()), 0.345);
  // sensor 18 faces away from the wall and reads 0 without noise
  EXPECT_NEAR(static_cast<double>(std::count(behind.begin(), behind.end(), 0.0)) / 4000.0, 0.5,
              5.0 * 0.5 / std::sqrt(4000.0));
  const double mean = std::accumulate(behind.begin(), behind.end(), 0.0) / 4000.0;
  EXPECT_NEAR(mean, 0.3 / 4.0, 5.0 * 0.097 / std::sqrt(4000.0));
}

}  // namespace
}  // namespace swarmanoid::test
