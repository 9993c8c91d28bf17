// What was done to a run from outside, recorded and played into another one: the same hashes in each tick.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "handover_world.hpp"
#include "lockstep_world.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"
#include "swarmanoid_interface/random.hpp"
#include "swarmanoid_space/output/out_folder.hpp"
#include "swarmanoid_space/rule.hpp"
#include "swarmanoid_space/simulation/run_files.hpp"

namespace swarmanoid::test {
namespace {

constexpr std::array<const char*, 3> kEngineIds = {"ground", "forces", "space"};

/// Robots driven at random and preys, all in one of three engines; the others have one robot each.
World crowdedWorld(const std::string& engine) {
  World world;
  world.ticks = 400;
  world.drive = "<left>0</left><right>0</right><random>true</random><close_at>0</close_at>";
  std::string members;
  world.entities = "<light id='lamp'><position>5, 5, 0.9</position><orientation>0, 0, 0</orientation></light>";
  for (int i = 1; i <= 4; ++i) {
    const std::string number = std::to_string(i);
    world.entities += footbot("fb_" + number, 2.0 * i, 3, 30.0 * i) + prey("prey_" + number, 2.0 * i, 6);
    members += member("fb_" + number) + member("prey_" + number);
  }
  for (std::size_t i = 0; i < kEngineIds.size(); ++i) {
    const std::string id = "alone_" + std::to_string(i + 1);
    world.entities += footbot(id, 1.0 + static_cast<double>(i), 9, 0);
    const std::string all = member(id) + (kEngineIds[i] == engine ? members : "");
    if (i == 0) {
      world.members = all;
    } else {
      world.physics += "<engine id=\"" + std::string(kEngineIds[i]) + "\">" + all + "</engine>";
    }
  }
  world.engines =
      "<dynamics2d id='forces'><subclock>10</subclock></dynamics2d>"
      "<dynamics3d id='space'><subclock>10</subclock></dynamics3d>";
  return world;
}

/// Draws interventions of all kinds, good ones and bad ones.
class RandomInterventions {
 public:
  RandomInterventions(std::string engine, std::uint64_t seed)
      : engine_(std::move(engine)), random_(seed, "test", "interventions") {}

  Intervention next() {
    switch (random_.below(7)) {
      case 0:
        return spawn();
      case 1:
        return DeleteEntity{random_.below(2) == 0 ? name() : "prey_" + std::to_string(1 + random_.below(4))};
      case 2:
        return MoveEntity{name(), {place(), orientationFromAngles(angles())}};
      case 3:
        return HandOverEntity{name(), engine()};
      case 4:
        return parameters();
      case 5:
        if (random_.below(3) == 0) {
          return SetProperty{"lamp", "intensity", numberText(random_.uniform(-1.0, 9.0))};
        }
        return SetProperty{name(), random_.below(3) == 0 ? "charge" : "color",
                           std::to_string(random_.below(300)) + ",0,7"};
      default:
        return SetCommandSource{random_.below(2) == 0 ? name() : "fb_" + std::to_string(1 + random_.below(4)),
                                random_.below(3) == 0
                                    ? CommandSource::kTopics
                                    : (random_.below(2) == 0 ? CommandSource::kNone : CommandSource::kController)};
    }
  }

 private:
  std::string name() {
    static const std::array<const char*, 4> prefixes{"fb_", "prey_", "late_", "nobody_"};
    return prefixes[random_.below(prefixes.size())] + std::to_string(1 + random_.below(4));
  }
  std::string engine() { return random_.below(3) > 0 ? engine_ : kEngineIds[random_.below(kEngineIds.size())]; }
  /// Some are beyond the arena's border, at 10.
  Eigen::Vector3d place() { return {random_.uniform(0.3, 10.3), random_.uniform(0.3, 9.7), 0.0}; }
  /// Some lie on their side.
  Eigen::Vector3d angles() { return {random_.below(6) == 0 ? 1.5 : 0.0, 0.0, random_.uniform(-M_PI, M_PI)}; }
  Intervention spawn() {
    SpawnEntity result;
    EntityDescription& entity = result.entity;
    entity.id = random_.below(4) == 0 ? name() : "late_" + std::to_string(1 + random_.below(4));
    entity.position = place();
    entity.angles = angles();
    entity.type = "footbot";
    if (random_.below(2) == 0) {
      entity.type = "cylindric_prey";
      entity.parameters.set("radius", numberText(random_.uniform(0.03, 0.1)));
      entity.parameters.set("height", "0.1");
      entity.parameters.set("color", "yellow");
      entity.color = {static_cast<std::uint8_t>(random_.below(256)), 0, 7};
    } else {
      entity.controller = random_.below(5) == 0 ? "driver" : "drive";
    }
    result.engines = {engine()};
    if (random_.below(3) == 0) {
      result.engines.push_back(engine());  // a mirror, or the same once more
    }
    return result;
  }
  Intervention parameters() {
    static const std::array<const char*, 3> names{"treel_friction", "gravity", "friction"};
    return SetEngineParameters{engine(), {{names[random_.below(names.size())], numberText(random_.uniform(0.2, 1.0))}}};
  }

