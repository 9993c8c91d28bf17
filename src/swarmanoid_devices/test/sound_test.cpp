// Microphones: loudspeakers in the arena and on robots. Expected levels are computed with logarithms: L - 20 lg d of
// each source, added as powers.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/devices/footbot_microphones.hpp"
#include "swarmanoid_interface/devices/loudspeaker.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"
#include "swarmanoid_space/models/entity_type.hpp"
#include "swarmanoid_space/models/properties.hpp"

namespace swarmanoid::test {
namespace {

using FootbotEars = SensorUnderTest<FootbotMicrophones>;

std::shared_ptr<const EntityModel> loudspeaker(const std::string& level, const std::string& frequency = "440") {
  Configuration parameters("loudspeaker", "", {});
  parameters.set(kSoundLevel, level);
  parameters.set(kSoundFrequency, frequency);
  return makePlugin<EntityType>(*Registry::instance().find(PluginKind::kEntity, "loudspeaker"))->makeModel(parameters);
}

double levelAt(double source, double distance) { return source - 20.0 * std::log10(distance); }
double sumOf(const std::vector<double>& levels) {
  double power = 0.0;
  for (const double level : levels) {
    power += std::pow(10.0, level / 10.0);
  }
  return 10.0 * std::log10(power);
}

constexpr double kCentreHeight = 0.146;  // of a footbot's microphones, m
constexpr double kQuiet = 30.0;          // dB

TEST(SoundTest, InSilenceThereIsTheBackground) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0, 0.7);
  world.add(loudspeaker("0"), {4.3, 5.2, 0.1});
  const FootbotMicrophones& quiet = FootbotEars(world, robot).sense();
  for (const float level : quiet.level) {
    EXPECT_NEAR(level, kQuiet, 1e-5);
  }
  EXPECT_EQ(quiet.loudest.bearing, 0.0F);
  EXPECT_EQ(quiet.loudest.confidence, 0.0F);
  EXPECT_EQ(quiet.loudest.frequency, 0.0F);
}

TEST(SoundTest, EachMicrophoneHearsByItsOwnDistance) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0, 0.7);
  world.add(loudspeaker("72"), {5.3, 5.9, 0.5});
  FootbotEars ears(world, robot);
  const FootbotMicrophones& heard = ears.sense();
  // the source is 1.6211 m from the centre, slightly to the right of ahead
  const double alone[] = {68.180772, 67.766476, 67.451435, 67.835411};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(heard.level[i], alone[i], 1e-5) << i;
  }
  EXPECT_NEAR(heard.loudest.bearing, -0.09445534, 1e-6);
  EXPECT_NEAR(heard.loudest.confidence, 0.99983438, 1e-6);
  EXPECT_EQ(heard.loudest.frequency, 440.0F);

  world.add(loudspeaker("75", "1234.5"), {3.1, 4.2, 1.1});
  const double both[] = {72.801095, 72.861191, 73.001130, 72.893978};
  ears.sense();
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(heard.level[i], both[i], 1e-5) << i;
  }
  EXPECT_NEAR(heard.loudest.bearing, -3.1149503, 1e-6) << "of the louder one";
  EXPECT_NEAR(heard.loudest.confidence, 0.68935389, 1e-6);
  EXPECT_EQ(heard.loudest.frequency, 1234.5F);
}

TEST(SoundTest, TheBackgroundAddsToWhatIsHeard) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0, 0.7);
  world.add(loudspeaker("72"), {5.3, 5.9, 0.5});
  FootbotEars ears(world, robot, {{"background", "55"}});
  const FootbotMicrophones& heard = ears.sense();
  EXPECT_NEAR(heard.level[0], 68.384067, 1e-5);
  EXPECT_NEAR(heard.level[2], 67.690898, 1e-5);
  EXPECT_NEAR(heard.loudest.confidence, 0.95022535, 1e-6);
}

