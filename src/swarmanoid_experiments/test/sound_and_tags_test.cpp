// Robots that call, listen, and write to radio tags, in whole simulations: in each engine, readings are the same with
// any number of threads and in repeated runs.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_microphones.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/loudspeaker.hpp"
#include "swarmanoid_interface/devices/rfid.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {
namespace {

/// Drives around, calls at times, turns to the loudest source, and adds 1 to the tags within reach.
class TestCaller final : public Controller {
 public:
  void init(Robot& robot, const Configuration&) override {
    robot_ = &robot;
    wheels_ = &robot.actuator<FootbotWheels>();
    speaker_ = &robot.actuator<Loudspeaker>();
    writer_ = &robot.actuator<RfidWriter>();
    ears_ = &robot.sensor<FootbotMicrophones>();
    reader_ = &robot.sensor<RfidReader>();
  }

  void step(Time, Duration) override {
    RandomStream& random = robot_->random();
    const double turn = ears_->loudest.confidence > 0.3F ? ears_->loudest.bearing : random.uniform(-2.0, 2.0);
    wheels_->drive(0.2, turn);
    speaker_->sound(random.uniform() < 0.4 ? random.uniform(40.0, 80.0) : 0.0, 440.0);
    *writer_ = RfidWriter{};
    if (!reader_->tags.empty()) {
      writer_->write(reader_->tags[0].data + 1, reader_->tags[0].id);
    }
  }

 private:
  Robot* robot_ = nullptr;
  FootbotWheels* wheels_ = nullptr;
  Loudspeaker* speaker_ = nullptr;
  RfidWriter* writer_ = nullptr;
  const FootbotMicrophones* ears_ = nullptr;
  const RfidReader* reader_ = nullptr;
};

/// Two configurations, so that robots of both write to the same tags.
std::string controllers() {
  std::string text;
  for (const char* id : {"one", "other"}) {
    text += std::string("<test_caller id='") + id +
            "' library='swarmanoid_devices'><actuators><footbot_wheels/><loudspeaker/><rfid_writer><reach>0.2</reach>"
            "</rfid_writer></actuators><sensors><footbot_microphones><shadow>9</shadow><error kind='gaussian' "
            "field='loudest.bearing' deviation='0.1'/></footbot_microphones><rfid_reader><reach>0.2</reach>"
            "</rfid_reader></sensors><parameters/></test_caller>";
  }
  return text;
}

std::string entity(const std::string& type, const std::string& id, double x, double y, const std::string& more) {
  return "<" + type + " id='" + id + "'><position>" + std::to_string(x) + "," + std::to_string(y) +
         ",0</position><orientation>0,0,33</orientation>" + more + "</" + type + ">";
}

std::unique_ptr<Simulation> started(const std::string& engine, int threads) {
  loadBuiltInPlugins();
  std::string entities = entity("loudspeaker", "horn", 2.3, 2.9, "<sound_level>66</sound_level>");
  std::string members;
  for (int i = 0; i < 8; ++i) {
    const std::string id = "fb_" + std::to_string(i);
    const std::string controller = i % 3 == 0 ? "other" : "one";
    entities +=
        entity("footbot", id, 1.1 + 0.43 * (i % 4), 1.2 + 0.9 * (i / 4), "<controller>" + controller + "</controller>");
    members += "<entity id='" + id + "'/>";
  }
  for (int i = 0; i < 25; ++i) {
    entities += entity("rfid_tag", "tag_" + std::to_string(i), 0.6 + 0.5 * (i % 5), 0.7 + 0.5 * (i / 5),
                       "<tag>" + std::to_string(i + 1) + "</tag>");
  }
  const std::string text =
      "<ahss-config><framework><clocktick>100</clocktick><maxclock>10000</maxclock><random_seed>5"
      "</random_seed><threads>" +
      std::to_string(threads) + "</threads></framework><controllers>" + controllers() +
      "</controllers><arena size='3.2,3.2,2' optimization='2D' bounded='true'>" + entities + "</arena><engines><" +
      engine + " id='ground'/></engines><arena_physics><engine id='ground'>" + members +
      "</engine></arena_physics></ahss-config>";
  auto simulation = std::make_unique<Simulation>(parseExperiment(text, "sound_and_tags.xml"));
  simulation->start();
  return simulation;
}

std::vector<std::uint64_t> hashesOf(Simulation& simulation, int ticks) {
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < ticks; ++i) {
    simulation.tick();
    hashes.push_back(deepHash(simulation.space()));
  }
  return hashes;
}

double sumOfTags(const Simulation& simulation) {
  const Space& space = simulation.space();
  double sum = 0.0;
  for (int i = 0; i < 25; ++i) {
    sum += *space.property(space.entities.find("tag_" + std::to_string(i)), "tag_data");
  }
  return sum;
}

class SoundAndTagsTest : public testing::TestWithParam<const char*> {};

TEST_P(SoundAndTagsTest, TheSameIsHeardAndWrittenOnTwoThreadsAndAfterAReset) {
  const auto simulation = started(GetParam(), 1);
  const auto expected = hashesOf(*simulation, 150);
  const double written = sumOfTags(*simulation);
  EXPECT_GT(written, 20.0);
  EXPECT_EQ(hashesOf(*started(GetParam(), 2), 150), expected) << "on two threads";
  simulation->apply(SetProperty{"horn", "sound_level", "0"});
  simulation->reset();
  EXPECT_EQ(sumOfTags(*simulation), 0.0);
  EXPECT_EQ(hashesOf(*simulation, 150), expected) << "after a reset";
  EXPECT_EQ(sumOfTags(*simulation), written);
}

INSTANTIATE_TEST_SUITE_P(Engines, SoundAndTagsTest, testing::Values("kinematics2d", "dynamics2d", "dynamics3d"));

TEST(SoundInTheArenaTest, AServiceSwitchesIt) {
  const auto simulation = started("kinematics2d", 1);
  const Space& space = simulation->space();
  simulation->apply(SetProperty{"horn", "sound_level", "0"});
  EXPECT_EQ(space.property(space.entities.find("horn"), "sound_level"), 0.0);
  try {
    simulation->apply(SetProperty{"horn", "sound_level", "140.5"});
    FAIL() << "too loud";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(), "sound_level of loudspeaker 'horn': found '140.5', allowed: a number from 0 to 140");
  }
}

}  // namespace
}  // namespace swarmanoid::test

REGISTER_CONTROLLER(swarmanoid::test::TestCaller, "test_caller")
