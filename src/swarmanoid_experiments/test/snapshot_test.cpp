// Snapshots: a run that goes on from one has the bits of the run that was not interrupted, in the same simulation and
// in another one, with all experiments of the suite and after interventions of all kinds.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "installed_experiment.hpp"
#include "random_interventions.hpp"
#include "swarmanoid_interface/random.hpp"

namespace swarmanoid::test {
namespace {

/// State hashes of ticks, and the hash of all devices after the last one.
std::vector<std::uint64_t> hashesAfter(Simulation& simulation, std::uint64_t ticks) {
  std::vector<std::uint64_t> hashes;
  for (std::uint64_t i = 0; i < ticks && !simulation.isFinished(); ++i) {
    simulation.tick();
    hashes.push_back(simulation.stateHash());
  }
  hashes.push_back(deepHash(simulation.space()));
  return hashes;
}

struct Case {
  std::string name;
  std::vector<std::string> overrides;
  std::uint64_t most_ticks = 400;  ///< of the first part, and of the second
};

std::ostream& operator<<(std::ostream& out, const Case& one) { return out << one.name; }

class SnapshotOf : public testing::TestWithParam<Case> {};

TEST_P(SnapshotOf, GoesOnWithTheSameBits) {
  const Case& one = GetParam();
  RandomStream random(7, one.name, "snapshot_test");
  for (std::uint64_t seed = 3; seed < 6; ++seed) {
    random.startTick(seed);
    const std::uint64_t before = 1 + random.below(one.most_ticks);
    const std::uint64_t after = 1 + random.below(one.most_ticks);
    const auto simulation = installed(one.name, seed, one.overrides);
    hashesAfter(*simulation, before);
    const auto snapshot = simulation->snapshot();
    const std::uint64_t tick = simulation->space().tick;
    EXPECT_EQ(snapshot->tick(), tick);
    EXPECT_EQ(snapshot->seed(), seed);
    const std::uint64_t deep = deepHash(simulation->space());
    const std::vector<std::uint64_t> uninterrupted = hashesAfter(*simulation, after);

    simulation->restore(*snapshot);
    EXPECT_EQ(simulation->space().tick, tick);
    EXPECT_EQ(deepHash(simulation->space()), deep) << "seed " << seed << ", tick " << tick;
    EXPECT_EQ(hashesAfter(*simulation, after), uninterrupted) << "seed " << seed << ", tick " << tick;

    const auto other = installed(one.name, seed + 40, one.overrides);
    hashesAfter(*other, before / 2);
    other->restore(*snapshot);
    EXPECT_EQ(hashesAfter(*other, after), uninterrupted) << "another simulation, seed " << seed << ", tick " << tick;
  }
}

INSTANTIATE_TEST_SUITE_P(Experiments, SnapshotOf,
                         testing::Values(Case{"aggregation", {}}, Case{"battery_foraging", {}, 900},
                                         Case{"chain_formation", {}}, Case{"charging", {}, 700},
                                         Case{"diffusion", {"arena.distribute.quantity=60"}},
                                         Case{"emergent_taxis", {}}, Case{"evolved_retrieval", {}},
                                         Case{"flocking", {}}, Case{"foraging", {}, 900}, Case{"group_pull", {}},
                                         Case{"neural_aggregation", {}}, Case{"neural_phototaxis", {}},
                                         Case{"object_retrieval", {}}, Case{"phototaxis", {}}, Case{"predators", {}},
                                         Case{"trail", {}}, Case{"two_spot_foraging", {}, 900}),
                         [](const auto& one) { return one.param.name; });

class SnapshotIn : public testing::TestWithParam<const char*> {};

/// Five footbots with noise on their sensors and wheels in a small arena, so that they touch often.
std::unique_ptr<Simulation> smallWorld(const std::string& engine, std::uint64_t seed) {
  loadBuiltInPlugins();
  Experiment experiment = parseExperiment(R"(<ahss-config>
    <framework><clocktick>100</clocktick><maxclock>1000</maxclock></framework>
    <controllers><diffusion id="dc" library="diffusion">
      <actuators><footbot_wheels><error kind="factor_spread" deviation="0.05"/></footbot_wheels></actuators>
      <sensors><footbot_proximity><error kind="uniform" half_width="0.03"/><error kind="random_walk" deviation="0.01"/></footbot_proximity></sensors>
    </diffusion></controllers>
    <arena size="1.37,1.49,1" optimization="2D" bounded="true"><distribute quantity="5"><minimum>0.2,0.2,0</minimum>
      <maximum>1.17,1.29,0</maximum><footbot id="fb"><controller>dc</controller></footbot></distribute></arena>
    <engines><)" + engine + R"( id="ground"><subclock>3</subclock></)" +
                                              engine +
                                              R"(></engines>
    <arena_physics><engine id="ground"><entity id="fb"/></engine></arena_physics>
  </ahss-config>)",
                                          "small.xml");
  experiment.framework.seed = seed;
  auto simulation = std::make_unique<Simulation>(std::move(experiment));
  simulation->start();
  return simulation;
}

