// Controllers that step all robots of a configuration in one call.
#include <gtest/gtest.h>

#include <stdexcept>

#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_space/group_controller.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kTick = 0.1;  // s

/// Drives each robot faster with its place in the order of stepping, and records the stepped robots.
class Convoy final : public GroupController {
 public:
  void init(const Configuration& parameters) override {
    ++starts;
    unit = parameters.number("unit");
    if (unit > 3.0) {
      throw ConfigError({}, "too fast");
    }
  }

  void start(const Space& /*space*/, Banks& /*commands*/, Row /*row*/, Robot& robot) override {
    if (robot.name() == does_not_start) {
      throw std::runtime_error("not this one");
    }
    started.push_back(robot.name());
  }

  void step(const Space& space, Banks& commands, Span<const GroupMember> members) override {
    names.clear();
    draws.clear();
    for (std::size_t i = 0; i < members.size(); ++i) {
      names.push_back(members[i].robot->name());
      draws.push_back(members[i].robot->random().uniform());
      const double speed = unit * static_cast<double>(i + 1);
      static_cast<FootbotWheels*>(commands.find(FootbotWheels::kType, members[i].row))
          ->setAngularVelocity(speed, speed);
    }
    if (space.tick == fails_in) {
      throw std::runtime_error("lost the convoy");
    }
    if (space.tick == first_fails_in) {
      *members[0].failure = "out of breath";
    }
  }

  std::vector<std::string> names;
  std::vector<double> draws;
  std::vector<std::string> started;
  std::string does_not_start;
  std::uint64_t fails_in = ~std::uint64_t{0};
  std::uint64_t first_fails_in = ~std::uint64_t{0};
  double unit = 0.0;  // rad/s
  int starts = 0;
};

using Names = std::vector<std::string>;

/// Three footbots in a row; `a` and `c` are in the group.
class GroupControllerTest : public testing::Test {
 protected:
  GroupControllerTest() {
    World world;
    world.entities = footbot("a", 1.0, 2.0, 0.0) + footbot("b", 1.0, 4.0, 0.0) + footbot("c", 1.0, 6.0, 0.0);
    world.members = member("a") + member("b") + member("c");
    world.drive = "<left>0</left><right>0</right>";
    experiment_ = world.make()->experiment();
    ControllerDescription other = experiment_.controllers.front();
    experiment_.controllers.front().parameters.set("unit", "1.7");
    other.id = "other";
    other.parameters = Configuration("parameters", "", {});
    other.parameters.set("left", "4");
    other.parameters.set("right", "4");
    experiment_.controllers.push_back(other);
    experiment_.arena.entities[1].controller = "other";
  }

  Simulation& start() {
    SuppliedParts parts;
    parts.group_controllers["drive"] = convoy_;
    simulation_ = std::make_unique<Simulation>(experiment_, RunContext{}, std::move(parts));
    simulation_->start();
    return *simulation_;
  }
  /// Displacement of a robot from its start, as a speed of the wheels for one tick [rad/s].
  double driven(const std::string& robot) const {
    return (poseOf(*simulation_, robot).position.x() - 1.0) / (FootbotWheels::kRadius * kTick);
  }

  Experiment experiment_;
  std::shared_ptr<Convoy> convoy_ = std::make_shared<Convoy>();
  std::unique_ptr<Simulation> simulation_;
};

TEST_F(GroupControllerTest, StepsTheRobotsOfItsConfigurationInTheirOrder) {
  tick(start());
  EXPECT_EQ((Names{"a", "c"}), convoy_->names);
  EXPECT_NEAR(1.7, driven("a"), 1e-9);
  EXPECT_NEAR(4.0, driven("b"), 1e-9) << "has a controller of its own";
  EXPECT_NEAR(3.4, driven("c"), 1e-9);
  EXPECT_EQ(StepStatus::kStepped, simulation_->space().controllers[simulation_->space().entities.find("a")].status);
}

TEST_F(GroupControllerTest, RobotsDrawTheNumbersThatSingleControllersWould) {
  Simulation& simulation = start();
  tick(simulation, 3);
  Robot alone("c", "footbot", simulation.space().seed);
  alone.startTick(2, kEpoch);
  EXPECT_EQ(alone.random().uniform(), convoy_->draws[1]);
  EXPECT_NE(convoy_->draws[0], convoy_->draws[1]);
}

TEST_F(GroupControllerTest, AnExceptionStopsItsRobotsOnly) {
  Simulation& simulation = start();
  convoy_->fails_in = 2;
  tick(simulation, 5);
  ASSERT_EQ(2U, simulation.failures().size());
  EXPECT_EQ("a", simulation.failures()[0].robot);
  EXPECT_EQ("c", simulation.failures()[1].robot);
  EXPECT_EQ(2U, simulation.failures()[1].tick);
  EXPECT_NE(std::string::npos, simulation.failures()[1].reason.find("lost the convoy"));
  EXPECT_NEAR(2 * 1.7, driven("a"), 1e-9) << "stands since the tick in which it was lost";
  EXPECT_NEAR(5 * 4.0, driven("b"), 1e-9);
  EXPECT_EQ(Names{}, convoy_->names) << "those that have failed are not stepped again";
}

