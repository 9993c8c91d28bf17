// Entities from services or code are checked like those of the file, with the same messages; and an engine's failure
// has no further effects.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "glide_engine.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {
namespace {

std::string fileWith(const std::string& engine, const std::string& entities = "", const std::string& members = "") {
  return R"(<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>1000</maxclock></framework>
  <arena size="5,5,2" optimization="2D">
    <footbot id="fb"><position>1, 1, 0</position><orientation>0, 0, 0</orientation></footbot>)" +
         entities + R"(
  </arena>
  <engines><)" +
         engine + R"( id="e"/><kinematics2d id="other"/></engines>
  <arena_physics><engine id="e"><entity id="fb"/>)" +
         members + R"(</engine></arena_physics>
</ahss-config>)";
}

std::unique_ptr<Simulation> world(const std::string& engine = "kinematics2d") {
  loadBuiltInPlugins();
  auto simulation = std::make_unique<Simulation>(parseExperiment(fileWith(engine), "world.xml"));
  simulation->start();
  return simulation;
}

EntityDescription prey(const Eigen::Vector3d& position, const NamedValues& values = {}) {
  EntityDescription entity;
  entity.type = "cylindric_prey";
  entity.id = "x";
  entity.position = position;
  entity.location = {"a test", 0};
  entity.parameters = Configuration("cylindric_prey", "", {});
  const bool is_bare = values.empty();
  for (const auto& [name, value] : is_bare ? NamedValues{{"radius", "0.1"}, {"height", "0.1"}} : values) {
    entity.parameters.set(name, value);
  }
  return entity;
}

std::string messageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "nothing was refused";
}

class DoorTest : public testing::TestWithParam<const char*> {};

TEST_P(DoorTest, ASpawnedEntityThatIsTwiceInAnEngineIsRefusedAsInTheFile) {
  const auto simulation = world(GetParam());
  const std::uint64_t hash = simulation->stateHash();
  const EntityDescription entity = prey({3.0, 3.0, 0.0});
  EXPECT_EQ(messageOf([&] {
              simulation->apply(SpawnEntity{entity, {"e", "e"}});
            }),
            "a test: found the entity 'x' twice in the engine 'e', allowed: once");
  EXPECT_EQ(messageOf([&] {
              simulation->apply(SpawnEntity{entity, {"e", "other", "e"}});
            }),
            "a test: found the entity 'x' twice in the engine 'e', allowed: once");
  EXPECT_EQ(simulation->stateHash(), hash);
  simulation->apply(SpawnEntity{entity, {"e", "other"}});
  for (int tick = 0; tick < 50; ++tick) {
    simulation->tick();
  }
  simulation->apply(DeleteEntity{"x"});
  simulation->tick();
  const std::string file = fileWith(GetParam(), "", "\n<entity id=\"fb\"/>");
  EXPECT_EQ(messageOf([&] { const Simulation twice(parseExperiment(file, "twice.xml")); }),
            "twice.xml:8: found the entity 'fb' twice in the engine 'e', allowed: once");
}

TEST_P(DoorTest, WhatMovesComesInWithinTheArena) {
  const auto simulation = world(GetParam());
  const std::uint64_t hash = simulation->stateHash();
  const std::string allowed = "', allowed: in the arena, from 0, 0, 0 to 5, 5, 2";
  EXPECT_EQ(messageOf([&] {
              simulation->apply(SpawnEntity{prey({6.0, 3.0, 0.0}), {"e"}});
            }),
            "a test: position: found '6, 3, 0" + allowed);
  EXPECT_EQ(messageOf([&] {
              simulation->apply(MoveEntity{"fb", {{1e40, 3.0, 0.0}, Eigen::Quaterniond::Identity()}});
            }),
            "position: found '1e+40, 3, 0" + allowed);
  EXPECT_EQ(messageOf([&] {
              simulation->apply(MoveEntity{"fb", {{1.0, -0.1, 0.0}, Eigen::Quaterniond::Identity()}});
            }),
            "position: found '1, -0.1, 0" + allowed);
  EXPECT_EQ(simulation->stateHash(), hash);
  const std::string outside = fileWith(
      GetParam(), "\n<footbot id='out'><position>5.5,1,0</position><orientation>0,0,0</orientation></footbot>");
  EXPECT_EQ(messageOf([&] { const Simulation with(parseExperiment(outside, "out.xml")); }),
            "out.xml:5: position: found '5.5, 1, 0" + allowed);
  simulation->apply(MoveEntity{"fb", {{5.0, 5.0, 0.0}, Eigen::Quaterniond::Identity()}});
  simulation->tick();
}

INSTANTIATE_TEST_SUITE_P(Engines, DoorTest, testing::Values("kinematics2d", "dynamics2d", "dynamics3d"),
                         [](const auto& engine) { return std::string(engine.param); });