TEST_P(SnapshotIn, FiveHundredForksAtRandomTicksGoOnWithTheSameBits) {
  RandomStream random(11, GetParam(), "snapshot_test");
  const auto other = smallWorld(GetParam(), 900);
  for (std::uint64_t i = 0; i < 500; ++i) {
    random.startTick(i);
    const auto simulation = smallWorld(GetParam(), i);
    hashesAfter(*simulation, random.below(90));
    const auto snapshot = simulation->snapshot();
    const std::uint64_t after = 1 + random.below(60);
    const std::vector<std::uint64_t> uninterrupted = hashesAfter(*simulation, after);
    other->restore(*snapshot);
    ASSERT_EQ(hashesAfter(*other, after), uninterrupted) << "run " << i << ", tick " << snapshot->tick();
  }
}

/// The crowd of the intervention tests without its three-dimensional engine.
World crowd(const std::string& engine) {
  World world = crowdedWorld(engine);
  const auto cut = [](std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t first = text.find(begin);
    text.erase(first, text.find(end, first) + end.size() - first);
  };
  cut(world.engines, "<dynamics3d", "</dynamics3d>");
  cut(world.physics, "<engine id=\"space\"", "</engine>");
  return world;
}

TEST_P(SnapshotIn, EntitiesFaultsGripsAndPaintThatInterventionsMadeComeBack) {
  const std::string engine = GetParam() == std::string("kinematics2d") ? "ground" : "forces";
  const auto simulation = crowd(engine).make();
  const auto other = crowd(engine).make();
  simulation->start();
  other->start();
  RandomInterventions interventions(engine, 5);
  RandomInterventions others(engine, 6);
  Tried tried;
  for (int i = 0; i < 40; ++i) {
    disturb(*simulation, interventions, 7, tried);
    const auto snapshot = simulation->snapshot();
    const std::uint64_t deep = deepHash(simulation->space());
    const std::vector<std::uint64_t> uninterrupted = hashesAfter(*simulation, 9);
    disturb(*simulation, others, 5, tried);
    disturb(*other, others, 5, tried);
    for (Simulation* each : {simulation.get(), other.get()}) {
      each->restore(*snapshot);
      ASSERT_EQ(deepHash(each->space()), deep) << "round " << i;
      ASSERT_EQ(hashesAfter(*each, 9), uninterrupted) << "round " << i;
    }
  }
  for (const std::size_t kind : {0U, 1U, 2U, 3U, 5U, 6U, 7U, 8U}) {
    EXPECT_GT(tried.carried_out[kind], 0) << "kind " << kind;
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, SnapshotIn, testing::Values("kinematics2d", "dynamics2d"),
                         [](const auto& one) { return std::string(one.param); });

TEST(SnapshotTest, ASnapshotOfAnotherExperimentIsRefused) {
  const auto diffusion = installed("diffusion", 1);
  const auto snapshot = diffusion->snapshot();
  const auto other = installed("phototaxis", 1);
  const std::uint64_t before = other->stateHash();
  try {
    other->restore(*snapshot);
    FAIL() << "not refused";
  } catch (const ConfigError& error) {
    EXPECT_EQ(error.what(), std::string("found a snapshot with controller 'dc' of libdiffusion.so, allowed: one of the "
                                        "same experiment, with controller 'pc' of libphototaxis.so there"));
  }
  EXPECT_EQ(other->stateHash(), before);
}

TEST(SnapshotTest, AnEngineWithoutDefinedStateIsNamed) {
  const auto climbing = installed("climbing", 1);
  try {
    climbing->snapshot();
    FAIL() << "not refused";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), std::string("engine 'space' (dynamics3d) does not define its state (StateArchive), so the "
                                        "run has no snapshots"));
  }
}

TEST(SnapshotTest, OverridesOfTheOtherSimulationStay) {
  const auto slow = installed("diffusion", 2, {"controllers.dc.parameters.speed=0.03"});
  const auto fast = installed("diffusion", 2, {"controllers.dc.parameters.speed=0.12"});
  hashesAfter(*slow, 57);
  fast->restore(*slow->snapshot());
  EXPECT_EQ(fast->stateHash(), slow->stateHash());
  fast->tick();
  const Space& space = fast->space();
  double fastest = 0.0;
  for (const Row row : space.entities.order) {
    fastest = std::max(fastest, space.entities.twist[row].linear.norm());
  }
  EXPECT_NEAR(fastest, 0.12, 1e-12);
}

}  // namespace
}  // namespace swarmanoid::test
