// Faults as interventions: events, rejections, persistence and end, and reproducibility.
#include <gtest/gtest.h>

#include "faulty_run.hpp"
#include "lockstep_world.hpp"
#include "swarmanoid_experiment_files/interventions/intervention_file.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

namespace swarmanoid::test {
namespace {

TEST(FaultInterventionTest, ItIsAnEventAndATakenIntervention) {
  FaultyRun run(twoRobots());
  const Space& space = run.simulation->space();
  const Errors errors{error("stuck", "value[3]"), error("gaussian", "", {{"deviation", "0.020"}}, 300)};
  run.set("fb_1", kProximity, errors);
  run.tick();
  ASSERT_EQ(space.events.size(), 1U);
  EXPECT_EQ(space.events[0].kind, Event::Kind::kIntervention);
  EXPECT_EQ(space.events[0].entity, "fb_1");
  EXPECT_EQ(space.events[0].text, "footbot_proximity: stuck on value[3], gaussian (deviation 0.02) from tick 300");
  ASSERT_EQ(space.interventions.size(), 1U);
  EXPECT_EQ(std::get<SetFault>(space.interventions[0].what).errors.size(), 2U);
  run.set("fb_1", kProximity, {error("stuck", "value[3]"), error("gaussian", "", {{"deviation", "2e-2"}}, 300)});
  run.set("fb_2", kProximity, {});
  run.tick();
  EXPECT_TRUE(space.events.empty()) << "the same is wrong with it already";
  EXPECT_TRUE(space.interventions.empty());
  run.set("fb_1", kProximity, {});
  run.tick();
  ASSERT_EQ(space.events.size(), 1U);
  EXPECT_EQ(space.events[0].text, "footbot_proximity: mended");
}

TEST(FaultInterventionTest, WhatCannotBeIsRefusedInTheWordsOfTheExperimentFile) {
  FaultyRun run(twoRobots());
  run.set("fb_1", kProximity, {error("bias", "value[13]", {{"offset", "0.375"}})});
  run.tick();
  const auto refusal = [&](const std::string& robot, const std::string& device, const Errors& errors) {
    const std::uint64_t before = run.deep();
    std::string message = "it was taken";
    try {
      run.set(robot, device, errors);
    } catch (const ConfigError& problem) {
      message = problem.what();
    }
    EXPECT_EQ(run.deep(), before);
    run.tick();
    EXPECT_TRUE(run.simulation->space().events.empty());
    EXPECT_EQ(run.reading("fb_1", 13), 0.375F) << "the fault that it had stays";
    return message;
  };
  EXPECT_EQ(refusal("fb_3", kProximity, {error("dead")}),
            "there is no robot 'fb_3' with a controller; did you mean 'fb_1'?");
  EXPECT_EQ(refusal("prey", kProximity, {error("dead")}), "there is no robot 'prey' with a controller");
  const std::string device = refusal("fb_1", "footbot_proximty", {error("dead")});
  EXPECT_EQ(device.rfind("footbot 'fb_1': found the device 'footbot_proximty', allowed: ", 0), 0U) << device;
  EXPECT_NE(device.find("; did you mean 'footbot_proximity'?"), std::string::npos) << device;
  const std::string kind = refusal("fb_1", kProximity, {error("stuk")});
  EXPECT_EQ(kind.rfind("found the error kind 'stuk', allowed: bias, ", 0), 0U) << kind;
  EXPECT_NE(kind.find("; did you mean 'stuck'?"), std::string::npos) << kind;
  EXPECT_EQ(refusal("fb_1", kProximity, {error("dead"), error("bias", "value[3]")}),
            "<error> of the kind 'bias' needs the attribute offset=\"...\"");
  EXPECT_EQ(refusal("fb_1", kProximity, {error("bias", "", {{"ofset", "1"}})}),
            "found attribute 'ofset', allowed: kind, id, field, from_tick, offset; did you mean 'offset'? (in "
            "<error>)");
  const std::string value = refusal("fb_1", kProximity, {error("drop_out", "", {{"probability", "1.5"}})});
  EXPECT_NE(value.find("found '1.5'"), std::string::npos) << value;
  const std::string field = refusal("fb_1", kWheels, {error("dead", "lft")});
  EXPECT_EQ(field.rfind("found the field 'lft', allowed: left, right", 0), 0U) << field;
  EXPECT_NE(field.find("(of footbot_wheels)"), std::string::npos) << field;
}

TEST(FaultInterventionTest, AResetAndADeletionTakeItAway) {
  FaultyRun run(twoRobots("3"));
  FaultyRun fresh(twoRobots("3"));
  run.set("fb_1", kProximity, {error("bias", "value[13]", {{"offset", "0.375"}})});
  run.set("fb_2", kWheels, {error("dead")});
  run.tick(3);
  run.simulation->reset();
  for (int i = 0; i < 5; ++i) {
    run.tick();
    fresh.tick();
    EXPECT_EQ(run.simulation->stateHash(), fresh.simulation->stateHash());
    EXPECT_EQ(run.deep(), fresh.deep());
  }
  run.set("fb_1", kProximity, {error("bias", "value[13]", {{"offset", "0.375"}})});
  run.set("fb_2", kProximity, {error("bias", "value[13]", {{"offset", "0.25"}})});
  run.simulation->apply(DeleteEntity{"fb_1"});
  EntityDescription again;
  again.type = "footbot";
  again.id = "fb_1";
  again.controller = "drive";
  again.position = {1.0, 1.0, 0.0};
  run.simulation->apply(SpawnEntity{again, {"ground"}});
  EXPECT_EQ(run.next("fb_1", 13), 0.0F);
  EXPECT_EQ(run.reading("fb_2", 13), 0.25F) << "whose place among the instances is another one now";
}

TEST(FaultInterventionTest, MovesHandoversAndOtherCommandSourcesKeepIt) {
  World world = twoRobots("3");
  world.engines = "<kinematics2d id='twin'/>";
  FaultyRun run(world);
  run.set("fb_1", kProximity, {error("bias", "value[13]", {{"offset", "0.375"}})});
  run.set("fb_1", kWheels, {error("dead")});
  run.simulation->apply(MoveEntity{"fb_1", {{2.25, 7.5, 0.0}, Eigen::Quaterniond::Identity()}});
  EXPECT_EQ(run.next("fb_1", 13), 0.375F);
  run.simulation->apply(HandOverEntity{"fb_1", "twin"});
  EXPECT_EQ(run.next("fb_1", 13), 0.375F);
  const Space& space = run.simulation->space();
  EXPECT_EQ(space.mover[space.entities.find("fb_1")]->id(), "twin");
  for (const CommandSource source : {CommandSource::kNone, CommandSource::kController}) {
    run.simulation->apply(SetCommandSource{"fb_1", source});
    EXPECT_EQ(run.next("fb_1", 13), 0.375F);
  }
  run.tick(3);
  EXPECT_NEAR(run.x("fb_1"), 2.25, 1e-12) << "its wheels are dead";
  EXPECT_GT(run.x("fb_2"), 7.0);
}

const char* const kFile =
    "<interventions>\n"
    "<fault tick='2' robot='fb_1' device='footbot_proximity'><error kind='random_walk' deviation='0.05'/></fault>\n"
    "<fault tick='3' robot='fb_2' device='footbot_wheels'><error kind='gaussian' field='left' deviation='0.5'/>"
    "<error kind='drop_out' probability='0.3'/></fault>\n"
    "<fault tick='9' robot='fb_2' device='footbot_wheels'/>\n"
    "</interventions>";

TEST(FaultInterventionTest, PlayedFromAFileItHasTheBitsOfTheSameAskedForByCode) {
  FaultyRun played(twoRobots("3").make());
  const InterventionFile file = parseInterventions(kFile, "f.xml", played.simulation->experiment());
  std::string written = interventionsBegin("", 0);
  for (const auto& each : file.interventions) {
    written += toXml(each.taken, 1);
  }
  auto once_more = twoRobots("3").make();
  once_more->play({parseInterventions(written + interventionsEnd(), "w.xml", once_more->experiment()).interventions,
                   AskedByRules::kLeftOut});
  FaultyRun from_file(std::move(once_more));
  FaultyRun asked(twoRobots("3"));
  std::vector<std::uint64_t> expected;
  for (std::uint64_t tick = 0; tick < 15; ++tick) {
    for (const auto& each : file.interventions) {
      if (each.taken.tick == tick) {
        asked.simulation->apply(each.taken.what);
      }
    }
    asked.tick();
    expected.push_back(asked.deep());
  }
  EXPECT_NE(asked.x("fb_2") - 7.0, asked.x("fb_1") - 3.0);
  for (const char* run : {"first", "after a reset"}) {
    for (const std::uint64_t hash : expected) {
      from_file.tick();
      EXPECT_EQ(from_file.deep(), hash) << run;
    }
    from_file.simulation->reset();
  }
}

TEST(FaultInterventionTest, ATickThatIsMadeAgainHasTheSameReadings) {
  World world = twoRobots();
  FaultyRun here(world);
  const auto place = world.entities.find("<controller>");
  world.entities.replace(place, 12, "<controller source=\"remote\">");
  FaultyRun elsewhere(world);
  FakeParticipant participant(*elsewhere.simulation, "a", {"fb_1"});
  participant.join();
  const Errors errors{error("bias", "value", {{"offset", "0.5"}}),
                      error("random_walk", "value", {{"deviation", "0.01"}}), error("latency", "", {{"ticks", "2"}})};
  for (FaultyRun* run : {&here, &elsewhere}) {
    run->set("fb_1", kProximity, errors);
    run->tick(4);
  }
  participant.is_mute = true;
  EXPECT_FALSE(elsewhere.simulation->tick([] { return true; }));
  participant.is_mute = false;
  participant.answerLate();
  here.tick(3);
  elsewhere.tick(3);
  for (std::size_t sensor = 0; sensor < FootbotProximity::kCount; ++sensor) {
    EXPECT_NE(here.reading("fb_1", sensor), 0.5F);
    EXPECT_EQ(elsewhere.reading("fb_1", sensor), here.reading("fb_1", sensor)) << sensor;
  }
}

TEST(FaultInterventionTest, TicksWithFaultsAllocateNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  FaultyRun run(twoRobots("2"));
  run.set("fb_1", kProximity, {error("gaussian", "", {{"deviation", "0.1"}}), error("latency", "", {{"ticks", "5"}})});
  run.set("fb_2", kWheels, {error("random_walk", "", {{"deviation", "0.1"}}), error("stuck", "", {}, 15)});
  run.tick(10);
  const long before = heap_allocations;
  run.tick(20);
  EXPECT_EQ(heap_allocations - before, 0);
}

}  // namespace
}  // namespace swarmanoid::test