TEST(SoundTest, BeyondTheRangeAndWithinACentimetre) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0);
  const Row horn = world.add(loudspeaker("90"), {4.0, 5.0 - 1.2999, kCentreHeight});
  FootbotEars ears(world, robot, {{"range", "1.3"}});
  const FootbotMicrophones& heard = ears.sense();
  EXPECT_NEAR(heard.level[3], sumOf({levelAt(90.0, 1.2299), kQuiet}), 1e-5);
  EXPECT_NEAR(heard.level[1], sumOf({levelAt(90.0, 1.3699), kQuiet}), 1e-5) << "the range is that of the middle";
  EXPECT_NEAR(heard.loudest.bearing, -M_PI / 2.0, 1e-6);
  world.pose(horn).position.y() = 5.0 - 1.3001;
  ears.sense();
  EXPECT_NEAR(heard.level[3], kQuiet, 1e-5);
  EXPECT_EQ(heard.loudest.confidence, 0.0F);
  world.pose(horn).position = {4.07 + 0.011, 5.0, kCentreHeight};
  ears.sense();
  EXPECT_NEAR(heard.level[0], sumOf({levelAt(90.0, 0.011), kQuiet}), 1e-5);
  world.pose(horn).position.x() = 4.07 + 0.002;
  ears.sense();
  EXPECT_NEAR(heard.level[0], 130.0, 1e-5) << "as at 0.01 m";
}

TEST(SoundTest, StraightBehindIsPi) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0);
  world.add(loudspeaker("70"), {2.9, 5.0, 0.9});
  EXPECT_EQ(FootbotEars(world, robot).sense().loudest.bearing, static_cast<float>(M_PI));
}

TEST(SoundTest, OfEquallyLoudSourcesTheFirstIsTheLoudest) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0);
  world.add(loudspeaker("70", "300"), {4.0, 6.5, kCentreHeight});
  world.add(loudspeaker("70", "200"), {5.5, 5.0, kCentreHeight});
  const FootbotMicrophones& heard = FootbotEars(world, robot).sense();
  EXPECT_EQ(heard.loudest.frequency, 300.0F);
  EXPECT_NEAR(heard.loudest.confidence, 0.5, 1e-3);
}

TEST(SoundTest, WhatStandsBetweenIsAShadowIfOneIsAskedFor) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0, 0.3);
  world.add(loudspeaker("76"), {6.1, 5.4, 0.2});
  world.addWall({0.1, 1.5, 0.6}, {5.0, 5.2});
  const auto level = [&](const std::string& shadow) {
    FootbotEars ears(world, robot, {{"shadow", shadow}, {"background", "0"}});
    const double heard = ears.sense().level[0];
    ears.sensor->remove(world.space, robot);
    return heard;
  };
  const double free = level("0");
  EXPECT_NEAR(free, levelAt(76.0, std::hypot(2.1 - 0.07 * std::cos(0.3), 0.4 - 0.07 * std::sin(0.3), 0.054)), 1e-4);
  EXPECT_NEAR(level("13.5"), free - 13.5, 1e-4);
  world.pose(robot).position.y() = 7.5;
  EXPECT_EQ(level("13.5"), level("0")) << "past the end of the wall";
}

