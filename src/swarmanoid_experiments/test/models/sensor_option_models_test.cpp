// The formulas of docs/reference/models.md, "Sensing", for sensors with the properties of real ones: printed floors,
// distances that fold back, a scanner that samples over time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "model_world.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"
#include "swarmanoid_interface/devices/footbot_ground.hpp"
#include "swarmanoid_interface/devices/footbot_scanner.hpp"

namespace swarmanoid::test {
namespace {

double linear(double code) {
  const double value = code / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

TEST(ModelsPageTest, ReflectanceOfAPrint) {
  const struct {
    double red, green, blue;
  } floors[] = {{0, 0, 0}, {255, 255, 255}, {255, 0, 0}, {128, 128, 128}, {7, 93, 201}, {3, 2, 9}};
  ModelWorld world;
  world.footbot_sensors =
      "<footbot_ground><implementation>reflectance</implementation><ink_transparency>0.83</ink_transparency>"
      "<black>0.07</black></footbot_ground>";
  double x = 1.0;
  for (const auto& floor : floors) {
    const std::string id = join("at_", static_cast<int>(x));
    world.extras += join("<floor_patch id='p_", id, "'><position>", x, ",5,0</position><radius>0.4</radius><color>",
                         floor.red, ",", floor.green, ",", floor.blue, "</color></floor_patch>");
    world.entities += robot("footbot", id, x, 5.0, 0.0, 31.0 * x);
    world.members += id + " ";
    x += 1.0;
  }
  std::vector<float> values;
  setProgram([&](Robot& robot) {
    for (const float value : robot.sensor<FootbotGround>().value) {
      values.push_back(value);
    }
  });
  auto simulation = world.start();
  tick(*simulation);
  ASSERT_EQ(values.size(), std::size(floors) * FootbotGround::kCount);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const auto& floor = floors[k / FootbotGround::kCount];
    const double r = linear(floor.red);
    const double g = linear(floor.green);
    const double b = linear(floor.blue);
    EXPECT_NEAR(values[k], 0.07 + 0.93 * (0.83 * std::max({r, g, b}) + 0.17 * (r + g + b) / 3.0), 1e-6) << k;
  }
}

/// By hand: the linear light of 128 is ((0.501961 + 0.055) / 1.055)^2.4 = 0.215861.
TEST(SensorOptionTest, PrintedRedLooksAlmostWhiteAndPrintedGreyDark) {
  ModelWorld world;
  world.footbot_sensors = "<footbot_ground><implementation>reflectance</implementation></footbot_ground>";
  world.extras =
      "<floor_patch id='red'><position>3,5,0</position><radius>0.4</radius><color>red</color></floor_patch>"
      "<floor_patch id='grey'><position>7,5,0</position><radius>0.4</radius><color>gray</color></floor_patch>";
  world.entities = robot("footbot", "on_red", 3.0, 5.0, 0.0) + robot("footbot", "on_grey", 7.0, 5.0, 0.0);
  world.members = "on_red on_grey";
  std::vector<float> values;
  setProgram([&](Robot& robot) { values.push_back(robot.sensor<FootbotGround>().value[2]); });
  auto simulation = world.start();
  tick(*simulation);
  ASSERT_EQ(values.size(), 2U);
  EXPECT_NEAR(values[0], 0.05 + 0.95 * (0.9 + 0.1 / 3.0), 1e-6);
  EXPECT_NEAR(values[1], 0.05 + 0.95 * 0.215861, 1e-6);
}

/// A scanner with its head at rest; its left beam hits a wall, from 0.12 m to 0.35 m away.
TEST(ModelsPageTest, DistanceThatFoldsBack) {
  for (const double away : {0.115, 0.15, 0.19, 0.21, 0.35}) {
    ModelWorld world;
    world.footbot_sensors = "<footbot_scanner_readings><too_close>folded</too_close></footbot_scanner_readings>";
    world.footbot_actuators = "<footbot_scanner/>";
    world.entities = robot("footbot", "fb", 5.0, 5.0, 0.0) + block("wall", 5.0, 5.0 + away + 0.05, 0.25, "3,0.1,0.5");
    world.members = "fb wall";
    FootbotScannerReadings readings;
    setProgram([&](Robot& robot) {
      robot.actuator<FootbotScanner>().holdAngle(0.0);
      readings = robot.sensor<FootbotScannerReadings>();
    });
    auto simulation = world.start();
    tick(*simulation, 3);
    const double read = away < 0.2 ? 0.2 * 0.2 / away : away;
    for (const float distance : readings.long_left) {
      EXPECT_NEAR(distance, read, 1e-6) << away << " m";
    }
  }
}

/// The robot drives straight on with its head turning, and the beams hit all four walls.
TEST(ModelsPageTest, ScannerSamples) {
  constexpr double kSpeed = 0.23;  // m/s
  constexpr double kTurn = 2.1;    // rad/s, of the head
  constexpr double kHeading = 17.0 * kDegree;
  constexpr double kPeriod = 0.1;  // s, of a tick
  for (const double rate : {60.0, 7.3, 45.5}) {
    ModelWorld world;
    world.footbot_sensors = join("<footbot_scanner_readings><rate>", rate, "</rate></footbot_scanner_readings>");
    world.footbot_actuators = "<footbot_scanner/>";
    world.wheels = "<differential_drive/>";
    world.entities = robot("footbot", "fb", 5.0, 5.0, 0.0, 17.0) + block("wall", 6.45, 5.0, 0.25, "0.1,8,0.5");
    world.members = "fb wall";
    std::vector<FootbotScannerReadings> readings;
    setProgram([&](Robot& robot) {
      robot.actuator<FootbotScanner>().turnAt(kTurn);
      robot.actuator<DifferentialDrive>().drive(kSpeed, 0.0);
      readings.push_back(robot.sensor<FootbotScannerReadings>());
    });
    auto simulation = world.start();
    constexpr int kTicks = 30;
    tick(*simulation, kTicks);
    int measured = 0;
    for (int k = 1; k < kTicks; ++k) {
      std::size_t i = 0;
      // simulated time starts at 1 s
      const double end = 1.0 + kPeriod * k;
      for (double n = std::floor((end - kPeriod) * rate + 1e-6) + 1.0; n <= end * rate + 1e-6; n += 1.0, ++i) {
        const double since_start = n / rate - 1.0;
        ASSERT_LT(i, FootbotScannerReadings::kSamples);
        const double head = kTurn * since_start;
        EXPECT_NEAR(std::remainder(readings[k].angles[i] - head, 2.0 * M_PI), 0.0, 1e-5) << "tick " << k;
        const double x = 5.0 + kSpeed * since_start * std::cos(kHeading);
        for (const std::size_t beam : {1U, 3U}) {
          const double cosine = std::cos(kHeading + head + static_cast<double>(beam) * M_PI / 2.0);
          const double distance = cosine > 0.0 ? (6.4 - x) / cosine : INFINITY;
          const float found = readings[k].distances(beam)[i];
          if (distance < 1.5 - 1e-5 && distance > 0.2) {
            EXPECT_NEAR(found, distance, 1e-5) << "tick " << k << ", sample " << i << ", rate " << rate;
            ++measured;
          } else if (distance > 1.5 + 1e-5) {
            EXPECT_EQ(found, INFINITY) << "tick " << k << ", sample " << i;
          }
        }
      }
      for (; i < FootbotScannerReadings::kSamples; ++i) {
        EXPECT_TRUE(std::isnan(readings[k].long_left[i])) << "no sample: tick " << k << ", " << i;
      }
    }
    EXPECT_GT(measured, rate < 10.0 ? 3 : 20) << rate;
  }
}

}  // namespace
}  // namespace swarmanoid::test
