// Effects of rules on a run: its metrics, its end, its success; and repeatability of a run with rules.
#include <gtest/gtest.h>

#include <algorithm>

#include "swarmanoid_experiment_files/testing/scripted_rule.hpp"

namespace swarmanoid::test {
namespace {

class RuleRunTest : public testing::Test {
 protected:
  ~RuleRunTest() override {
    scripts().clear();
    calls().clear();
  }

  static std::unique_ptr<Simulation> started(std::uint64_t seed = 1) {
    auto simulation = ruledWorld(seed);
    simulation->start();
    return simulation;
  }

  Script& a = scripts()["a"];
  Script& b = scripts()["b"];
};

double numberIn(const Metrics& metrics, const std::string& name) { return std::get<double>(metrics.at(name)); }

TEST_F(RuleRunTest, MetricsAreNamedByTheirRulesAndStartAnew) {
  a.after = [](ScriptedRule& rule, const Space&, InterventionQueue&) { rule.count->value += 1.0; };
  b.after = [](ScriptedRule& rule, const Space& space, InterventionQueue&) { rule.count->value = 0.1 * xOf(space); };
  const auto simulation = started();
  EXPECT_EQ(numberIn(simulation->metrics(), "a.count"), 0.0);
  for (int i = 0; i < 3; ++i) {
    simulation->tick();
  }
  EXPECT_EQ(simulation->metrics().size(), 2U);
  EXPECT_EQ(numberIn(simulation->metrics(), "a.count"), 3.0);
  EXPECT_EQ(numberIn(simulation->metrics(), "b.count"), 0.1);
  ASSERT_EQ(simulation->space().metrics.size(), 2U);
  EXPECT_EQ(simulation->space().metrics[1]->name, "b.count");
  simulation->reset();
  EXPECT_EQ(numberIn(simulation->metrics(), "a.count"), 0.0);
  EXPECT_EQ(simulation->space().metrics.size(), 2U);
  simulation->tick();
  EXPECT_EQ(numberIn(simulation->metrics(), "a.count"), 1.0);
}

TEST_F(RuleRunTest, SuppliedRulesComeAfterThoseOfTheFileOrInTheirPlace) {
  scripts()["c"].after = [](ScriptedRule&, const Space&, InterventionQueue& queue) { queue.tryTo(DeleteEntity{"x"}); };
  SuppliedParts supplied;
  supplied.rules = {{"c", std::make_shared<ScriptedRule>()}, {"a", std::make_shared<ScriptedRule>()}};
  const auto simulation = ruledWorld(1, std::move(supplied));
  simulation->start();
  calls().clear();
  simulation->tick();
  EXPECT_EQ(calls(),
            (std::vector<std::string>{"a.before", "b.before", "c.before", "step", "a.after", "b.after", "c.after"}));
  EXPECT_EQ(simulation->metrics().size(), 3U);
  simulation->tick();
  EXPECT_EQ(eventsOf(*simulation),
            "intervention_refused : rule 'c' asked in tick 1 for what is refused: there is no entity 'x';");
}

/// Sensing before a tick calls the rules' beforeTick, once.
TEST_F(RuleRunTest, SensingBeginsATickAndTheTickDoesNotBeginAgain) {
  const auto simulation = started();
  calls().clear();
  simulation->sense();
  EXPECT_EQ(calls(), (std::vector<std::string>{"a.before", "b.before"}));
  simulation->apply(moveTo(2.0, 3.0));
  simulation->sense();
  simulation->tick();
  EXPECT_EQ(calls(), (std::vector<std::string>{"a.before", "b.before", "step", "a.after", "b.after"}));
  EXPECT_TRUE(simulation->space().interventions[0].after_rules);
  EXPECT_EQ(xOf(simulation->space()), 2.0);
}

TEST_F(RuleRunTest, ARuleEndsTheRunAndTheRulesAfterItAreCalled) {
  a.after = [this](ScriptedRule&, const Space& space, InterventionQueue&) { a.is_finished = space.tick == 2; };
  const auto simulation = started();
  simulation->tick();
  EXPECT_FALSE(simulation->isFinished());
  EXPECT_EQ(eventsOf(*simulation), "");
  calls().clear();
  simulation->tick();
  EXPECT_TRUE(simulation->isFinished());
  EXPECT_EQ(eventsOf(*simulation), "finished : rule 'a' (scripted_rule) ends the run;");
  EXPECT_EQ(calls(), (std::vector<std::string>{"a.before", "b.before", "step", "a.after", "b.after"}));
  simulation->tick();
  EXPECT_EQ(simulation->space().tick, 2U) << "nothing happens any more";
  a.is_finished = false;
  simulation->reset();
  EXPECT_FALSE(simulation->isFinished());
  simulation->tick();
  EXPECT_EQ(simulation->space().tick, 1U);
}

TEST_F(RuleRunTest, TheFailureOfARuleIsToldAlthoughTheTickCannotBeShown) {
  class FullDisk final : public Observer {
   public:
    void configure(const std::string&, const Configuration&, const RunContext&) override {}
    void draw(const Space& space) override {
      if (space.tick == 1) {
        throw std::runtime_error("the disk is full");
      }
    }
  };
  b.after = [](ScriptedRule&, const Space&, InterventionQueue&) { throw std::runtime_error("no power"); };
  const auto simulation = ruledWorld();
  simulation->addObserver(std::make_shared<FullDisk>());
  simulation->start();
  try {
    simulation->tick();
    ADD_FAILURE() << "both failed";
  } catch (const std::exception& error) {
    EXPECT_STREQ("rule 'b' (scripted_rule): no power; the disk is full", error.what());
  }
}

TEST_F(RuleRunTest, TheRunIsASuccessIfAllWhoJudgeItSayThat) {
  struct Case {
    std::optional<bool> rule;
    std::optional<bool> observer;
    std::optional<bool> run;
  };
  const auto none = std::nullopt;
  for (const Case& judged : {Case{none, none, none}, Case{true, none, true}, Case{none, false, false},
                             Case{true, false, false}, Case{false, true, false}, Case{true, true, true}}) {
    b.success = judged.rule;
    const auto simulation = ruledWorld();
    simulation->addObserver(std::make_shared<NotingObserver>(judged.observer));
    simulation->start();
    simulation->tick();
    EXPECT_EQ(simulation->success(), judged.run);
  }
}

/// Random numbers that hooks draw in four ticks.
std::vector<double> drawsOf(Simulation& simulation, std::vector<double>& draws) {
  draws.clear();
  for (int i = 0; i < 4; ++i) {
    simulation.tick();
  }
  return draws;
}

TEST_F(RuleRunTest, TheSameSeedDrawsTheSameNumbersAndAnotherOneOthers) {
  std::vector<double> draws;
  a.before = a.after =
      b.after = [&draws](ScriptedRule& rule, const Space&, InterventionQueue&) { draws.push_back(rule.draw()); };
  const std::vector<double> first = drawsOf(*started(1), draws);
  const std::vector<double> second = drawsOf(*started(2), draws);
  ASSERT_EQ(first.size(), 12U);
  EXPECT_EQ(drawsOf(*started(1), draws), first);
  auto simulation = started(1);
  drawsOf(*simulation, draws);
  simulation->reset();
  EXPECT_EQ(drawsOf(*simulation, draws), first);
  simulation->reset(2);
  EXPECT_EQ(drawsOf(*simulation, draws), second);
  std::vector<double> all = first;
  all.insert(all.end(), second.begin(), second.end());
  std::sort(all.begin(), all.end());
  EXPECT_EQ(std::adjacent_find(all.begin(), all.end()), all.end()) << "hooks, ticks, rules and seeds differ";
}

TEST_F(RuleRunTest, DrawsOfATickDoNotDependOnThoseOfOthers) {
  int more = 0;
  double last = 0.0;
  std::vector<double> at_reset;
  a.reset = [&](ScriptedRule& rule, const Space&, InterventionQueue&) { at_reset.push_back(rule.draw()); };
  a.before = [&](ScriptedRule& rule, const Space& space, InterventionQueue&) {
    for (int i = 0; space.tick == 0 && i < more; ++i) {
      rule.draw();
    }
    last = rule.draw();
  };
  auto simulation = started();
  simulation->tick();
  EXPECT_NE(at_reset.front(), last) << "tick 0 has numbers of its own";
  simulation->tick();
  const double expected = last;
  more = 5;
  simulation->reset();
  EXPECT_EQ(at_reset.front(), at_reset.back());
  simulation->tick();
  simulation->tick();
  EXPECT_EQ(last, expected);
}

/// Spawns, moves and deletes at random.
void scramble(ScriptedRule& rule, const Space& space, InterventionQueue& queue) {
  EntityDescription extra;
  extra.type = "footbot";
  extra.id = "extra_" + std::to_string(space.tick);
  extra.position = {0.5 + 4.0 * rule.draw(), 0.5 + 4.0 * rule.draw(), 0.0};
  queue.ask(SpawnEntity{extra, {}});
  const double x = 0.5 + 4.0 * rule.draw();
  queue.ask(moveTo(x, 0.5 + 4.0 * rule.draw()));
}

void thinOut(ScriptedRule& rule, const Space& space, InterventionQueue& queue) {
  std::vector<std::string> extras;
  for (const Row row : space.entities.order) {
    if (space.entities.name[row].rfind("extra_", 0) == 0) {
      extras.push_back(space.entities.name[row]);
    }
  }
  if (rule.draw() < 0.7) {
    queue.ask(DeleteEntity{extras.at(rule.below(extras.size()))});
  }
}

std::vector<std::uint64_t> hashesOf(Simulation& simulation, int ticks) {
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < ticks; ++i) {
    simulation.tick();
    hashes.push_back(simulation.stateHash());
  }
  return hashes;
}

TEST_F(RuleRunTest, AResetIsAFreshStartWithARuleThatSpawnsMovesAndDeletes) {
  constexpr int kTicks = 60;
  a.before = scramble;
  b.after = thinOut;
  const auto fresh = started(3);
  const auto expected = hashesOf(*fresh, kTicks);
  EXPECT_GT(fresh->space().entities.size(), 5U) << "more come than go";
  EXPECT_LT(fresh->space().entities.size(), 50U) << "many go: about 70 in 100";
  auto used = started(9);
  for (const int ticks : {0, 1, 17, kTicks}) {
    hashesOf(*used, ticks);
    used->reset(3);
    ASSERT_EQ(hashesOf(*used, kTicks), expected) << "reset after " << ticks << " more ticks";
  }
  used->reset(4);
  EXPECT_NE(hashesOf(*used, kTicks), expected);
}

}  // namespace
}  // namespace swarmanoid::test

REGISTER_RULE(swarmanoid::test::ScriptedRule)
REGISTER_CONTROLLER(swarmanoid::test::NotingController, "noting_controller")
