// The formula of docs/reference/models.md, "Sensing": range and bearing.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "model_world.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"

namespace swarmanoid::test {
namespace {

/// A footbot on an arc receives messages of another one, but not of one behind a wall or of one out of range.
TEST(ModelsPageTest, RangeAndBearing) {
  ModelWorld world;
  world.footbot_sensors = "<range_and_bearing_received/>";
  world.footbot_actuators = "<range_and_bearing/>";
  world.entities = robot("footbot", "hears", 5.0, 5.0, 0.0, 17.0) + robot("footbot", "near", 6.3, 4.1, 0.0, 205.0) +
                   robot("footbot", "hidden", 5.2, 6.4, 0.0) + robot("footbot", "far", 2.3, 3.5, 0.0) +
                   block("wall", 5.1, 5.8, 0.25, "0.8,0.05,0.5");
  world.members = "hears near hidden far wall";
  const std::map<std::string, std::uint8_t> numbers{{"near", 1}, {"hidden", 2}, {"far", 3}};
  std::vector<RangeAndBearingMessage> heard;
  setProgram([&](Robot& robot) {
    if (robot.name() != "hears") {
      robot.actuator<RangeAndBearing>().send({numbers.at(robot.name())});
      return;
    }
    robot.actuator<FootbotWheels>().drive(0.12, 0.9);
    const auto& messages = robot.sensor<RangeAndBearingReceived>().messages;
    heard.assign(messages.begin(), messages.end());
  });
  auto simulation = world.start();
  tick(*simulation);
  EXPECT_TRUE(heard.empty()) << "nobody has said anything before the first tick";
  for (int i = 0; i < 5; ++i) {
    const double x = poseOf(*simulation, "hears").position.x();
    const double y = poseOf(*simulation, "hears").position.y();
    const double heading = headingOf(*simulation, "hears");
    tick(*simulation);
    ASSERT_EQ(heard.size(), 1U);
    EXPECT_EQ(heard[0].payload[0], 1);
    EXPECT_NEAR(heard[0].range, std::hypot(6.3 - x, 4.1 - y), 1e-6);
    EXPECT_NEAR(std::remainder(heard[0].bearing - (std::atan2(4.1 - y, 6.3 - x) - heading), 2.0 * M_PI), 0.0, 1e-6);
    EXPECT_EQ(heard[0].elevation, 0.0F);
  }
  EXPECT_GT(headingOf(*simulation, "hears"), 17.0 * kDegree + 0.4) << "it has turned on the way";
}

}  // namespace
}  // namespace swarmanoid::test