  std::string engine_;
  RandomStream random_;
};

/// What became of random interventions.
struct Tried {
  std::array<int, std::variant_size_v<Intervention>> carried_out{};
  int refused = 0;
};

/// Does so many of them to the run, up to four between two ticks. @return the hashes of its ticks
std::vector<std::uint64_t> disturb(Simulation& simulation, RandomInterventions& interventions, int count,
                                   Tried& tried) {
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < count; ++i) {
    const Intervention intervention = interventions.next();
    const std::uint64_t state = simulation.stateHash();
    const std::uint64_t deep = deepHash(simulation.space());
    try {
      simulation.apply(intervention);
      ++tried.carried_out[intervention.index()];
    } catch (const ConfigError& error) {
      ++tried.refused;
      EXPECT_EQ(simulation.stateHash(), state) << error.what();
      EXPECT_EQ(deepHash(simulation.space()), deep) << error.what();
    }
    for (int tick = 0; i % 4 == 3 && tick < 3; ++tick) {
      simulation.tick();
      hashes.push_back(simulation.stateHash());
    }
  }
  return hashes;
}

class RuledReplayTest : public testing::Test {
 protected:
  void record(Simulation& simulation) const {
    RunFiles files;
    files.folder = owner.path();
    RunContext context;
    context.out = openOutFolder(files, {});
    Configuration parameters("intervention_recorder", "", {});
    parameters.set("file", "done.xml");
    addObserver(simulation, context, "--save-interventions", "recorder", parameters);
    context.out->keep();
  }

  std::unique_ptr<Simulation> replayed(const World& world, AskedByRules asked_by_rules = AskedByRules::kLeftOut) const {
    auto simulation = world.make();
    simulation->play({readInterventions(owner.path() / "done.xml", simulation->experiment()), asked_by_rules});
    simulation->start();
    return simulation;
  }

  const TemporaryFolder owner{"intervention_replay_test"};
};

class ReplayTest : public RuledReplayTest, public testing::WithParamInterface<const char*> {};

TEST_P(ReplayTest, TwoHundredRandomInterventionsHaveTheSameHashesAgainAndAfterAReset) {
  const World world = crowdedWorld(GetParam());
  auto simulation = world.make();
  record(*simulation);
  simulation->start();
  RandomInterventions interventions(GetParam(), 3);
  Tried tried;
  const auto expected = disturb(*simulation, interventions, 200, tried);
  simulation->finish();
  EXPECT_GT(tried.refused, 20);
  for (std::size_t kind = 0; kind < tried.carried_out.size(); ++kind) {
    const bool has_no_live_parameters = GetParam() == std::string("ground") && kind == 4;
    EXPECT_GT(tried.carried_out[kind], has_no_live_parameters ? -1 : 0) << "kind " << kind;
  }

  const auto again = replayed(world);
  const std::uint64_t ticks = expected.size();
  EXPECT_EQ(hashesOf(*again, ticks), expected);
  EXPECT_EQ(again->interventionsLeft(), 0U);
  EXPECT_EQ(deepHash(again->space()), deepHash(simulation->space()));
  again->reset();
  EXPECT_GT(again->interventionsLeft(), 0U);
  EXPECT_EQ(hashesOf(*again, ticks), expected);
}

INSTANTIATE_TEST_SUITE_P(Engines, ReplayTest, testing::ValuesIn(kEngineIds));

/// Puts "fb" to (3, 3) before tick 2, and to (5, 5) once tick 4 is over.
class PuttingRule final : public Rule {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "putting";
    return description;
  }
  void configure(const Configuration&) override {}
  void beforeTick(const Space& space, InterventionQueue& queue) override {
    if (space.tick == 2) {
      put(3.0, queue);
    }
  }
  void afterTick(const Space& space, InterventionQueue& queue) override {
    if (space.tick == 5) {
      put(5.0, queue);
    }
  }

