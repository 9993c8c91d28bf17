// The rule `foraging` with engines and robots: a prey that returns leaves its gripper, and waits for a free place; and
// the installed experiment with foraging footbots.
#include <gtest/gtest.h>

#include <fstream>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

double metricOf(const Simulation& simulation, const std::string& name) {
  return std::get<double>(simulation.metrics().at("foraging." + name));
}

class ForagingEnginesTest : public testing::TestWithParam<const char*> {
 protected:
  /// A prey, the nest at x > 3.5, and the place (8, 8), where preys return.
  static std::unique_ptr<Simulation> make(const std::string& entities, const std::string& members) {
    World world;
    world.entities = entities +
                     "<cylindric_prey id=\"prey\"><position>3.17,2,0</position><orientation>0,0,0</orientation>"
                     "<radius>0.06</radius><height>0.1</height></cylindric_prey>"
                     "<floor_patch id=\"nest\"><position>4,2,0</position><size>1,1</size></floor_patch>";
    world.members = members + member("prey");
    world.rules = "<foraging id=\"foraging\"><minimum>8,8,0</minimum><maximum>8,8,0</maximum></foraging>";
    world.drive = "<left>5</left><right>5</right><close_at>0</close_at>";
    world.engine_parameters = "<subclock>10</subclock>";
    std::string text = world.xml();
    for (std::size_t at = text.find("kinematics2d"); at != std::string::npos; at = text.find("kinematics2d", at + 1)) {
      text.replace(at, std::string("kinematics2d").size(), GetParam());
    }
    loadBuiltInPlugins();
    auto simulation = std::make_unique<Simulation>(parseExperiment(text, "test.xml"));
    simulation->start();
    return simulation;
  }
};

TEST_P(ForagingEnginesTest, APreyThatComesBackLeavesItsGripper) {
  const auto simulation = make(footbot("fb", 3, 2, 0), member("fb"));
  const Space& space = simulation->space();
  const Row robot = space.entities.find("fb");
  for (int i = 0; i < 100 && metricOf(*simulation, "preys") == 0.0; ++i) {
    simulation->tick();
  }
  ASSERT_EQ(metricOf(*simulation, "preys"), 1.0);
  EXPECT_EQ(space.structure.grippedBy(robot), space.entities.find("prey"));
  EXPECT_GE(poseOf(*simulation, "prey").position.x(), 3.5);
  const double before = poseOf(*simulation, "fb").position.x();
  simulation->tick();
  EXPECT_EQ(space.structure.grippedBy(robot), kNoRow);
  for (int i = 0; i < 10; ++i) {
    simulation->tick();
    EXPECT_NEAR((poseOf(*simulation, "prey").position - Eigen::Vector3d(8.0, 8.0, 0.0)).norm(), 0.0, 5e-3) << i;
  }
  EXPECT_GT(poseOf(*simulation, "fb").position.x(), before + 0.1) << "the robot drives on";
  EXPECT_EQ(metricOf(*simulation, "preys"), 1.0);
}

TEST_P(ForagingEnginesTest, ItWaitsForAFreePlaceAndCountsOnce) {
  const auto simulation = make(
      "<block id=\"crate\"><position>8,8,0.5</position><orientation>0,0,0</orientation>"
      "<size>1,1,1</size></block>",
      member("crate"));
  simulation->apply(MoveEntity{"prey", {{4.0, 2.0, 0.0}, Eigen::Quaterniond::Identity()}});
  simulation->tick();
  for (int i = 0; i < 4; ++i) {
    simulation->tick();
    EXPECT_EQ(metricOf(*simulation, "preys"), 1.0);
    EXPECT_NEAR(poseOf(*simulation, "prey").position.x(), 4.0, 1e-3);
    const std::vector<Event>& events = simulation->space().events;
    ASSERT_FALSE(events.empty());
    EXPECT_EQ(events[0].kind, Event::Kind::kInterventionRefused);
    EXPECT_NE(events[0].text.find("rule 'foraging' (foraging) asked in tick " + std::to_string(i + 1)),
              std::string::npos)
        << events[0].text;
    EXPECT_NE(events[0].text.find("overlaps 'crate'"), std::string::npos) << events[0].text;
  }
  simulation->apply(DeleteEntity{"crate"});
  simulation->tick();
  EXPECT_NEAR(poseOf(*simulation, "prey").position.x(), 8.0, 1e-3);
  simulation->tick();
  EXPECT_EQ(metricOf(*simulation, "preys"), 1.0);
}

INSTANTIATE_TEST_SUITE_P(Engines, ForagingEnginesTest, testing::Values("kinematics2d", "dynamics2d", "dynamics3d"),
                         [](const auto& engine) { return std::string(engine.param); });

/// The installed experiment. @param gripper element of the actuator
std::unique_ptr<Simulation> foraging(std::uint64_t seed, int threads = 1,
                                     const std::string& gripper = "<footbot_gripper/>") {
  loadBuiltInPlugins();
  std::ifstream file(findShared("swarmanoid_experiments", "experiments/foraging.xml"));
  std::string text(std::istreambuf_iterator<char>(file), {});
  const std::string plain = "<footbot_gripper/>";
  text.replace(text.find(plain), plain.size(), gripper);
  Experiment experiment = parseExperiment(text, "foraging.xml");
  experiment.framework.seed = seed;
  experiment.framework.threads = threads;
  auto simulation = std::make_unique<Simulation>(std::move(experiment));
  simulation->start();
  return simulation;
}

/// Runs to the end. @return preys per minute
double preysPerMinute(Simulation& simulation) {
  while (!simulation.isFinished()) {
    simulation.tick();
  }
  EXPECT_TRUE(simulation.failures().empty());
  EXPECT_EQ(simulation.success(), std::nullopt);
  return metricOf(simulation, "preys_per_minute");
}

TEST(ForagingExperimentTest, FootbotsBringPreysAndWithoutGrippersNone) {
  const std::string dead = "<footbot_gripper><error kind=\"dead\"/></footbot_gripper>";
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    EXPECT_GE(preysPerMinute(*foraging(seed)), 1.0) << "seed " << seed;
    EXPECT_EQ(preysPerMinute(*foraging(seed, 1, dead)), 0.0) << "seed " << seed;
  }
}

TEST(ForagingExperimentTest, TheSameSeedGivesTheSameBits) {
  const auto first = foraging(5);
  const auto expected = hashesOf(*first, 1500);
  EXPECT_GE(metricOf(*first, "preys"), 1.0) << "the rule has acted by then";
  EXPECT_EQ(hashesOf(*foraging(5, 2), 1500), expected) << "on two threads";
  const auto used = foraging(6);
  hashesOf(*used, 700);
  used->reset(5);
  EXPECT_EQ(hashesOf(*used, 1500), expected) << "after a reset";
}

}  // namespace
}  // namespace swarmanoid::test
