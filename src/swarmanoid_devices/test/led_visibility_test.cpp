// The LEDs of a ring in the readings of a camera: those that the body of their own robot does not hide, by elementary
// geometry.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"

namespace swarmanoid::test {
namespace {

constexpr int kLeds = 12;
constexpr double kRing = 0.085;         // m, from the axis; equal to the body's radius
constexpr double kLedHeight = 0.12;     // m
constexpr double kBody = 0.08;          // m, radius that hides LEDs: the body's minus 5 mm
constexpr double kBottom = 0.015;       // m, bottom that hides LEDs: the body's 0.01 plus 5 mm
constexpr double kTop = 0.141;          // m, top that hides LEDs: the body's 0.146 minus 5 mm
constexpr double kCameraHeight = 0.28;  // m

using Led = std::pair<int, int>;  // robot, LED

/// Returns a different colour for each LED of each robot, so that a blob identifies its LED.
Color colorOf(int robot, int led) {
  return {static_cast<std::uint8_t>(robot + 1), static_cast<std::uint8_t>(led + 1), 200};
}

void light(DeviceWorld& world, Row row, int robot) {
  for (int led = 0; led < kLeds; ++led) {
    world.space.leds[row][led] = colorOf(robot, led);
  }
}

std::set<Led> ledsAmong(const ColorBlobs& seen) {
  std::set<Led> leds;
  for (const ColorBlob& blob : seen.blobs) {
    leds.insert({blob.color.red - 1, blob.color.green - 1});
  }
  return leds;
}

double angleBetween(double a, double b) { return std::abs(std::remainder(a - b, 2.0 * M_PI)); }

/// For a distant camera, whose lines of sight do not pass over the top. The tangent from a LED to the circle that hides
/// LEDs touches it acos(kBody / kRing) beyond the LED, and the tangent from the camera touches it acos(kBody /
/// distance) beyond the direction of the camera.
bool isOnNearSide(double led_direction, double camera_direction, double distance) {
  return angleBetween(led_direction, camera_direction) < std::acos(kBody / kRing) + std::acos(kBody / distance);
}

TEST(LedVisibilityTest, OfEightLitRobotsAllAreSeenEachFromItsNearSide) {
  const struct {
    double bearing;   // rad, from the camera, in W
    double distance;  // m
    double heading;   // rad
  } others[] = {{0.21, 0.43, 1.07},  {0.97, 1.31, -2.2}, {1.83, 0.36, 0.313}, {2.44, 1.77, 2.91},
                {3.37, 0.81, -0.71}, {4.12, 0.59, 4.55}, {4.9, 1.03, -1.87},  {5.71, 0.7, 3.3}};
  DeviceWorld world;
  const Row watcher = world.addFootbot(4.3, 5.2, 0.77);
  std::set<Led> expected;
  int robot = 0;
  for (const auto& other : others) {
    const double x = 4.3 + other.distance * std::cos(other.bearing);
    const double y = 5.2 + other.distance * std::sin(other.bearing);
    light(world, world.addFootbot(x, y, other.heading), robot);
    for (int led = 0; led < kLeds; ++led) {
      if (isOnNearSide(other.heading + led * M_PI / 6.0, other.bearing + M_PI, other.distance)) {
        expected.insert({robot, led});
      }
    }
    ++robot;
  }
  SensorUnderTest<FootbotCamera> camera(world, watcher);
  const FootbotCamera& seen = camera.sense();
  EXPECT_FALSE(seen.overflowed);
  EXPECT_EQ(seen.blobs.size(), expected.size()) << "each once";
  EXPECT_EQ(ledsAmong(seen), expected);
  EXPECT_GE(expected.size(), 8U * 5U);
  EXPECT_LE(expected.size(), 8U * 8U);
}

TEST(LedVisibilityTest, FromAboveAllAreSeenUntilTheFarSideFallsBehindTheEdge) {
  // the line from the LED on the far side rises from 0.12 to 2.15 m; at the height of the top it is 5 mm further
  // inwards if the camera is this far from the robot's axis
  const double edge = 0.005 * (2.15 - kLedHeight) / (kTop - kLedHeight) - kRing;
  ASSERT_NEAR(edge, 0.398, 5e-4);
  for (const double distance : {0.0, 0.2, edge - 0.002, edge + 0.002, 0.6}) {
    DeviceWorld world;
    const Row watcher = world.addEyebot(5.0 + distance * std::cos(0.7), 5.0 + distance * std::sin(0.7), 2.0, 1.3);
    const Row footbot = world.addFootbot(5.0, 5.0, 0.7 + M_PI / 6.0);  // LED 5 is on the far side
    light(world, footbot, 0);
    SensorUnderTest<EyebotCamera> camera(world, watcher);
    const std::set<Led> seen = ledsAmong(camera.sense());
    EXPECT_EQ(seen.count({0, 5}), distance < edge ? 1U : 0U) << distance << " m aside";
    EXPECT_EQ(seen.size() == kLeds, distance < edge) << distance << " m aside";
    EXPECT_GE(seen.size(), 7U) << distance << " m aside";
  }
}

/// Returns the least distance of a line of sight from the cylinder that hides LEDs (negative: it intersects), by
/// sampling in small steps. In the robot's frame.
double clearanceOf(const Eigen::Vector3d& eye, const Eigen::Vector3d& led) {
  constexpr int kSteps = 20000;
  double least = 1.0;
  for (int i = 0; i <= kSteps; ++i) {
    const Eigen::Vector3d point = led + (eye - led) * (static_cast<double>(i) / kSteps);
    const double outside = std::max({point.head<2>().norm() - kBody, kBottom - point.z(), point.z() - kTop});
    least = std::min(least, outside);
  }
  return least;
}

TEST(LedVisibilityTest, AtAnyTiltAndFromAnySideTheBodyHidesWhatItStandsBefore) {
  std::mt19937_64 random(7);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int hidden = 0;
  int visible = 0;
  for (int trial = 0; trial < 60; ++trial) {
    DeviceWorld world;
    const Row watcher = world.addFootbot(4.0, 4.0, uniform(-3.0, 3.0));
    const double bearing = uniform(-M_PI, M_PI);
    const double distance = uniform(0.25, 1.4);
    const Eigen::Vector3d place(4.0 + distance * std::cos(bearing), 4.0 + distance * std::sin(bearing),
                                uniform(0.0, 0.9));
    const Row other = world.add(robotModel("footbot"), place);
    const double tilt_direction = uniform(-M_PI, M_PI);
    const Eigen::Vector3d tilt_axis(std::cos(tilt_direction), std::sin(tilt_direction), 0.0);
    Pose& pose = world.pose(other);
    pose.orientation = Eigen::AngleAxisd(uniform(0.0, 1.5), tilt_axis) *
                       Eigen::AngleAxisd(uniform(-M_PI, M_PI), Eigen::Vector3d::UnitZ());
    light(world, other, 0);
    SensorUnderTest<FootbotCamera> camera(world, watcher);
    const std::set<Led> seen = ledsAmong(camera.sense());
    const Eigen::Vector3d eye = pose.orientation.conjugate() * (Eigen::Vector3d(4.0, 4.0, kCameraHeight) - place);
    for (int led = 0; led < kLeds; ++led) {
      const double direction = led * M_PI / 6.0;
      const Eigen::Vector3d place_of_led(kRing * std::cos(direction), kRing * std::sin(direction), kLedHeight);
      // the wheels and the gripper are low and can only hide an LED from below
      const double clearance = clearanceOf(eye, place_of_led);
      if (eye.z() > 0.1 && std::abs(clearance) > 1e-4) {
        EXPECT_EQ(seen.count({0, led}), clearance > 0.0 ? 1U : 0U) << "trial " << trial << ", LED " << led;
        ++(clearance > 0.0 ? visible : hidden);
      }
    }
  }
  EXPECT_GT(hidden, 60);
  EXPECT_GT(visible, 60);
}

TEST(LedVisibilityTest, AnEyebotsLedsShineThroughTheCageOfItsRotors) {
  DeviceWorld world;
  const Row watcher = world.addFootbot(5.0, 5.0);
  const Row eyebot = world.addEyebot(5.9, 5.4, 0.0, 0.4);
  for (int led = 0; led < 16; ++led) {
    world.space.leds[eyebot][led] = colorOf(0, led);
  }
  SensorUnderTest<FootbotCamera> camera(world, watcher);
  EXPECT_EQ(ledsAmong(camera.sense()).size(), 16U) << "they lie 15 cm deep in it";
}

TEST(LedVisibilityTest, TheSameIsSeenHoweverTheRobotsAreSharedAmongThreads) {
  const auto seenBy = [](std::size_t threads) {
    DeviceWorld world;
    constexpr std::size_t kRobots = 8;
    auto sensor = makeDevice<Sensor>(PluginKind::kSensor, FootbotCamera::kType, {{"max_blobs", "23"}});
    std::vector<const FootbotCamera*> cameras;
    for (std::size_t i = 0; i < kRobots; ++i) {
      const auto number = static_cast<double>(i);
      const Row row = world.addFootbot(3.0 + 0.31 * number, 4.0 + 0.27 * (i % 3), 0.9 * number);
      light(world, row, static_cast<int>(i));
      cameras.push_back(static_cast<const FootbotCamera*>(sensor->add(world.space, row)));
    }
    world.takePoses();
    std::vector<std::thread> workers;
    for (std::size_t k = 0; k < threads; ++k) {
      workers.emplace_back([&, k] { sensor->sense(world.space, k * kRobots / threads, (k + 1) * kRobots / threads); });
    }
    for (std::thread& worker : workers) {
      worker.join();
    }
    std::vector<std::tuple<int, int, float, float>> seen;
    for (const FootbotCamera* camera : cameras) {
      EXPECT_TRUE(camera->overflowed);
      for (const ColorBlob& blob : camera->blobs) {
        seen.emplace_back(blob.color.red, blob.color.green, blob.bearing, blob.distance);
      }
    }
    return seen;
  };
  const auto expected = seenBy(1);
  EXPECT_EQ(expected.size(), 8U * 23U);
  EXPECT_EQ(seenBy(2), expected);
  EXPECT_EQ(seenBy(5), expected);
}

/// Nine preys, each at least as far away as the previous one, the farthest with the lowest numbers.
class CameraOverflowTest : public testing::Test {
 protected:
  CameraOverflowTest() {
    for (int i = 0; i < 9; ++i) {
      const double bearing = 0.4 + 0.65 * i;
      const double distance = 1.6 - 0.13 * i;
      world.addPrey(5.0 + distance * std::cos(bearing), 5.0 + distance * std::sin(bearing), colorOf(i, 0), 0.03);
    }
  }