 private:
  static void put(double place, InterventionQueue& queue) {
    queue.ask(MoveEntity{"fb", {{place, place, 0.0}, Eigen::Quaterniond::Identity()}});
  }
};

/// Commanded from here or from elsewhere.
World ruledWorld(const std::string& source) {
  World world;
  std::string robot = footbot("fb", 1, 1, 0);
  robot.replace(robot.find("<controller>"), 12, "<controller source=\"" + source + "\">");
  world.entities = robot;
  world.members = member("fb");
  world.drive = "<left>5</left><right>5</right>";
  world.rules = "<putting id='mine'/>";
  return world;
}

void putTo(Simulation& simulation, double place) {
  simulation.apply(MoveEntity{"fb", {{place, place, 0.0}, Eigen::Quaterniond::Identity()}});
}

TEST_F(RuledReplayTest, WhatRulesAskForIsLeftOutAndAskedForAgain) {
  auto simulation = ruledWorld("controller").make();
  record(*simulation);
  simulation->start();
  auto expected = hashesOf(*simulation, 2);
  putTo(*simulation, 7.0);  // in the same tick, and before the rule's
  for (const std::uint64_t hash : hashesOf(*simulation, 6)) {
    expected.push_back(hash);
  }
  EXPECT_NEAR(poseOf(*simulation, "fb").position.y(), 5.0, 1e-6);
  simulation->finish();
  EXPECT_EQ(hashesOf(*replayed(ruledWorld("controller")), 8), expected);
  World without = ruledWorld("controller");
  without.rules.clear();
  EXPECT_EQ(hashesOf(*replayed(without, AskedByRules::kPlayed), 8), expected);
  EXPECT_NE(hashesOf(*replayed(without, AskedByRules::kLeftOut), 8), expected);
  const auto names = readInterventions(owner.path() / "done.xml", simulation->experiment()).interventions;
  ASSERT_EQ(names.size(), 3U);
  EXPECT_EQ(names[0].taken.asked_by, "");
  EXPECT_EQ(names[1].taken.asked_by, "rule 'mine' (putting)");
  EXPECT_EQ(names[1].taken.tick, 2U);
  EXPECT_EQ(names[2].taken.tick, 5U);
}

TEST_F(RuledReplayTest, WhatWasDoneInATickThatWasGivenUpComesAfterTheRules) {
  auto simulation = ruledWorld("remote").make();
  record(*simulation);
  simulation->start();
  FakeParticipant participant(*simulation, "a", {"fb"});
  participant.join();
  auto expected = hashesOf(*simulation, 2);
  participant.is_mute = true;
  EXPECT_FALSE(simulation->tick([] { return true; }));
  putTo(*simulation, 7.0);
  participant.is_mute = false;
  participant.answerLate();
  for (const std::uint64_t hash : hashesOf(*simulation, 3)) {
    expected.push_back(hash);
  }
  EXPECT_NEAR(poseOf(*simulation, "fb").position.y(), 7.0, 1e-6);
  simulation->finish();
  const auto recorded = readInterventions(owner.path() / "done.xml", simulation->experiment()).interventions;
  ASSERT_GE(recorded.size(), 2U);
  EXPECT_FALSE(recorded[0].taken.after_rules);
  EXPECT_TRUE(recorded[1].taken.after_rules);
  EXPECT_EQ(recorded[1].taken.asked_by, "");
  EXPECT_EQ(hashesOf(*replayed(ruledWorld("controller")), 5), expected);
}

TEST_F(RuledReplayTest, ARefusedOneEndsTheRunWithFileLineTickAndReason) {
  auto simulation = ruledWorld("controller").make();
  const std::string text =
      "<interventions>\n<command_source tick='1' robot='fb' source='none'/>\n<delete tick='3' entity='gone'/>\n"
      "</interventions>";
  simulation->play({parseInterventions(text, "f.xml", simulation->experiment()), AskedByRules::kLeftOut});
  simulation->start();
  tick(*simulation, 3);
  try {
    simulation->tick();
    ADD_FAILURE() << "it goes on";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "f.xml:3: <delete> is refused in tick 3: there is no entity 'gone'");
  }
}

}  // namespace
}  // namespace swarmanoid::test

REGISTER_RULE(swarmanoid::test::PuttingRule)