TEST_F(GroupControllerTest, AFailureThatItWritesDownStopsThatRobotOnly) {
  Simulation& simulation = start();
  convoy_->first_fails_in = 2;
  tick(simulation, 4);
  ASSERT_EQ(1U, simulation.failures().size());
  EXPECT_EQ("a", simulation.failures()[0].robot);
  EXPECT_EQ(2U, simulation.failures()[0].tick);
  EXPECT_EQ("out of breath", simulation.failures()[0].reason);
  EXPECT_NEAR(2 * 1.7, driven("a"), 1e-9);
  EXPECT_NEAR(3 * 3.4 + 1.7, driven("c"), 1e-9) << "is the first one then";
  EXPECT_EQ(Names{"c"}, convoy_->names);
}

TEST_F(GroupControllerTest, NobodyCommandsWhoHasFailedUntilAReset) {
  Simulation& simulation = start();
  convoy_->first_fails_in = 2;
  tick(simulation, 4);
  EXPECT_TRUE(simulation.space().interventions.empty());
  simulation.apply(SetCommandSource{"a", CommandSource::kNone});
  try {
    simulation.apply(SetCommandSource{"a", CommandSource::kController});
    ADD_FAILURE() << "it would never be stepped";
  } catch (const ConfigError& error) {
    EXPECT_STREQ("'a' cannot be commanded by controller: it has failed, and stays stopped until a reset", error.what());
  }
  tick(simulation);
  EXPECT_EQ(1U, simulation.space().interventions.size()) << "what is refused is none";
  EXPECT_EQ((Names{"a", "c"}), convoy_->started);
  convoy_->first_fails_in = ~std::uint64_t{0};
  simulation.reset();
  tick(simulation);
  EXPECT_EQ((Names{"a", "c"}), convoy_->names);
}

TEST_F(GroupControllerTest, HearsWhichRobotsStart) {
  Simulation& simulation = start();
  EXPECT_EQ((Names{"a", "c"}), convoy_->started);
  simulation.apply(SetCommandSource{"a", CommandSource::kNone});
  tick(simulation);
  simulation.apply(SetCommandSource{"a", CommandSource::kController});
  EXPECT_EQ((Names{"a", "c", "a"}), convoy_->started);
  simulation.reset();
  EXPECT_EQ((Names{"a", "c", "a", "a", "c"}), convoy_->started);
  convoy_->does_not_start = "c";
  EXPECT_THROW(start(), ConfigError);
}

TEST_F(GroupControllerTest, WhomAnotherSourceCommandsIsNotStepped) {
  Simulation& simulation = start();
  tick(simulation);
  simulation.apply(SetCommandSource{"a", CommandSource::kNone});
  tick(simulation);
  EXPECT_EQ(Names{"c"}, convoy_->names);
  EXPECT_NEAR(1.7, driven("a"), 1e-9);
  simulation.apply(SetCommandSource{"a", CommandSource::kController});
  tick(simulation);
  EXPECT_EQ((Names{"a", "c"}), convoy_->names);
  EXPECT_NEAR(2 * 1.7, driven("a"), 1e-9);
}

TEST_F(GroupControllerTest, WhoIsDeletedIsNotStepped) {
  Simulation& simulation = start();
  tick(simulation);
  simulation.apply(DeleteEntity{"a"});
  tick(simulation);
  EXPECT_EQ(Names{"c"}, convoy_->names);
}

TEST_F(GroupControllerTest, BeginsAnewWithEachReset) {
  Simulation& simulation = start();
  EXPECT_EQ(1, convoy_->starts);
  const std::vector<std::uint64_t> first = hashesOf(simulation, 4);
  simulation.reset();
  EXPECT_EQ(2, convoy_->starts);
  EXPECT_EQ(first, hashesOf(simulation, 4));
}

/// External code may read the sensors before a tick: the bits equal those of a tick that reads them itself.
TEST_F(GroupControllerTest, SensingBeforeATickChangesNothingInIt) {
  Simulation& simulation = start();
  const std::vector<std::uint64_t> alone = hashesOf(simulation, 5);
  simulation.reset();
  std::vector<std::uint64_t> sensed;
  for (int i = 0; i < 5; ++i) {
    simulation.sense();
    simulation.sense();
    tick(simulation);
    sensed.push_back(simulation.stateHash());
  }
  EXPECT_EQ(alone, sensed);
}

TEST_F(GroupControllerTest, WhatItsInitThrowsRefusesTheExperiment) {
  experiment_.controllers.front().parameters = Configuration("parameters", "", {});
  experiment_.controllers.front().parameters.set("unit", "3.5");
  EXPECT_THROW(start(), ConfigError);
}

}  // namespace
}  // namespace swarmanoid::test
