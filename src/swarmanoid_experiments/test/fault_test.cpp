// Faults: what goes wrong with a device of one robot from a tick on, and is mended again.
#include <gtest/gtest.h>

#include <map>

#include "lockstep_world.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"
#include "swarmanoid_space/interventions/intervention_file.hpp"

namespace swarmanoid::test {
namespace {

using Errors = std::vector<ErrorModelDescription>;

ErrorModelDescription error(const std::string& kind, const std::string& field = "",
                            const std::map<std::string, std::string>& parameters = {}, std::uint64_t from_tick = 0) {
  ErrorModelDescription result;
  result.kind = kind;
  result.field = field;
  result.from_tick = from_tick;
  for (const auto& [name, value] : parameters) {
    result.parameters.set(name, value);
  }
  return result;
}

/// Two robots far from each other, and a prey 18 cm ahead of the first.
World twoRobots(const std::string& speed = "0") {
  World world;
  world.entities = footbot("fb_1", 3.0, 5.0, 0.0) + footbot("fb_2", 7.0, 5.0, 0.0) +
                   "<cylindric_prey id='prey'><position>3.18, 5, 0</position><orientation>0, 0, 0</orientation>"
                   "<radius>0.06</radius><height>0.1</height><color>yellow</color></cylindric_prey>";
  world.members = member("fb_1") + member("fb_2");
  world.drive = "<left>" + speed + "</left><right>" + speed + "</right>";
  return world;
}

/// The same world with elements in its proximity sensor.
std::unique_ptr<Simulation> withErrors(const std::string& elements) {
  loadBuiltInPlugins();
  std::string text = twoRobots().xml();
  const std::string sensor = "<footbot_proximity/>";
  text.replace(text.find(sensor), sensor.size(), "<footbot_proximity>" + elements + "</footbot_proximity>");
  return std::make_unique<Simulation>(parseExperiment(text, "test.xml"));
}

class FaultyRun {
 public:
  explicit FaultyRun(std::unique_ptr<Simulation> made) : simulation(std::move(made)) { simulation->start(); }
  explicit FaultyRun(const World& world) : FaultyRun(world.make()) {}

  void set(const std::string& robot, const std::string& device, const Errors& errors) {
    simulation->apply(SetFault{robot, device, errors});
  }
  void tick(int ticks = 1) {
    for (int i = 0; i < ticks; ++i) {
      simulation->tick();
    }
  }
  /// Of the proximity sensor, after one more tick.
  float next(const std::string& robot, std::size_t sensor) {
    tick();
    return reading(robot, sensor);
  }
  float reading(const std::string& robot, std::size_t sensor) const {
    const Space& space = simulation->space();
    return space.readings.find<FootbotProximity>(space.entities.find(robot))->value[sensor];
  }
  void movePrey(double x) { simulation->apply(MoveEntity{"prey", {{x, 5.0, 0.0}, Eigen::Quaterniond::Identity()}}); }
  double x(const std::string& robot) const { return poseOf(*simulation, robot).position.x(); }
  std::uint64_t deep() const { return deepHash(simulation->space()); }

