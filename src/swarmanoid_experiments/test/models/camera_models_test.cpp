// The formulas of docs/reference/models.md, "Cameras".
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "model_world.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/eyebot_laser.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid::test {
namespace {

std::string camera(const std::string& parameters) {
  return "<footbot_camera><range>9</range>" + parameters + "</footbot_camera>";
}

/// Blobs that the robot "watcher" sees after one tick of the program.
std::vector<ColorBlob> seenIn(ModelWorld world, const Program& others = {}) {
  std::vector<ColorBlob> seen;
  setProgram([&](Robot& robot) {
    if (robot.name() == "watcher") {
      const auto& blobs = robot.sensor<FootbotCamera>().blobs;
      seen.assign(blobs.begin(), blobs.end());
    } else if (others) {
      others(robot);
    }
  });
  auto simulation = world.start();
  tick(*simulation, 2);
  return seen;
}

std::string colored(int red) { return join("<color>", red, ",7,9</color>"); }

TEST(ModelsPageTest, BlobPoint) {
  ModelWorld world;
  world.footbot_sensors = camera("<sees_floor>true</sees_floor>");
  world.entities = robot("footbot", "watcher", 5.0, 5.0, 0.0) + prey("tall", 5.3, 6.1, 0.07, 0.19, colored(1)) +
                   entity("light", "lamp", 4.1, 4.7, 0.83, 0.0, "<color>2,7,9</color>") +
                   robot("footbot", "lit", 3.7, 6.2, 0.0, 200.0) + robot("eyebot", "pointer", 6.9, 7.1, 1.9, 20.0);
  world.extras =
      "<floor_patch id='disc'><position>6.2,4.2,0</position><radius>0.5</radius><color>3,7,9</color></floor_patch>"
      "<floor_patch id='far'><position>14.3,5,0</position><radius>0.5</radius><color>4,7,9</color></floor_patch>";
  const double tilt = 0.43;
  const double pan = -1.9;
  const auto blobs = seenIn(world, [&](Robot& robot) {
    if (robot.name() == "lit") {
      robot.actuator<FootbotLeds>().ring[5] = {5, 7, 9};
    } else {
      robot.actuator<EyebotLaser>().on = true;
      robot.actuator<EyebotLaser>().tilt = tilt;
      robot.actuator<EyebotLaser>().pan = pan;
    }
  });
  std::map<int, double> distance;
  for (const ColorBlob& blob : blobs) {
    distance[blob.color.red] = blob.distance;
  }
  const double led = (200.0 + 150.0) * kDegree;
  EXPECT_EQ(distance.size(), 6U);
  EXPECT_NEAR(distance[1], std::hypot(0.3, 1.1), 1e-6) << "a prey's middle";
  EXPECT_NEAR(distance[2], std::hypot(0.9, 0.3), 1e-6) << "a light's origin";
  EXPECT_NEAR(distance[3], std::hypot(1.2, 0.8), 1e-6) << "a patch's middle";
  EXPECT_NEAR(distance[4], 9.3 - 0.5, 1e-6) << "its nearest point, for the middle is out of range";
  EXPECT_NEAR(distance[5], std::hypot(-1.3 + 0.085 * std::cos(led), 1.2 + 0.085 * std::sin(led)), 1e-6) << "a LED";
  const double aside = (1.9 + 0.15) * std::tan(tilt);  // down to the ground
  const double spot_x = 1.9 + 0.05 * std::cos(20.0 * kDegree) + aside * std::cos(20.0 * kDegree + pan);
  const double spot_y = 2.1 + 0.05 * std::sin(20.0 * kDegree) + aside * std::sin(20.0 * kDegree + pan);
  EXPECT_NEAR(distance[255], std::hypot(spot_x, spot_y), 1e-6) << "a laser spot";
}

TEST(ModelsPageTest, BlobBearingAndDistance) {
  // a tilted watcher, in no engine: roll, pitch and yaw
  const double roll = 11.0 * kDegree;
  const double pitch = -19.0 * kDegree;
  const double yaw = 47.0 * kDegree;
  ModelWorld world;
  world.footbot_sensors = camera("");
  world.entities =
      "<footbot id='watcher'><position>5,5,0.6</position><orientation>11,-19,47</orientation><controller>footbot"
      "</controller></footbot>" +
      prey("p", 6.9, 5.8, 0.05, 0.1, colored(1));
  const auto blobs = seenIn(world);
  ASSERT_EQ(blobs.size(), 1U);
  // R = Rz(yaw) Ry(pitch) Rx(roll): its columns for x (ahead) and z (up)
  const double ahead_x = std::cos(yaw) * std::cos(pitch);
  const double ahead_y = std::sin(yaw) * std::cos(pitch);
  const double up_x = std::cos(yaw) * std::sin(pitch) * std::cos(roll) + std::sin(yaw) * std::sin(roll);
  const double up_y = std::sin(yaw) * std::sin(pitch) * std::cos(roll) - std::cos(yaw) * std::sin(roll);
  const double dx = 1.9 - 0.28 * up_x;
  const double dy = 0.8 - 0.28 * up_y;
  EXPECT_NEAR(blobs[0].distance, std::hypot(dx, dy), 1e-6);
  EXPECT_NEAR(blobs[0].bearing, std::atan2(dy, dx) - std::atan2(ahead_y, ahead_x), 1e-6);
}

TEST(ModelsPageTest, LineOfSight) {
  // to a prey's centre at 0.07 m, 1.3 m away; a thin wall at 0.9 m
  const double line = 0.28 + 0.9 / 1.3 * (0.07 - 0.28);
  for (const double height : {line - 0.001, line + 0.001}) {
    ModelWorld world;
    world.footbot_sensors = camera("");
    world.entities = robot("footbot", "watcher", 5.0, 5.0, 0.0) + prey("p", 6.3, 5.0, 0.05, 0.14, colored(1)) +
                     block("wall", 5.9, 5.0, 0.5 * height, join("0.0004,1,", height));
    EXPECT_EQ(seenIn(world).size(), height < line ? 1U : 0U) << height << " m";
  }
}

TEST(ModelsPageTest, OwnBody) {
  const double distance = 0.93;
  const double bearing = 1.9;
  const double heading = 40.0;
  ModelWorld world;
  world.footbot_sensors = camera("");
  world.entities =
      robot("footbot", "watcher", 5.0, 5.0, 0.0) +
      robot("footbot", "lit", 5.0 + distance * std::cos(bearing), 5.0 + distance * std::sin(bearing), 0.0, heading);
  const auto blobs = seenIn(world, [](Robot& robot) {
    for (int k = 0; k < 12; ++k) {
      robot.actuator<FootbotLeds>().ring[static_cast<std::size_t>(k)] = {static_cast<std::uint8_t>(k + 1), 7, 9};
    }
  });
  std::vector<int> expected;
  for (int k = 0; k < 12; ++k) {
    const double towards = std::remainder(heading * kDegree + k * M_PI / 6.0 - (bearing + M_PI), 2.0 * M_PI);
    if (std::abs(towards) < std::acos(0.08 / 0.085) + std::acos(0.08 / distance)) {
      expected.push_back(k + 1);
    }
  }
  std::vector<int> seen;
  for (const ColorBlob& blob : blobs) {
    seen.push_back(blob.color.red);
  }
  EXPECT_EQ(seen, expected);
  EXPECT_EQ(expected.size(), 7U);
}

TEST(ModelsPageTest, NearestBlobs) {
  ModelWorld world;
  world.footbot_sensors = camera("<max_blobs>3</max_blobs>");
  world.entities = robot("footbot", "watcher", 5.0, 5.0, 0.0);
  const double distances[] = {1.7, 0.9, 2.3, 0.6, 1.2};
  for (int i = 0; i < 5; ++i) {
    world.entities += prey(join("p_", i), 5.0 + distances[i] * std::cos(1.3 * i),
                           5.0 + distances[i] * std::sin(1.3 * i), 0.03, 0.1, colored(i + 1));
  }
  std::vector<int> seen;
  for (const ColorBlob& blob : seenIn(world)) {
    seen.push_back(blob.color.red);
  }
  EXPECT_EQ(seen, (std::vector<int>{2, 4, 5}));
}

TEST(ModelsPageTest, BlobNoise) {
  ModelWorld world;
  world.footbot_sensors = camera("<noise_distance>0.06</noise_distance><noise_bearing>3</noise_bearing>");
  world.entities = robot("footbot", "watcher", 5.0, 5.0, 0.0) + prey("p", 6.2, 5.9, 0.05, 0.1, colored(1));
  std::vector<double> factors;
  std::vector<double> errors;
  setProgram([&](Robot& robot) {
    const ColorBlob& blob = robot.sensor<FootbotCamera>().blobs[0];
    factors.push_back(blob.distance / 1.5);
    errors.push_back(blob.bearing - std::atan2(0.9, 1.2));
  });
  auto simulation = world.start();
  tick(*simulation, 4000);
  const auto deviation = [](const std::vector<double>& values, double mean) {
    double sum = 0.0;
    for (const double value : values) {
      sum += (value - mean) * (value - mean);
    }
    return std::sqrt(sum / static_cast<double>(values.size()));
  };
  // the relative standard error of a deviation from 4,000 draws is 1.1 %; five times that is allowed
  EXPECT_NEAR(deviation(factors, 1.0), 0.06, 0.06 * 0.056);
  EXPECT_NEAR(deviation(errors, 0.0), 3.0 * kDegree, 3.0 * kDegree * 0.056);
}

}  // namespace
}  // namespace swarmanoid::test
