// The implementation "unreliable" of cameras: rates of missed and of false blobs, over 10,000 ticks.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <thread>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"

namespace swarmanoid::test {
namespace {

constexpr int kManyTicks = 10000;

Parameters unreliable(Parameters parameters) {
  parameters.insert(
      {{"implementation", "unreliable"}, {"missed", "0"}, {"missed_per_metre", "0"}, {"false_blobs", "0"}});
  return parameters;
}

/// Five standard deviations of the rate of events with a given probability.
double spread(double probability) { return 5.0 * std::sqrt(probability * (1.0 - probability) / kManyTicks); }

double missedRate(const Parameters& parameters) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 4.0);
  world.addPrey(4.9, 4.4);  // its centre is 0.23 m below the camera
  SensorUnderTest<FootbotCamera> camera(world, robot, unreliable(parameters));
  int missed = 0;
  for (; world.space.tick < kManyTicks; ++world.space.tick) {
    missed += camera.sense().blobs.empty() ? 1 : 0;
  }
  return missed / static_cast<double>(kManyTicks);
}

TEST(UnreliableCameraTest, MissesBlobsWithAProbability) {
  EXPECT_NEAR(missedRate({{"missed", "0.3"}}), 0.3, spread(0.3));
  EXPECT_EQ(missedRate({}), 0.0);
  EXPECT_EQ(missedRate({{"missed", "1"}}), 1.0);
}

TEST(UnreliableCameraTest, MissesMoreOfWhatIsFarAway) {
  // 0.1 + 0.2 * sqrt(0.9^2 + 0.4^2 + 0.23^2), with a root of 1.01139 m
  EXPECT_NEAR(missedRate({{"missed", "0.1"}, {"missed_per_metre", "0.2"}}), 0.302278, spread(0.302278));
  EXPECT_EQ(missedRate({{"missed_per_metre", "3"}}), 1.0);
}

/// Blobs that a camera reports in each tick with nothing in sight.
template <class Camera>
std::vector<std::vector<ColorBlob>> falseBlobs(const std::shared_ptr<const EntityModel>& robot, double height,
                                               const Parameters& parameters, std::uint64_t seed = 1) {
  DeviceWorld world(seed);
  const Row row = world.add(robot, {5.0, 5.0, height}, 0.4);
  SensorUnderTest<Camera> camera(world, row, unreliable(parameters));
  std::vector<std::vector<ColorBlob>> ticks;
  for (; world.space.tick < kManyTicks; ++world.space.tick) {
    const auto& blobs = camera.sense().blobs;
    ticks.emplace_back(blobs.begin(), blobs.end());
  }
  return ticks;
}

TEST(UnreliableCameraTest, FalseBlobsComeAtTheirMeanRate) {
  // 4 a second are 0.4 in a tick of 0.1 s
  const auto ticks = falseBlobs<FootbotCamera>(robotModel("footbot"), 0.0, {{"false_blobs", "4"}, {"range", "1.7"}});
  std::map<std::size_t, int> ticks_with;
  std::map<std::string, int> colors;
  double distance = 0.0;
  double bearing = 0.0;
  int count = 0;
  for (const auto& blobs : ticks) {
    ++ticks_with[blobs.size()];
    for (const ColorBlob& blob : blobs) {
      ++count;
      ++colors[toString(blob.color)];
      distance += blob.distance;
      bearing += blob.bearing;
      EXPECT_LE(blob.distance, 1.7F);
      EXPECT_NEAR(blob.elevation, std::atan2(-0.28, blob.distance), 1e-5) << "on the ground";
    }
  }
  EXPECT_NEAR(count / static_cast<double>(kManyTicks), 0.4, 5.0 * std::sqrt(0.4 / kManyTicks));
  double probability = std::exp(-0.4);
  for (std::size_t most = 0; most < 3; ++most) {
    EXPECT_NEAR(ticks_with[most] / static_cast<double>(kManyTicks), probability, spread(probability))
        << most << ": Poisson";
    probability *= 0.4 / static_cast<double>(most + 1);
  }
  EXPECT_EQ(colors.size(), 3U);
  for (const char* color : {"red", "green", "blue"}) {
    EXPECT_NEAR(colors[color] / static_cast<double>(count), 1.0 / 3.0, 5.0 * std::sqrt(2.0 / 9.0 / count)) << color;
  }
  EXPECT_NEAR(distance / count, 1.7 * 2.0 / 3.0, 5.0 * 1.7 * std::sqrt(1.0 / 18.0 / count)) << "everywhere alike";
  EXPECT_NEAR(bearing / count, 0.0, 5.0 * M_PI / std::sqrt(3.0 * count));
}