  std::unique_ptr<Simulation> simulation;
};

const char* const kProximity = "footbot_proximity";
const char* const kWheels = "footbot_wheels";

TEST(FaultTest, ItIsOfThatDeviceOfThatRobotFromTheNextTickOnUntilItIsMended) {
  FaultyRun run(twoRobots());
  run.tick(2);
  run.set("fb_1", kProximity, {error("bias", "value[13]", {{"offset", "0.375"}})});
  EXPECT_EQ(run.reading("fb_1", 13), 0.0F) << "not before the next tick";
  EXPECT_EQ(run.next("fb_1", 13), 0.375F);
  EXPECT_EQ(run.reading("fb_1", 12), 0.0F);
  EXPECT_EQ(run.reading("fb_2", 13), 0.0F) << "of the same configuration";
  run.set("fb_1", kProximity, {error("bias", "value[12]", {{"offset", "0.25"}})});
  EXPECT_EQ(run.next("fb_1", 12), 0.25F);
  EXPECT_EQ(run.reading("fb_1", 13), 0.0F) << "the new fault takes the place of the old one";
  run.set("fb_1", kProximity, {});
  EXPECT_EQ(run.next("fb_1", 12), 0.0F);
}

TEST(FaultTest, StuckStaysDeadRestsAndMendedReadsWhatIsThere) {
  FaultyRun run(twoRobots());
  const float near = run.next("fb_1", 0);
  ASSERT_GT(near, 0.0F);
  run.set("fb_1", kProximity, {error("stuck")});
  EXPECT_EQ(run.next("fb_1", 0), near);
  run.movePrey(5.0);
  EXPECT_EQ(run.next("fb_1", 0), near);
  EXPECT_EQ(run.next("fb_1", 0), near);
  run.set("fb_1", kProximity, {});
  EXPECT_EQ(run.next("fb_1", 0), 0.0F);
  run.movePrey(3.18);
  run.set("fb_1", kProximity, {error("dead")});
  EXPECT_EQ(run.next("fb_1", 0), 0.0F);
  run.set("fb_1", kProximity, {});
  EXPECT_EQ(run.next("fb_1", 0), near);
}

TEST(FaultTest, ItActsAfterTheErrorsOfTheConfiguration) {
  FaultyRun run(withErrors("<error kind='bias' field='value[13]' offset='0.25'/>"));
  EXPECT_EQ(run.next("fb_1", 13), 0.25F);
  run.set("fb_1", kProximity, {error("factor", "value[13]", {{"mean", "2.5"}})});
  EXPECT_EQ(run.next("fb_1", 13), 0.625F) << "the other way round it would be 0.25";
  EXPECT_EQ(run.reading("fb_2", 13), 0.25F);
  run.set("fb_1", kProximity, {});
  EXPECT_EQ(run.reading("fb_1", 13), 0.25F) << "at once: what the last tick would have read";
  EXPECT_EQ(run.next("fb_1", 13), 0.25F);
}

TEST(FaultTest, ItsTicksAreThoseOfTheRun) {
  FaultyRun run(twoRobots());
  run.tick(3);
  run.set("fb_1", kProximity, {error("bias", "value[13]", {{"offset", "0.375"}}, 5)});
  EXPECT_EQ(run.next("fb_1", 13), 0.0F) << "tick 3";
  EXPECT_EQ(run.next("fb_1", 13), 0.0F);
  EXPECT_EQ(run.next("fb_1", 13), 0.375F) << "tick 5";
}

TEST(FaultTest, AStuckMotorDrivesOnWhoeverCommandsTheRobot) {
  const double way = 0.1 * 5.0 * FootbotWheels::kRadius;
  World world = twoRobots("5");
  world.entities.replace(world.entities.find("3.18, 5"), 7, "3.18, 9");
  FaultyRun run(world);
  run.tick(3);
  run.set("fb_1", kWheels, {error("stuck")});
  run.tick(1);
  for (const char* robot : {"fb_1", "fb_2"}) {
    run.simulation->apply(SetCommandSource{robot, CommandSource::kNone});
  }
  run.tick(4);
  EXPECT_NEAR(run.x("fb_1"), 3.0 + 8.0 * way, 1e-9);
  EXPECT_NEAR(run.x("fb_2"), 7.0 + 4.0 * way, 1e-9) << "its motors stop";
  run.set("fb_1", kWheels, {});
  run.tick(4);
  EXPECT_NEAR(run.x("fb_1"), 3.0 + 8.0 * way, 1e-9);
}

TEST(FaultTest, AFaultOfOneRobotAndItsMendingChangeNoBitOfOthers) {
  World world = twoRobots();
  world.entities.replace(world.entities.find("3.18, 5"), 7, "3.18, 9");
  world.drive = "<left>0</left><right>0</right><random>true</random>";
  FaultyRun disturbed(world);
  FaultyRun untouched(world);
  disturbed.set("fb_1", kWheels, {error("dead", "left")});
  disturbed.set("fb_1", kProximity, {error("gaussian", "value", {{"deviation", "0.1"}})});
  for (int i = 0; i < 30; ++i) {
    disturbed.tick();
    untouched.tick();
    const Pose& a = poseOf(*disturbed.simulation, "fb_2");
    const Pose& b = poseOf(*untouched.simulation, "fb_2");
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.orientation.coeffs(), b.orientation.coeffs());
    for (std::size_t sensor = 0; sensor < FootbotProximity::kCount; ++sensor) {
      EXPECT_EQ(disturbed.reading("fb_2", sensor), untouched.reading("fb_2", sensor));
    }
  }
  EXPECT_NE(disturbed.x("fb_1"), untouched.x("fb_1"));
}

TEST(FaultTest, ItDrawsBesideErrorsOfTheSameKind) {
  const char* const errors =
      "<error kind='bias' field='value[13]' offset='0.5'/>"
      "<error kind='gaussian' field='value[13]' deviation='0.02'/>";
  FaultyRun plain(withErrors(errors));
  FaultyRun disturbed(withErrors(errors));
  disturbed.set("fb_1", kProximity, {error("gaussian", "value[13]", {{"deviation", "0.02"}})});
  for (int i = 0; i < 5; ++i) {
    const double configured = static_cast<double>(plain.next("fb_1", 13)) - 0.5;
    const double fault = static_cast<double>(disturbed.next("fb_1", 13)) - 0.5 - configured;
    EXPECT_NE(fault, 0.0);
    EXPECT_GT(std::abs(fault - configured), 1e-6);
    EXPECT_EQ(disturbed.reading("fb_2", 13), plain.reading("fb_2", 13));
  }
  disturbed.set("fb_1", kProximity, {});
  disturbed.tick(2);
  plain.tick(2);
  EXPECT_EQ(disturbed.deep(), plain.deep()) << "the draws of the configuration are what they were";
}

TEST(FaultTest, ItIsAnEventAndATakenIntervention) {
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

TEST(FaultTest, WhatCannotBeIsRefusedInTheWordsOfTheExperimentFile) {
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

TEST(FaultTest, AResetAndADeletionTakeItAway) {
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

TEST(FaultTest, MovesHandoversAndOtherCommandSourcesKeepIt) {
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

TEST(FaultTest, PlayedFromAFileItHasTheBitsOfTheSameAskedForByCode) {
  FaultyRun played(twoRobots("3").make());
  const InterventionFile file = parseInterventions(kFile, "f.xml", played.simulation->experiment());
  std::string written = interventionsBegin("", 0);
  for (const auto& each : file.interventions) {
    written += toXml(each.taken, 1);
  }
  auto once_more = twoRobots("3").make();
  once_more->play(
      {parseInterventions(written + interventionsEnd(), "w.xml", once_more->experiment()), AskedByRules::kLeftOut});
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

TEST(FaultTest, ATickThatIsMadeAgainHasTheSameReadings) {
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

TEST(FaultTest, TicksWithFaultsAllocateNothing) {
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
