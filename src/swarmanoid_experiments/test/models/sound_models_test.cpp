// The formula of docs/reference/models.md, "Sensing": sound.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "model_world.hpp"
#include "swarmanoid_interface/devices/footbot_microphones.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/loudspeaker.hpp"

namespace swarmanoid::test {
namespace {

struct Source {
  Eigen::Vector3d position;
  double level;  // at 1 m, dB
  double frequency;

  double powerAt(const Eigen::Vector3d& place) const {
    return std::pow(10.0, level / 10.0) / (place - position).squaredNorm();
  }
};

/// Expected readings of the microphones of a footbot with that pose.
FootbotMicrophones expectedAt(const Pose& pose, const std::vector<Source>& sources) {
  const double background = std::pow(10.0, 3.7);
  FootbotMicrophones expected;
  for (std::size_t i = 0; i < 4; ++i) {
    const double angle = 0.5 * M_PI * static_cast<double>(i);
    double power = background;
    for (const Source& source : sources) {
      power += source.powerAt(pose.toWorld({0.07 * std::cos(angle), 0.07 * std::sin(angle), 0.146}));
    }
    expected.level[i] = static_cast<float>(10.0 * std::log10(power));
  }
  const Eigen::Vector3d middle = pose.toWorld({0.0, 0.0, 0.146});
  double total = background;
  double most = 0.0;
  for (const Source& source : sources) {
    const double power = source.powerAt(middle);
    total += power;
    if (power > most) {
      most = power;
      const Eigen::Vector3d way = pose.orientation.conjugate() * (source.position - middle);
      expected.loudest = {static_cast<float>(std::atan2(way.y(), way.x())), 0.0F, static_cast<float>(source.frequency)};
    }
  }
  expected.loudest.confidence = static_cast<float>(most / total);
  return expected;
}

void expectEqual(const FootbotMicrophones& heard, const FootbotMicrophones& expected) {
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(heard.level[i], expected.level[i], 2e-5) << i;
  }
  EXPECT_NEAR(std::remainder(heard.loudest.bearing - expected.loudest.bearing, 2.0 * M_PI), 0.0, 1e-5);
  EXPECT_NEAR(heard.loudest.confidence, expected.loudest.confidence, 1e-5);
  EXPECT_EQ(heard.loudest.frequency, expected.loudest.frequency);
}

/// A footbot on an arc hears a loudspeaker, one shadowed by a wall, and another footbot that calls in every second
/// tick, but not a source out of range.
void listenIn(const std::string& engine) {
  SCOPED_TRACE(engine);
  ModelWorld world;
  world.engine = engine;
  world.footbot_sensors =
      "<footbot_microphones><range>2.1</range><background>37</background><shadow>11</shadow></footbot_microphones>";
  world.footbot_actuators = "<loudspeaker/>";
  const auto sounds = [](double level, double frequency) {
    return join("<sound_level>", level, "</sound_level><sound_frequency>", frequency, "</sound_frequency>");
  };
  world.entities = robot("footbot", "hears", 5.0, 5.0, 0.0, 17.0) + robot("footbot", "calls", 6.3, 4.1, 0.0, 205.0) +
                   entity("loudspeaker", "free", 4.1, 5.6, 0.73, 0.0, sounds(58.0, 300.0)) +
                   entity("loudspeaker", "shadowed", 5.2, 6.4, 0.1, 0.0, sounds(66.0, 410.0)) +
                   entity("loudspeaker", "far", 2.3, 3.5, 0.1, 0.0, sounds(99.0, 99.0)) +
                   block("wall", 5.1, 5.8, 0.25, "0.8,0.05,0.5");
  world.members = "hears calls wall";
  FootbotMicrophones heard;
  int call = 0;
  setProgram([&](Robot& robot) {
    if (robot.name() == "calls") {
      robot.actuator<Loudspeaker>().sound(++call % 2 == 1 ? 71.0 : 0.0, 880.0);
      return;
    }
    robot.actuator<FootbotWheels>().drive(0.12, 0.9);
    heard = robot.sensor<FootbotMicrophones>();
  });
  auto simulation = world.start();
  double free_level = 58.0;
  for (int i = 0; i < 8; ++i) {
    if (i == 5) {
      simulation->apply(SetProperty{"free", "sound_level", "64.5"});
      free_level = 64.5;
    }
    const Pose pose = poseOf(*simulation, "hears");
    std::vector<Source> sources{{{4.1, 5.6, 0.73}, free_level, 300.0}, {{5.2, 6.4, 0.1}, 66.0 - 11.0, 410.0}};
    if (i % 2 == 1) {
      // the call of the tick before
      sources.push_back({poseOf(*simulation, "calls").toWorld({0.0, 0.0, 0.073}), 71.0, 880.0});
    }
    tick(*simulation);
    SCOPED_TRACE(i);
    expectEqual(heard, expectedAt(pose, sources));
  }
  EXPECT_GT(headingOf(*simulation, "hears"), 17.0 * kDegree + 0.4) << "it has turned on the way";
}

TEST(ModelsPageTest, SoundLevel) {
  listenIn("kinematics2d");
  listenIn("dynamics2d");
  listenIn("dynamics3d");
}

}  // namespace
}  // namespace swarmanoid::test
