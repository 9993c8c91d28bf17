// Controllers that communicate by range and bearing, in whole simulations: the ticks in which messages arrive, with
// controllers in any process and with any number of threads, and occlusion in each engine.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "lockstep_world.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"

namespace swarmanoid::test {
namespace {

/// Communicates according to its parameter `role`: "starts" sends 1 in its first tick, and then, like "answers", sends
/// n + 1 in each tick in which it receives n; "names_itself" always sends the number in its name; "chats" drives around
/// and sends arbitrary messages at times.
class TestTalker final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    wheels_ = &robot.actuator<FootbotWheels>();
    board_ = &robot.actuator<RangeAndBearing>();
    received_ = &robot.sensor<RangeAndBearingReceived>();
    role_ = parameters.text("role");
    parameters.refuseUnread();
  }

  void step(Time, Duration) override {
    int heard = 0;
    for (const RangeAndBearingMessage& message : received_->messages) {
      heard = message.payload[0];
    }
    robot_->debug("heard", std::to_string(heard));
    board_->fallSilent();
    if (role_ == "names_itself") {
      const std::string& name = robot_->name();
      board_->send({static_cast<std::uint8_t>(std::stoi(name.substr(name.find('_') + 1)))});
    } else if (role_ == "chats") {
      chat();
    } else if (heard > 0 || (role_ == "starts" && is_first_)) {
      board_->send({static_cast<std::uint8_t>(heard + 1)});
    }
    is_first_ = false;
  }

 private:
  void chat() {
    RandomStream& random = robot_->random();
    wheels_->setAngularVelocity(random.uniform(-5.0, 10.0), random.uniform(-5.0, 10.0));
    if (random.uniform() < 0.7) {
      board_->send({static_cast<std::uint8_t>(random.below(256)), static_cast<std::uint8_t>(random.below(256))});
    }
  }

  Robot* robot_ = nullptr;
  FootbotWheels* wheels_ = nullptr;
  RangeAndBearing* board_ = nullptr;
  const RangeAndBearingReceived* received_ = nullptr;
  std::string role_;
  bool is_first_ = true;
};

std::string controller(const std::string& role, const std::string& receiver = "") {
  return "<test_talker id='" + role +
         "' library='swarmanoid_devices'><actuators><footbot_wheels/><range_and_bearing/></actuators><sensors>"
         "<range_and_bearing_received>" +
         receiver + "</range_and_bearing_received></sensors><parameters><role>" + role +
         "</role></parameters></test_talker>";
}

std::string memberLine(const std::string& id) { return "<entity id='" + id + "'/>"; }

struct TalkingWorld {
  std::string controllers;
  std::string entities;
  std::string members;
  std::string engine = "<kinematics2d id='ground'/>";
  int threads = 1;

  std::unique_ptr<Simulation> start() const {
    loadBuiltInPlugins();
    const std::string text = "<ahss-config><framework><clocktick>100</clocktick><maxclock>1000</maxclock><threads>" +
                             std::to_string(threads) + "</threads></framework><controllers>" + controllers +
                             "</controllers><arena size='6,6,2' optimization='2D' bounded='true'>" + entities +
                             "</arena><engines>" + engine + "</engines><arena_physics><engine id='ground'>" + members +
                             "</engine></arena_physics></ahss-config>";
    auto simulation = std::make_unique<Simulation>(parseExperiment(text, "messages.xml"));
    simulation->start();
    return simulation;
  }
};

std::string talker(const std::string& id, double x, double y, const std::string& role,
                   const std::string& source = "controller") {
  return "<footbot id='" + id + "'><position>" + std::to_string(x) + "," + std::to_string(y) +
         ",0</position><orientation>0,0,33</orientation><controller source='" + source + "'>" + role +
         "</controller></footbot>";
}

/// A starts and B answers; each has its own configuration.
TalkingWorld twoWhoTalk(const std::string& source_of_b = "controller") {
  TalkingWorld world;
  world.controllers = controller("starts") + controller("answers");
  world.entities = talker("a", 2.0, 2.0, "starts") + talker("b", 3.7, 2.9, "answers", source_of_b);
  world.members = memberLine("a") + memberLine("b");
  return world;
}

int heardBy(const Simulation& simulation, const std::string& robot) {
  const Space& space = simulation.space();
  const auto* received = space.readings.find<RangeAndBearingReceived>(space.entities.find(robot));
  return received->messages.empty() ? 0 : received->messages[0].payload[0];
}

TEST(MessagesTest, AnAnswerArrivesInTheTickAfterTheOneInWhichItIsGiven) {
  const auto simulation = twoWhoTalk().start();
  for (int tick = 0; tick < 60; ++tick) {
    simulation->tick();
    // A sends 1 in tick 0, B receives it in tick 1 and sends 2, A receives that in tick 2 and sends 3, and so on
    EXPECT_EQ(heardBy(*simulation, "a"), tick % 2 == 0 ? tick : 0) << "tick " << tick;
    EXPECT_EQ(heardBy(*simulation, "b"), tick % 2 == 1 ? tick : 0) << "tick " << tick;
  }
}

TEST(MessagesTest, InLockstepMessagesArriveInTheSameTicks) {
  const auto here = twoWhoTalk().start();
  const auto elsewhere = twoWhoTalk("remote").start();
  FakeParticipant participant(*elsewhere, "p", {"b"});
  participant.join();
  for (int tick = 0; tick < 60; ++tick) {
    here->tick();
    elsewhere->tick();
    ASSERT_EQ(deepHash(here->space()), deepHash(elsewhere->space())) << "tick " << tick;
  }
  EXPECT_EQ(heardBy(*elsewhere, "b"), 59);
}