TEST(SoundTest, RobotsHearEachOtherInTheNextTickAndNotThemselves) {
  DeviceWorld world;
  const Row a = world.addFootbot(4.0, 5.0, 0.3);
  const Row b = world.addFootbot(5.3, 4.1, 2.2);
  auto ears = makeDevice<Sensor>(PluginKind::kSensor, FootbotMicrophones::kType, {{"range", "1.6"}});
  const auto* heard_by_a = static_cast<const FootbotMicrophones*>(ears->add(world.space, a));
  const auto* heard_by_b = static_cast<const FootbotMicrophones*>(ears->add(world.space, b));
  ActuatorUnderTest<Loudspeaker> speaker(world, a);
  speaker.command.sound(64.0, 880.0);
  world.sense(*ears);
  EXPECT_EQ(heard_by_b->loudest.frequency, 0.0F) << "not carried out yet";
  speaker.actuate();
  world.sense(*ears);
  EXPECT_EQ(heard_by_a->loudest.frequency, 0.0F);
  EXPECT_NEAR(heard_by_a->level[0], kQuiet, 1e-5);
  EXPECT_EQ(heard_by_b->loudest.frequency, 880.0F);
  // a footbot's loudspeaker is above its origin, at half of its height of 0.146 m
  const double x = 5.3 + 0.07 * std::cos(2.2) - 4.0;
  const double y = 4.1 + 0.07 * std::sin(2.2) - 5.0;
  EXPECT_NEAR(heard_by_b->level[0], sumOf({levelAt(64.0, std::hypot(x, y, 0.073)), kQuiet}), 1e-5);
  EXPECT_NEAR(heard_by_b->loudest.bearing, std::remainder(std::atan2(0.9, -1.3) - 2.2, 2.0 * M_PI), 1e-6);
  EXPECT_TRUE(speaker.stop());
  world.sense(*ears);
  EXPECT_EQ(heard_by_b->loudest.frequency, 0.0F) << "a safe stop is silence";
}

TEST(SoundTest, CommandsAreLimited) {
  DeviceWorld world;
  ActuatorUnderTest<Loudspeaker> speaker(world, world.addFootbot(4.0, 5.0));
  EXPECT_EQ(speaker.actuate().level, 0.0) << "silent at rest";
  speaker.command.sound(141.0, 20001.0);
  EXPECT_EQ(speaker.actuate().level, 140.0);
  EXPECT_EQ(speaker.actuate().frequency, 20000.0);
  speaker.command.sound(-3.0, 19.0);
  EXPECT_EQ(speaker.actuate().level, 0.0);
  EXPECT_EQ(speaker.actuate().frequency, 20.0);
  speaker.command.level = std::nan("");
  speaker.actuate();
  EXPECT_EQ(speaker.faulty.size(), 1U);
}

std::shared_ptr<EntityModel> withMicrophones(const std::vector<Eigen::Vector3d>& places) {
  auto model = std::make_shared<EntityModel>(*robotModel("eyebot"));
  for (std::size_t i = 0; i < places.size(); ++i) {
    model->mounts["microphone_" + std::to_string(i)].position = places[i];
  }
  return model;
}

TEST(SoundTest, AnyRobotHearsWithWhatItHas) {
  DeviceWorld world;
  const std::vector<Eigen::Vector3d> places{{0.11, 0.02, 0.05}, {-0.13, 0.04, 0.1}, {0.0, -0.2, 0.0}};
  const Eigen::Vector3d origin(5.0, 6.0, 1.3);
  const Row robot = world.add(withMicrophones(places), origin);
  const Eigen::Vector3d horn(4.2, 6.9, 0.4);
  world.add(loudspeaker("81"), horn);
  SensorUnderTest<Microphones> sensor(world, robot, {{"background", "12"}});
  const Microphones& heard = sensor.sense();
  ASSERT_EQ(heard.sensors.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const double distance = (origin + places[i] - horn).norm();
    EXPECT_NEAR(heard.sensors[i].level, sumOf({levelAt(81.0, distance), 12.0}), 1e-5) << i;
    EXPECT_NEAR(heard.sensors[i].x, places[i].x(), 1e-7);
    EXPECT_NEAR(heard.sensors[i].y, places[i].y(), 1e-7);
  }
  // from the centre of the three, (-0.02 / 3, -0.14 / 3) from the origin
  EXPECT_NEAR(heard.loudest.bearing, std::atan2(0.9 + 0.14 / 3.0, -0.8 + 0.02 / 3.0), 1e-6);
}