TEST(DoorTest, NumbersThatNoEngineCanHoldAreRefusedByTheirBounds) {
  const auto simulation = world();
  const auto refusal = [&](const NamedValues& values) {
    return messageOf([&] { simulation->apply(SpawnEntity{prey({3.0, 3.0, 0.0}, values), {"e"}}); });
  };
  EXPECT_EQ(refusal({{"radius", "1e-6"}, {"height", "0.1"}}),
            "a test: radius: found '1e-6', allowed: a number from 0.0001 to 10000");
  EXPECT_EQ(refusal({{"radius", "0.1"}, {"height", "1e40"}}),
            "a test: height: found '1e40', allowed: a number from 0.0001 to 10000");
  EXPECT_EQ(refusal({{"radius", "0.1"}, {"height", "0.1"}, {"mass", "nan"}}),
            "a test: mass: found 'nan', allowed: a number from 0.001 to 1000000");
  EXPECT_EQ(refusal({{"radius", "0.1"}, {"height", "0.1"}, {"radius", "0.2"}}),
            "a test: found a second 'radius' of a cylindric_prey, allowed: one");
  EXPECT_EQ(refusal({{"radius", "0.1"}}), "a test: a cylindric_prey needs the parameter 'height'");
  EXPECT_EQ(refusal({{"radius", "0.1"}, {"height", "0.1"}, {"weight", "1"}}),
            "a test: parameter of a cylindric_prey: found 'weight', allowed: radius, height, mass, color, position, "
            "orientation; did you mean 'height'?");
  EntityDescription block = prey({3.0, 3.0, 0.5}, {{"size", "1, 1, 1"}, {"mass", "1e-40"}});
  block.type = "block";
  EXPECT_EQ(messageOf([&] {
              simulation->apply(SpawnEntity{block, {"e"}});
            }),
            "a test: mass: found '1e-40', allowed: 0, or a number from 0.001 to 1000000");
  EntityDescription turned = prey({3.0, 3.0, 0.0});
  turned.angles.z() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(messageOf([&] {
              simulation->apply(SpawnEntity{turned, {"e"}});
            }),
            "a test: orientation: found '0, 0, nan', allowed: three finite numbers");
}

TEST(DoorTest, WhatStandsMayStandAroundTheArena) {
  const auto simulation = world();
  EntityDescription wall = prey({-1.0, 2.0, 0.0}, {{"size", "1, 5, 1"}});
  wall.type = "block";
  simulation->apply(SpawnEntity{wall, {"e"}});
  wall.id = "far";
  wall.position.x() = 1e5;
  EXPECT_EQ(messageOf([&] {
              simulation->apply(SpawnEntity{wall, {"e"}});
            }),
            "a test: position: found '1e+05, 2, 0', allowed: 3 numbers, each from -10000 to 10000");
}

TEST(DoorTest, ANameIsOneInCodeToo) {
  const auto simulation = world();
  EntityDescription entity = prey({3.0, 3.0, 0.0});
  entity.id = "x/../y";
  EXPECT_EQ(messageOf([&] {
              simulation->apply(SpawnEntity{entity, {"e"}});
            }),
            "a test: name: found 'x/../y', allowed: letters, digits and _, a letter first");
}

/// Computes a pose that is not finite in its third tick.
class BrokenEngine final : public test::GlideEngine {
 public:
  static PluginDescription describe() {
    PluginDescription description = test::GlideEngine::describe();
    description.label = "broken";
    return description;
  }
  void move(const Space& space, const MoveAccess& access, Duration) override {
    for (Pose& pose : access.pose) {
      if (space.tick == 2) {
        pose.orientation.z() = std::numeric_limits<double>::quiet_NaN();
      }
    }
  }
};

TEST(FinitePosesTest, AnEngineThatBreaksDownStopsTheRun) {
  const auto simulation = world("broken");
  simulation->tick();
  simulation->tick();
  try {
    simulation->tick();
    FAIL() << "went on";
  } catch (const std::exception& error) {
    EXPECT_STREQ(error.what(), "engine 'e' has moved footbot 'fb' to a pose that is not finite");
  }
  EXPECT_EQ(simulation->space().tick, 2U);
}

TEST(LimitsTest, ARunIsNoLongerThanItsClockCanCount) {
  loadBuiltInPlugins();
  Experiment experiment = parseExperiment(fileWith("kinematics2d"), "world.xml");
  experiment.framework.max_clock = 31536000000;  // of 100 ms each
  { const Simulation simulation(experiment); }
  ++experiment.framework.max_clock;
  EXPECT_EQ(messageOf([&] { const Simulation simulation(experiment); }),
            "world.xml:2: maxclock: found 31536000001 ticks of 100 ms, allowed: 100 years of simulated time");
}

TEST(LimitsTest, EntitiesAreCountedBeforeTheyAreMade) {
  loadBuiltInPlugins();
  std::string groups;
  for (const char* id : {"a", "b"}) {
    groups += "<distribute quantity='600000'><minimum>0,0,0</minimum><maximum>5,5,0</maximum><light id='" +
              std::string(id) + "'/></distribute>";
  }
  const std::string file = fileWith("kinematics2d", groups);
  EXPECT_EQ(messageOf([&] { const Simulation simulation(parseExperiment(file, "many.xml")); }),
            "many.xml:3: found 1200001 entities, allowed: at most 1000000");
}

TEST(LimitsTest, AGridWithoutWidthIsALine) {
  loadBuiltInPlugins();
  const std::string line =
      "<distribute quantity='4' layout='grid'><minimum>1,3,0</minimum><maximum>5,3,0</maximum><random_heading>false"
      "</random_heading><footbot id='row'/></distribute>";
  const Simulation simulation(parseExperiment(fileWith("kinematics2d", line, "<entity id='row'/>"), "line.xml"));
  const Entities& entities = simulation.space().entities;
  for (int k = 1; k <= 4; ++k) {
    const Row row = entities.find("row_" + std::to_string(k));
    EXPECT_EQ(entities.pose[row].position, Eigen::Vector3d(0.5 + k, 3.0, 0.0));
  }
}

}  // namespace
}  // namespace swarmanoid

REGISTER_ENGINE(swarmanoid::BrokenEngine)
