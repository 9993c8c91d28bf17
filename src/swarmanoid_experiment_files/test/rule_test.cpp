// Rules: the times of their calls and of their requests, refusals and exceptions.
#include "swarmanoid_space/rule.hpp"

#include <gtest/gtest.h>

#include "swarmanoid_experiment_files/testing/scripted_rule.hpp"

namespace swarmanoid::test {
namespace {

using Calls = std::vector<std::string>;

class RuleTest : public testing::Test {
 protected:
  ~RuleTest() override {
    scripts().clear();
    calls().clear();
  }

  /// Returns the message of the exception that the action throws.
  template <class Action>
  static std::string thrownBy(Action action) {
    try {
      action();
    } catch (const ConfigError& error) {
      return std::string("ConfigError ") + error.what();
    } catch (const std::exception& error) {
      return error.what();
    }
    return "(nothing)";
  }

  Script& a = scripts()["a"];
  Script& b = scripts()["b"];
};

TEST_F(RuleTest, HooksComeInTheOrderOfTheTickAndOfTheFile) {
  const auto simulation = ruledWorld();
  simulation->addObserver(std::make_shared<NotingObserver>());
  EXPECT_EQ(calls(), (Calls{"a.configure", "b.configure", "a.reset", "b.reset"}));
  calls().clear();
  simulation->start();
  EXPECT_EQ(calls(), (Calls{"draw"}));
  calls().clear();
  simulation->tick();
  EXPECT_EQ(calls(), (Calls{"a.before", "b.before", "step", "a.after", "b.after", "draw"}));
  calls().clear();
  simulation->reset();
  EXPECT_EQ(calls(), (Calls{"a.reset", "b.reset", "draw"}));
}

TEST_F(RuleTest, TheClockIsThatOfTheTickToComeAndThenOfTheFinishedOnes) {
  std::vector<std::uint64_t> ticks;
  const Hook note = [&ticks](ScriptedRule&, const Space& space, InterventionQueue&) { ticks.push_back(space.tick); };
  a.reset = a.before = a.after = note;
  const auto simulation = ruledWorld();
  simulation->start();
  simulation->tick();
  simulation->tick();
  EXPECT_EQ(ticks, (std::vector<std::uint64_t>{0, 0, 1, 1, 2}));
}

TEST_F(RuleTest, WhatResetAsksForIsDoneBeforeTheNextRuleIsCalled) {
  double seen = 0.0;
  a.reset = [](ScriptedRule&, const Space&, InterventionQueue& queue) {
    queue.ask(moveTo(4.0, 1.0));
    queue.ask(DeleteEntity{"prey"});
  };
  b.reset = [&seen](ScriptedRule&, const Space& space, InterventionQueue&) { seen = xOf(space); };
  const auto simulation = ruledWorld();
  EXPECT_EQ(seen, 4.0);
  simulation->start();
  EXPECT_EQ(eventsOf(*simulation), "moved fb;deleted prey;");
  ASSERT_EQ(simulation->space().interventions.size(), 2U);
  EXPECT_EQ(simulation->space().placed[simulation->space().entities.find("fb")], 0U);
  simulation->tick();
  EXPECT_EQ(eventsOf(*simulation), "") << "they are the run's beginning, and no tick's";
  simulation->reset();
  EXPECT_EQ(xOf(simulation->space()), 4.0);
  EXPECT_EQ(eventsOf(*simulation), "moved fb;deleted prey;");
}

TEST_F(RuleTest, WhatBeforeTickAsksForIsDoneBeforeTheNextRuleAndInThatTick) {
  double seen = 0.0;
  a.before = [](ScriptedRule&, const Space& space, InterventionQueue& queue) {
    if (space.tick == 1) {
      queue.ask(moveTo(2.0, 1.0));
      queue.ask(moveTo(3.0, 2.0));  // requests keep their order: this one is the last
    }
  };
  b.before = [&seen](ScriptedRule&, const Space& space, InterventionQueue&) { seen = xOf(space); };
  const auto simulation = ruledWorld();
  simulation->start();
  simulation->tick();
  EXPECT_EQ(seen, 1.0);
  simulation->tick();
  EXPECT_EQ(seen, 3.0);
  EXPECT_EQ(eventsOf(*simulation), "moved fb;moved fb;");
  EXPECT_EQ(simulation->space().placed[simulation->space().entities.find("fb")], 1U);
}

TEST_F(RuleTest, WhatAfterTickAsksForWaitsForTheNextTick) {
  std::vector<double> seen_by_b;
  a.after = [](ScriptedRule&, const Space& space, InterventionQueue& queue) {
    if (space.tick == 1) {
      queue.ask(moveTo(2.0, 1.0));
    }
  };
  a.before = b.before =
      b.after = [&](ScriptedRule&, const Space& space, InterventionQueue&) { seen_by_b.push_back(xOf(space)); };
  const auto simulation = ruledWorld();
  simulation->start();
  simulation->tick();
  EXPECT_EQ(xOf(simulation->space()), 1.0);
  EXPECT_EQ(eventsOf(*simulation), "");
  simulation->tick();
  EXPECT_EQ(seen_by_b, (std::vector<double>{1.0, 1.0, 1.0, 2.0, 2.0, 2.0}));
  EXPECT_EQ(eventsOf(*simulation), "moved fb;");
}

TEST_F(RuleTest, WhatAfterTickAsksForAndTheRunDoesNotReachIsForgottenByAReset) {
  a.after = [](ScriptedRule&, const Space& space, InterventionQueue& queue) {
    if (space.run == 0) {
      queue.ask(DeleteEntity{"prey"});
    }
  };
  const auto simulation = ruledWorld();
  simulation->start();
  simulation->tick();
  simulation->reset();
  simulation->tick();
  EXPECT_NE(simulation->space().entities.find("prey"), kNoRow);
}

TEST_F(RuleTest, InterventionsNameWhoAsked) {
  a.after = [](ScriptedRule&, const Space& space, InterventionQueue& queue) {
    if (space.tick == 1) {
      queue.tryTo(moveTo(2.0, 1.0));
    }
  };
  b.before = [](ScriptedRule&, const Space& space, InterventionQueue& queue) {
    if (space.tick == 1) {
      queue.ask(DeleteEntity{"prey"});
    }
  };
  const auto simulation = ruledWorld();
  simulation->start();
  simulation->tick();
  simulation->apply(moveTo(3.0, 1.0));
  simulation->tick();
  const std::vector<TakenIntervention>& taken = simulation->space().interventions;
  ASSERT_EQ(taken.size(), 3U);
  EXPECT_EQ(taken[0].asked_by, "");
  EXPECT_EQ(std::get<MoveEntity>(taken[0].what).pose.position.x(), 3.0);
  EXPECT_EQ(taken[1].asked_by, "rule 'a' (scripted_rule)");
  EXPECT_EQ(std::get<MoveEntity>(taken[1].what).pose.position.x(), 2.0);
  EXPECT_EQ(taken[2].asked_by, "rule 'b' (scripted_rule)");
  EXPECT_EQ(std::get<DeleteEntity>(taken[2].what).entity, "prey");
  simulation->tick();
  EXPECT_TRUE(simulation->space().interventions.empty());
}

TEST_F(RuleTest, WhatIsAskedForAndRefusedEndsTheRunWithRuleTickAndReason) {
  const Hook ask = [](ScriptedRule&, const Space& space, InterventionQueue& queue) {
    if (space.tick == 2) {
      queue.ask(DeleteEntity{"nobody"});
    }
  };
  const std::string reason = " asked in tick 2 for what is refused: there is no entity 'nobody'";
  for (const bool is_before : {true, false}) {
    a.before = is_before ? ask : Hook();
    b.after = is_before ? Hook() : ask;
    const auto simulation = ruledWorld();
    simulation->start();
    simulation->tick();
    simulation->tick();
    EXPECT_EQ(thrownBy([&] { simulation->tick(); }),
              std::string("rule '") + (is_before ? "a" : "b") + "' (scripted_rule)" + reason);
    EXPECT_EQ(simulation->space().tick, 2U);
  }
}

TEST_F(RuleTest, WhatResetAsksForAndIsRefusedEndsTheRunBeforeItBegins) {
  a.reset = [](ScriptedRule&, const Space&, InterventionQueue& queue) { queue.ask(moveTo(99.0, 1.0)); };
  const std::string message = thrownBy([] { ruledWorld(); });
  EXPECT_EQ(message.rfind("rule 'a' (scripted_rule) asked in tick 0 for what is refused: position: found", 0), 0U)
      << message;
}

TEST_F(RuleTest, WhatMayBeRefusedAndIsRefusedIsAnEventAndNothingElse) {
  const auto undisturbed = ruledWorld();
  undisturbed->start();
  b.before = [](ScriptedRule&, const Space& space, InterventionQueue& queue) {
    if (space.tick == 1) {
      queue.tryTo(moveTo(99.0, 1.0));
      queue.tryTo(DeleteEntity{"nobody"});
    }
  };
  const auto simulation = ruledWorld();
  simulation->start();
  for (int i = 0; i < 3; ++i) {
    simulation->tick();
    undisturbed->tick();
    EXPECT_EQ(simulation->stateHash(), undisturbed->stateHash()) << i;
    EXPECT_TRUE(simulation->space().interventions.empty());
    if (i != 1) {
      EXPECT_TRUE(simulation->space().events.empty());
      continue;
    }
    const std::vector<Event>& events = simulation->space().events;
    ASSERT_EQ(events.size(), 2U);
    for (const Event& event : events) {
      EXPECT_EQ(event.kind, Event::Kind::kInterventionRefused);
    }
    EXPECT_EQ(events[1].text,
              "rule 'b' (scripted_rule) asked in tick 1 for what is refused: there is no entity 'nobody'");
  }
}

TEST_F(RuleTest, WhatComesAfterARefusalIsDone) {
  a.before = [](ScriptedRule&, const Space& space, InterventionQueue& queue) {
    if (space.tick == 0) {
      queue.tryTo(DeleteEntity{"nobody"});
      queue.ask(moveTo(2.0, 1.0));
    }
  };
  const auto simulation = ruledWorld();
  simulation->start();
  simulation->tick();
  EXPECT_EQ(xOf(simulation->space()), 2.0);
  EXPECT_EQ(simulation->space().events.size(), 2U);
}

TEST_F(RuleTest, AnExceptionNamesTheRule) {
  const std::vector<std::pair<std::function<void()>, std::string>> cases{
      {[] { throw std::runtime_error("no power"); }, "rule 'b' (scripted_rule): no power"},
      {[] { throw 7; }, "rule 'b' (scripted_rule) threw the number 7, which is no std::exception"},
      {[] {
         throw ConfigError({"some.xml", 4}, "no dock");
       },
       "ConfigError some.xml:4: no dock"},
      {[] { throw ConfigError({}, "power: found 'x'"); }, "ConfigError rule 'b' (scripted_rule): power: found 'x'"}};
  for (const auto& [action, expected] : cases) {
    const Hook hook = [act = action](ScriptedRule&, const Space&, InterventionQueue&) { act(); };
    b = {};
    const auto simulation = ruledWorld();
    simulation->start();
    b.before = hook;
    EXPECT_EQ(thrownBy([&] { simulation->tick(); }), expected) << "before";
    EXPECT_EQ(simulation->space().tick, 0U);
    b = {};
    b.after = hook;
    EXPECT_EQ(thrownBy([&] { simulation->tick(); }), expected) << "after";
    EXPECT_EQ(simulation->space().tick, 1U);
    b = {};
    b.reset = hook;
    EXPECT_EQ(thrownBy([] { ruledWorld(); }), expected) << "reset";
    b = {};
  }
}

}  // namespace
}  // namespace swarmanoid::test

REGISTER_RULE(swarmanoid::test::ScriptedRule)
REGISTER_CONTROLLER(swarmanoid::test::NotingController, "noting_controller")