  std::vector<int> seen(const Parameters& parameters) {
    SensorUnderTest<FootbotCamera> camera(world, watcher, parameters);
    std::vector<int> result;
    for (const ColorBlob& blob : camera.sense().blobs) {
      result.push_back(blob.color.red - 1);
    }
    EXPECT_TRUE(camera.sense().overflowed);
    camera.sensor->remove(world.space, watcher);
    return result;
  }

  DeviceWorld world;
  Row watcher = world.addFootbot(5.0, 5.0, -0.3);
};

TEST_F(CameraOverflowTest, TheNearestAreKeptInTheOrderOfTheirNumbers) {
  EXPECT_EQ(seen({{"max_blobs", "4"}}), (std::vector<int>{5, 6, 7, 8}));
  EXPECT_EQ(seen({{"max_blobs", "1"}}), (std::vector<int>{8}));
}

TEST_F(CameraOverflowTest, ANearSpotTakesTheFarthestOnesPlaceAndComesAfterEntities) {
  world.space.laser_spots.push_back({EntityNumber{2}, Eigen::Vector3d::Zero(), {5.1, 5.25, 0.0}, colorOf(20, 0)});
  EXPECT_EQ(seen({{"max_blobs", "4"}}), (std::vector<int>{6, 7, 8, 20}));
}

TEST_F(CameraOverflowTest, OfEquallyNearOnesTheOlderIsKept) {
  // two more, mirrored so that both are exactly 0.5 m away
  world.addPrey(5.3, 5.4, colorOf(30, 0), 0.03);
  world.addPrey(4.7, 4.6, colorOf(31, 0), 0.03);
  EXPECT_EQ(seen({{"max_blobs", "1"}}), (std::vector<int>{30}));
}

}  // namespace
}  // namespace swarmanoid::test