TEST(UnreliableCameraTest, FalseBlobsAreInViewAndOfTheColoursThatAreNamed) {
  const Parameters parameters{{"false_blobs", "3"}, {"false_colors", "7,8,9 magenta"}};
  std::map<std::string, int> colors;
  for (const auto& blobs : falseBlobs<EyebotCamera>(robotModel("eyebot"), 1.0, parameters)) {
    for (const ColorBlob& blob : blobs) {
      ++colors[toString(blob.color)];
      EXPECT_LE(blob.distance, 1.15 * (1.0 + 1e-6)) << "the cone of 45 degrees from 1.15 m";
    }
  }
  EXPECT_EQ(colors.size(), 2U);
  EXPECT_GT(colors["7,8,9"], kManyTicks / 10);
  EXPECT_GT(colors["magenta"], kManyTicks / 10);
  int count = 0;
  for (const auto& blobs : falseBlobs<HandbotCamera>(robotModel("handbot"), 0.0, parameters)) {
    for (const ColorBlob& blob : blobs) {
      ++count;
      EXPECT_TRUE(std::isnan(blob.distance));
      EXPECT_LE(std::abs(blob.bearing), M_PI / 6.0 + 1e-6);
      EXPECT_LE(std::abs(blob.elevation), M_PI / 8.0 + 1e-6);
    }
  }
  EXPECT_NEAR(count / static_cast<double>(kManyTicks), 0.3, 5.0 * std::sqrt(0.3 / kManyTicks));
}

TEST(UnreliableCameraTest, BelongsToTheSeedAndNotToThreads) {
  const Parameters parameters = unreliable({{"missed", "0.4"}, {"false_blobs", "9"}, {"noise_bearing", "3"}});
  const auto readings = [&](std::uint64_t seed, std::size_t threads) {
    DeviceWorld world(seed);
    auto sensor = makeDevice<Sensor>(PluginKind::kSensor, FootbotCamera::kType, parameters);
    std::vector<const FootbotCamera*> cameras;
    for (int i = 0; i < 6; ++i) {
      const Row row = world.addFootbot(4.0 + 0.4 * i, 5.0 + 0.1 * i, i);
      world.space.leds[row][i] = colors::kRed;
      cameras.push_back(static_cast<const FootbotCamera*>(sensor->add(world.space, row)));
    }
    world.takePoses();
    std::vector<float> seen;
    for (; world.space.tick < 20; ++world.space.tick) {
      std::vector<std::thread> workers;
      for (std::size_t k = 0; k < threads; ++k) {
        workers.emplace_back([&, k] { sensor->sense(world.space, k * 6 / threads, (k + 1) * 6 / threads); });
      }
      for (std::thread& worker : workers) {
        worker.join();
      }
      for (const FootbotCamera* camera : cameras) {
        for (const ColorBlob& blob : camera->blobs) {
          seen.insert(seen.end(), {blob.bearing, blob.distance, blob.elevation, blob.size});
        }
      }
    }
    return seen;
  };
  const std::vector<float> expected = readings(1, 1);
  EXPECT_GT(expected.size(), 400U);
  EXPECT_EQ(readings(1, 2), expected);
  EXPECT_NE(readings(2, 1), expected);
}

TEST(UnreliableCameraTest, EachCameraIsAlsoUnreliable) {
  for (const char* type : {"footbot_camera", "eyebot_camera", "eyebot_omnidirectional_camera", "eyebot_pan_tilt_camera",
                           "footbot_front_camera", "handbot_camera"}) {
    EXPECT_NE(makeDevice<Sensor>(PluginKind::kSensor, type, {{"implementation", "unreliable"}}), nullptr) << type;
  }
}

TEST(UnreliableCameraTest, ColoursThatAreNoneAreRefused) {
  const auto refusal = [](const std::string& colors) -> std::string {
    try {
      makeDevice<Sensor>(PluginKind::kSensor, FootbotCamera::kType, unreliable({{"false_colors", colors}}));
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal("blue mauve").find("false_colors: found 'mauve', allowed: "), std::string::npos)
      << refusal("blue mauve");
  EXPECT_NE(refusal(" ").find("false_colors: found no colour, allowed: one or more, with spaces between them"),
            std::string::npos)
      << refusal(" ");
}

}  // namespace
}  // namespace swarmanoid::test
