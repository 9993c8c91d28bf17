// The formula of docs/reference/models.md, "Sensing": radio tags.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "model_world.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/rfid.hpp"

namespace swarmanoid::test {
namespace {

/// A footbot that drives over tags reads those within reach, and writes the tick count to the nearest one.
void driveOverTagsIn(const std::string& engine) {
  SCOPED_TRACE(engine);
  ModelWorld world;
  world.engine = engine;
  world.footbot_sensors = "<rfid_reader><reach>0.083</reach></rfid_reader>";
  world.footbot_actuators = "<rfid_writer><reach>0.083</reach></rfid_writer>";
  world.entities = robot("footbot", "fb", 5.0, 5.0, 0.0, 17.0);
  world.members = "fb";
  constexpr int kTags = 6;
  double x_of[kTags];
  double y_of[kTags];
  for (int i = 0; i < kTags; ++i) {
    x_of[i] = 5.02 + 0.031 * i;
    y_of[i] = 5.03 + 0.011 * i - 0.017 * (i % 3);
    world.entities += entity("rfid_tag", "tag_" + std::to_string(i), x_of[i], y_of[i], 0.0, 0.0,
                             join("<tag>", 100 + i, "</tag><tag_data>", 7 * i, "</tag_data>"));
  }
  std::vector<RfidTagReading> read;
  std::uint32_t ticks = 0;
  setProgram([&](Robot& robot) {
    const auto& tags = robot.sensor<RfidReader>().tags;
    read.assign(tags.begin(), tags.end());
    robot.actuator<FootbotWheels>().drive(0.2, 0.3);
    robot.actuator<RfidWriter>().write(1000 + ++ticks);
  });
  auto simulation = world.start();
  std::vector<std::uint32_t> data;
  for (std::uint32_t i = 0; i < kTags; ++i) {
    data.push_back(7 * i);
  }
  std::size_t most = 0;
  for (int k = 0; k < 12; ++k) {
    const Eigen::Vector3d at = poseOf(*simulation, "fb").position;
    std::vector<std::pair<double, std::uint32_t>> near;
    for (std::uint32_t i = 0; i < kTags; ++i) {
      const double d = std::hypot(x_of[i] - at.x(), y_of[i] - at.y(), at.z() + 0.01);
      ASSERT_GT(std::abs(d - 0.083), 1e-6);
      if (d <= 0.083) {
        near.emplace_back(d, i);
      }
    }
    std::sort(near.begin(), near.end());
    tick(*simulation);
    SCOPED_TRACE(k);
    ASSERT_EQ(read.size(), near.size());
    for (std::size_t i = 0; i < near.size(); ++i) {
      EXPECT_EQ(read[i].id, 100 + near[i].second);
      EXPECT_EQ(read[i].data, data[near[i].second]);
    }
    if (!near.empty()) {
      data[near[0].second] = 1000 + ticks;
    }
    most = std::max(most, near.size());
    for (std::uint32_t i = 0; i < kTags; ++i) {
      EXPECT_EQ(*simulation->space().property(rowOf(*simulation, "tag_" + std::to_string(i)), "tag_data"), data[i]);
    }
  }
  EXPECT_GE(most, 3U);
}

TEST(ModelsPageTest, RadioTags) {
  driveOverTagsIn("kinematics2d");
  driveOverTagsIn("dynamics2d");
  driveOverTagsIn("dynamics3d");
}

}  // namespace
}  // namespace swarmanoid::test