TEST(SoundTest, TwoMicrophonesCannotTellFrontFromBack) {
  DeviceWorld world;
  const Row robot = world.add(withMicrophones({{0.0, 0.1, 0.0}, {0.0, -0.1, 0.0}}), {5.0, 6.0, 1.3});
  world.add(loudspeaker("81"), {4.2, 6.9, 0.4});
  SensorUnderTest<Microphones> sensor(world, robot);
  const Microphones& heard = sensor.sense();
  EXPECT_EQ(heard.loudest.bearing, 0.0F);
  EXPECT_EQ(heard.loudest.confidence, 0.0F);
  EXPECT_EQ(heard.loudest.frequency, 440.0F);
  EXPECT_GT(heard.sensors[0].level, heard.sensors[1].level + 0.5F);
}

TEST(SoundTest, RobotsWithoutThePartsAreRefused) {
  EXPECT_EQ(refusalOf<SensorUnderTest<Microphones>>(robotModel("eyebot")),
            "found the device 'microphones' on a eyebot, allowed: on robots with links microphone_0, ... (1 to 64)");
  auto model = std::make_shared<EntityModel>(*robotModel("footbot"));
  model->mounts["loudspeaker"].position = {0.0, 0.0, 0.318};
  EXPECT_EQ(refusalOf<ActuatorUnderTest<Loudspeaker>>(model),
            "found the device 'loudspeaker' on a footbot whose transmitter (the link loudspeaker, or the middle of its "
            "height) is 0.172 m outside of its solids, allowed: at most 0.1 m");
}

/// A crowd in which each robot has a loudspeaker that sounds, and some loudspeakers in the arena.
struct Crowd {
  explicit Crowd(DeviceWorld& world)
      : ears(makeDevice<Sensor>(PluginKind::kSensor, FootbotMicrophones::kType, {{"range", "1.9"}, {"shadow", "7"}})),
        speakers(makeDevice<Actuator>(PluginKind::kActuator, Loudspeaker::kType, {})) {
    for (int i = 0; i < 9; ++i) {
      const Row row = world.addFootbot(3.0 + 0.31 * i, 4.0 + 0.37 * (i % 4), 0.9 * i);
      heard.push_back(static_cast<const FootbotMicrophones*>(ears->add(world.space, row)));
      static_cast<Loudspeaker*>(speakers->add(world.space, row))->sound(50.0 + 1.7 * i, 300.0 + 10.0 * i);
      world.add(loudspeaker(std::to_string(61 + i)), {2.9 + 0.4 * i, 5.9 - 0.2 * i, 0.1 * i});
    }
    world.actuate(*speakers);
    world.takePoses();
  }

  std::shared_ptr<Sensor> ears;
  std::shared_ptr<Actuator> speakers;
  std::vector<const FootbotMicrophones*> heard;
};

TEST(SoundTest, TheSameIsHeardHoweverTheRobotsAreSharedAmongThreads) {
  const auto heardBy = [](std::size_t threads) {
    DeviceWorld world;
    const Crowd crowd(world);
    std::vector<std::thread> workers;
    for (std::size_t k = 0; k < threads; ++k) {
      workers.emplace_back([&, k] { crowd.ears->sense(world.space, k * 9 / threads, (k + 1) * 9 / threads); });
    }
    for (std::thread& worker : workers) {
      worker.join();
    }
    std::vector<float> numbers;
    for (const FootbotMicrophones* each : crowd.heard) {
      numbers.insert(numbers.end(), each->level.begin(), each->level.end());
      numbers.insert(numbers.end(), {each->loudest.bearing, each->loudest.confidence, each->loudest.frequency});
    }
    return numbers;
  };
  const std::vector<float> expected = heardBy(1);
  EXPECT_GT(expected[0], 50.0F);
  EXPECT_EQ(heardBy(2), expected);
  EXPECT_EQ(heardBy(4), expected);
}

TEST(SoundTest, ASteadyStateTouchesNoHeap) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  DeviceWorld world;
  const Crowd crowd(world);
  crowd.ears->update(world.space, 0, 9);
  const long before = heap_allocations;
  crowd.ears->update(world.space, 0, 9);
  world.actuate(*crowd.speakers);
  EXPECT_EQ(heap_allocations - before, 0);
}

}  // namespace
}  // namespace swarmanoid::test
