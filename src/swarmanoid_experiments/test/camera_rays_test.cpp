// In each engine, cameras report exactly the LEDs that a ray to each LED finds, to the last bit.
#include <gtest/gtest.h>

#include <random>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/sensor.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"
#include "swarmanoid_space/testing/plain_rays.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kRange = 1.5;  // m

/// Handbots in a row; no controller turns their arms.
constexpr int kHandbots = 5;

/// Footbots that drive between walls, blocks and handbots.
std::string crowd(const std::string& engine) {
  std::string blocks;
  std::string members;
  for (int i = 0; i < 6; ++i) {
    const std::string id = "b" + std::to_string(i);
    const std::string place = std::to_string(0.6 + 0.7 * i) + "," + std::to_string(0.7 + 0.53 * ((i * 5) % 6));
    blocks += "<block id='" + id + "'><position>" + place + ",0.15</position><orientation>0,0," +
              std::to_string(37 * i) + "</orientation><size>0.4,0.05,0.3</size></block>";
    members += "<entity id='" + id + "'/>";
  }
  for (int i = 0; i < kHandbots; ++i) {
    const std::string id = "hb" + std::to_string(i);
    blocks += "<handbot id='" + id + "'><position>" + std::to_string(0.5 + 0.95 * i) +
              ",4.1,0</position><orientation>0,0," + std::to_string(71 * i) + "</orientation></handbot>";
    members += "<entity id='" + id + "'/>";
  }
  return "<ahss-config><framework><clocktick>100</clocktick><maxclock>1000</maxclock><random_seed>3</random_seed>"
         "</framework><controllers><diffusion id='dc' library='diffusion'><actuators><footbot_wheels/></actuators>"
         "<sensors><footbot_proximity><range>0.1</range></footbot_proximity><footbot_camera><range>1.5</range>"
         "<max_blobs>1000</max_blobs></footbot_camera></sensors></diffusion></controllers>"
         "<arena size='5,4.5,1' optimization='2D' bounded='true'>" +
         blocks +
         "<distribute quantity='25' layout='uniform'><minimum>0.2,0.2,0</minimum><maximum>4.8,3.8,0</maximum>"
         "<max_trials>10000</max_trials><footbot id='fb'><controller>dc</controller></footbot></distribute>"
         "</arena><engines><" +
         engine + " id='ground'/></engines><arena_physics><engine id='ground'>" + "<entity id='fb'/>" + members +
         "</engine></arena_physics></ahss-config>";
}

/// Raises and bends the arms of all entities that have arms.
void turnArms(Space& space, std::mt19937_64& random) {
  for (const Row row : space.entities.order) {
    const EntityModel& model = *space.entities.model[row];
    if (model.joints_keep_outline) {
      continue;
    }
    for (std::size_t k = 0; k < model.joints.size(); ++k) {
      std::uniform_real_distribution<double> angle(model.joints[k].lower, model.joints[k].upper);
      space.joints[row][k].angle = angle(random);
    }
    const_cast<Engine*>(space.mover[row])->place(space, row);  // as the simulation does after a move from outside
  }
}

class CameraRaysTest : public testing::TestWithParam<const char*> {};

TEST_P(CameraRaysTest, AreThoseToEachLed) {
  loadBuiltInPlugins();
  Simulation simulation(parseExperiment(crowd(GetParam()), "crowd.xml"));
  simulation.start();
  Space& space = const_cast<Space&>(simulation.space());  // lights LEDs, which no controller commands
  std::mt19937_64 random(11);
  std::vector<std::vector<SeenLed>> expected;
  std::size_t in_sight = 0;
  for (int tick = 0; tick < 8; ++tick) {
    turnArms(space, random);
    for (const Row row : space.entities.order) {
      for (Color& color : space.leds[row]) {
        color = {static_cast<std::uint8_t>(random() % 256), static_cast<std::uint8_t>(random() % 256), 0};
      }
    }
    expected.clear();
    for (const Row row : space.entities.order) {
      const Eigen::Vector3d eye = space.entities.pose[row].toWorld({0.0, 0.0, FootbotCamera::kMount});
      expected.push_back(ledsByPlainRays(space, row, eye, kRange));
    }
    simulation.tick();  // sensors are read first
    for (std::size_t k = 0; k < space.entities.order.size(); ++k) {
      const Row row = space.entities.order[k];
      if (const auto* camera = space.readings.find<FootbotCamera>(row)) {
        EXPECT_EQ(ledsOf(*camera), expected[k]) << space.entities.name[row] << " in tick " << tick;
        in_sight += expected[k].size();
      }
    }
  }
  EXPECT_GT(in_sight, 8U * 25U * 10U);
  EXPECT_LT(in_sight, 8U * 25U * 24U * 12U / 3U) << "something hides many";
}

INSTANTIATE_TEST_SUITE_P(Engines, CameraRaysTest, testing::Values("kinematics2d", "dynamics2d", "dynamics3d"),
                         [](const auto& engine) { return std::string(engine.param); });

}  // namespace
}  // namespace swarmanoid::test
