// Robots that are commanded over topics: commands in the mailbox move them, silence stops them.
#include <gtest/gtest.h>

#include "swarmanoid_interface/command_mailbox.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kTick = 0.1;  // [s]

Bytes bytesOf(const FootbotWheels& wheels) {
  Bytes bytes;
  ByteWriter out(bytes);
  findDeviceType("footbot_wheels")->write(&wheels, out);
  return bytes;
}

/// A footbot at (1, 2) that faces along x; its command source is `topics`.
class CommandTopicsTest : public testing::Test {
 protected:
  CommandTopicsTest() {
    World world;
    world.entities = footbot("fb", 1.0, 2.0, 0.0);
    world.members = member("fb");
    Experiment experiment = world.make()->experiment();
    experiment.arena.entities.front().source = CommandSource::kTopics;
    experiment.arena.entities.front().command_timeout = std::chrono::milliseconds(300);
    SuppliedParts parts;
    parts.commands = mailbox_;
    simulation_ = std::make_unique<Simulation>(std::move(experiment), RunContext{}, std::move(parts));
    simulation_->start();
  }

  std::string put(double left, double right) { return mailbox_->put("fb", "footbot_wheels", bytesOf({left, right})); }
  /// @return driven distance, in ticks at `speed`
  double drive(int ticks, double speed) {
    const double before = poseOf(*simulation_, "fb").position.x();
    for (int i = 0; i < ticks; ++i) {
      simulation_->tick();
    }
    return (poseOf(*simulation_, "fb").position.x() - before) / (speed * FootbotWheels::kRadius * kTick);
  }
  std::vector<std::string> interventions() const {
    std::vector<std::string> texts;
    for (const Event& event : simulation_->space().events) {
      if (event.kind == Event::Kind::kIntervention) {
        texts.push_back(event.text);
      }
    }
    return texts;
  }

  std::shared_ptr<CommandMailbox> mailbox_ = std::make_shared<CommandMailbox>();
  std::unique_ptr<Simulation> simulation_;
};

using Texts = std::vector<std::string>;

TEST_F(CommandTopicsTest, CommandsHoldForTheTimeOutOfSimulatedTime) {
  EXPECT_EQ(0.0, drive(5, 2.0));
  EXPECT_EQ("", put(9.0, 9.0));
  EXPECT_EQ("", put(2.0, 2.0)) << "the newest counts";
  EXPECT_NEAR(1.0, drive(1, 2.0), 1e-9);
  EXPECT_EQ(Texts{"commands come over topics"}, interventions());
  EXPECT_NEAR(2.0, drive(2, 2.0), 1e-9);
  EXPECT_EQ(Texts{}, interventions());
  EXPECT_EQ(0.0, drive(1, 2.0)) << "three ticks after the command";
  EXPECT_EQ(Texts{"no more commands over topics, the robot stops"}, interventions());
  EXPECT_EQ(0.0, drive(3, 2.0));
  EXPECT_EQ("", put(2.0, 2.0));
  EXPECT_NEAR(1.0, drive(1, 2.0), 1e-9);
  EXPECT_EQ(Texts{"commands come over topics"}, interventions());
}

TEST_F(CommandTopicsTest, OnlyTheSourceTopicsTakesThem) {
  EXPECT_EQ("", put(2.0, 2.0));
  simulation_->apply(SetCommandSource{"fb", CommandSource::kNone});
  EXPECT_EQ("'fb' is not commanded over topics; its command source says by whom", put(2.0, 2.0));
  EXPECT_EQ(0.0, drive(5, 2.0)) << "what came before is forgotten too";
  try {
    simulation_->apply(SetCommandSource{"fb", CommandSource::kTopics});
    FAIL() << "nobody listens";
  } catch (const ConfigError& error) {
    EXPECT_STREQ("'fb' cannot be commanded by topics: its devices have no topics; name it in ~device_topics",
                 error.what());
  }
  mailbox_->open("fb");
  simulation_->apply(SetCommandSource{"fb", CommandSource::kTopics});
  EXPECT_EQ("", put(2.0, 2.0));
  EXPECT_NEAR(1.0, drive(1, 2.0), 1e-9);
  mailbox_->close("fb");
}

TEST_F(CommandTopicsTest, EqualCommandsInEqualTicksGiveEqualRuns) {
  const auto run = [this] {
    simulation_->reset();
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < 50; ++i) {
      if (i % 7 != 3) {
        EXPECT_EQ("", put(0.1 * i, 2.0));
      }
      simulation_->tick();
      hashes.push_back(simulation_->stateHash());
    }
    return hashes;
  };
  EXPECT_EQ(run(), run());
}

TEST_F(CommandTopicsTest, WithoutAMailboxNobodyCommandsIt) {
  Simulation simulation(simulation_->experiment());
  simulation.start();
  simulation.tick();
  EXPECT_EQ(1.0, poseOf(simulation, "fb").position.x());
  simulation.apply(SetCommandSource{"fb", CommandSource::kNone});
  try {
    simulation.apply(SetCommandSource{"fb", CommandSource::kTopics});
    FAIL() << "nobody listens";
  } catch (const ConfigError& error) {
    EXPECT_STREQ("'fb' cannot be commanded by topics: nobody listens to topics here, that needs ROS", error.what());
  }
}

}  // namespace
}  // namespace swarmanoid::test