TEST(MessagesTest, AResetBeginsTheConversationAnew) {
  const auto simulation = twoWhoTalk().start();
  std::vector<std::uint64_t> hashes;
  for (int round = 0; round < 2; ++round) {
    for (int tick = 0; tick < 9; ++tick) {
      simulation->tick();
      const std::uint64_t hash = deepHash(simulation->space());
      if (round == 0) {
        hashes.push_back(hash);
      } else {
        EXPECT_EQ(hash, hashes[static_cast<std::size_t>(tick)]) << "tick " << tick;
      }
    }
    simulation->reset();
  }
}

TEST(MessagesTest, RobotsThatComeAndGo) {
  const auto simulation = twoWhoTalk().start();
  simulation->tick();  // A has sent 1
  EntityDescription late;
  late.type = "footbot";
  late.id = "late";
  late.position = {2.0, 3.5, 0.0};
  late.controller = "answers";
  simulation->apply(SpawnEntity{late, {"ground"}});
  simulation->tick();
  EXPECT_EQ(heardBy(*simulation, "late"), 1) << "in its first tick";
  EXPECT_EQ(heardBy(*simulation, "b"), 1);
  simulation->apply(DeleteEntity{"b"});  // after it has sent 2
  simulation->tick();
  const Space& space = simulation->space();
  const auto* received = space.readings.find<RangeAndBearingReceived>(space.entities.find("a"));
  ASSERT_EQ(received->messages.size(), 1U) << "late's 2, and nothing of who is gone";
  EXPECT_NEAR(received->messages[0].range, 1.5, 1e-6);
}

/// @param quantity of robots, at random positions among blocks
TalkingWorld crowd(const std::string& role, int quantity, const std::string& receiver = "") {
  TalkingWorld world;
  world.controllers = controller(role, receiver);
  int count = 0;
  for (const char* block : {"2,2,0.2</position><orientation>0,0,20</orientation><size>1.1,0.05,0.4",
                            "4,2.5,0.0675</position><orientation>0,0,0</orientation><size>0.05,1.4,0.135",
                            "3,4,0.06</position><orientation>0,0,70</orientation><size>0.9,0.05,0.12"}) {
    const std::string id = "block_" + std::to_string(++count);
    world.entities += "<block id='" + id + "'><position>" + block + "</size></block>";
    world.members += memberLine(id);
  }
  world.entities += "<distribute quantity='" + std::to_string(quantity) +
                    "' layout='uniform'><minimum>0.3,0.3,0</minimum><maximum>5.7,5.7,0</maximum><footbot id='fb'>"
                    "<controller>" +
                    role + "</controller></footbot></distribute>";
  world.members += memberLine("fb");
  return world;
}

TEST(MessagesTest, AnyNumberOfThreadsGivesTheSameBits) {
  TalkingWorld world = crowd("chats", 150, "<loss>0.2</loss><slots>7</slots>");
  const auto hashesOn = [&](int threads) {
    world.threads = threads;
    const auto simulation = world.start();
    std::vector<std::uint64_t> hashes;
    for (int tick = 0; tick < 40; ++tick) {
      simulation->tick();
      hashes.push_back(deepHash(simulation->space()));
    }
    return hashes;
  };
  const auto alone = hashesOn(1);
  EXPECT_EQ(hashesOn(2), alone);
  EXPECT_EQ(hashesOn(4), alone);
}

/// Numbers of the robots that should be heard, computed from the space's lines of sight between transmitters.
std::vector<int> audibleTo(const Space& space, Row self) {
  constexpr double kRange = 3.0;
  const Eigen::Vector3d transmitter(0.0, 0.0, 0.13);
  std::vector<int> audible;
  for (const Row row : space.entities.order) {
    if (row == self || space.entities.model[row]->type != "footbot") {
      continue;
    }
    const Segment line{space.entities.pose[self].toWorld(transmitter), space.entities.pose[row].toWorld(transmitter)};
    if ((line.to - line.from).norm() <= kRange && !space.isOccluded(line, self, row)) {
      audible.push_back(std::stoi(space.entities.name[row].substr(3)));
    }
  }
  return audible;
}

class MessagesInEngines : public testing::TestWithParam<const char*> {};

TEST_P(MessagesInEngines, WhoIsHeardIsWhomTheEnginesRaysReach) {
  TalkingWorld world = crowd("names_itself", 50);
  world.engine = GetParam();
  const auto simulation = world.start();
  simulation->tick();
  std::vector<std::pair<Row, std::vector<int>>> expected;
  std::size_t audible = 0;
  for (const Row row : simulation->space().entities.order) {
    if (simulation->space().entities.model[row]->type == "footbot") {
      expected.emplace_back(row, audibleTo(simulation->space(), row));
      audible += expected.back().second.size();
    }
  }
  simulation->tick();
  for (const auto& [row, numbers] : expected) {
    std::vector<int> heard;
    for (const RangeAndBearingMessage& message :
         simulation->space().readings.find<RangeAndBearingReceived>(row)->messages) {
      heard.push_back(message.payload[0]);
    }
    EXPECT_EQ(heard, numbers) << simulation->space().entities.name[row];
  }
  EXPECT_GT(audible, 200U);
  EXPECT_LT(audible, 1200U) << "some are hidden: without that about 1,370 of 2,450 pairs are in range";
}

INSTANTIATE_TEST_SUITE_P(All, MessagesInEngines,
                         testing::Values("<kinematics2d id='ground'/>",
                                         "<dynamics2d id='ground'><subclock>10</subclock></dynamics2d>",
                                         "<dynamics3d id='ground'><subclock>20</subclock></dynamics3d>"));

}  // namespace
}  // namespace swarmanoid::test

REGISTER_CONTROLLER(swarmanoid::test::TestTalker, "test_talker")
