// Engine parameters that change during a run: from the next tick on, or not at all, and until a reset.
#include <gtest/gtest.h>

#include "handover_world.hpp"

namespace swarmanoid::test {
namespace {

/// A falling block in dynamics3d, a driving footbot in dynamics2d, and another one in kinematics2d.
World threeEngines() {
  World world;
  world.drive = "<left>5</left><right>5</right>";
  world.entities = footbot("fb", 8, 8, 0) + footbot("driver", 2, 2, 0) +
                   "<block id='falling'><position>5, 5, 1.5</position><orientation>0, 0, 0</orientation>"
                   "<size>0.1, 0.1, 0.1</size><mass>1</mass></block>";
  world.members = member("fb");
  world.engines = "<dynamics2d id='flat'><subclock>4</subclock></dynamics2d><dynamics3d id='deep'/>";
  world.physics =
      "<engine id='flat'><entity id='driver'/></engine>"
      "<engine id='deep'><entity id='falling'/><entity id='driver' role='mirror'/></engine>";
  return world;
}

double fallSpeed(const Simulation& simulation) { return -twistOf(simulation, "falling").linear.z(); }

std::string messageOf(Simulation& simulation, const std::string& engine, const NamedValues& values) {
  const std::uint64_t hash = simulation.stateHash();
  try {
    simulation.apply(SetEngineParameters{engine, values});
  } catch (const ConfigError& error) {
    EXPECT_EQ(simulation.stateHash(), hash);
    return error.what();
  }
  return "";
}

TEST(EngineParametersTest, ChangeWhatHappensFromTheNextTickOn) {
  const auto simulation = started(threeEngines());
  tick(*simulation, 2);
  ASSERT_NEAR(fallSpeed(*simulation), 2 * 0.981, 1e-9);
  const std::uint64_t hash = simulation->stateHash();
  simulation->apply(SetEngineParameters{"deep", {{"gravity", "1.5"}}});
  EXPECT_EQ(simulation->stateHash(), hash);
  EXPECT_EQ(simulation->engineParameters("deep").text("gravity"), "1.5");
  tick(*simulation);
  EXPECT_NEAR(fallSpeed(*simulation), 2 * 0.981 + 0.15, 1e-9);
  EXPECT_EQ(eventsIn(*simulation), "intervention  dynamics3d 'deep': gravity from 9.81 to 1.5; ");
  tick(*simulation);
  EXPECT_EQ(eventsIn(*simulation), "");
}

TEST(EngineParametersTest, TreelsWithoutFrictionDriveAgainOnceTheyHaveIt) {
  const auto simulation = started(threeEngines());
  simulation->apply(SetEngineParameters{"flat", {{"treel_friction", "0"}}});
  tick(*simulation, 5);
  EXPECT_EQ(poseOf(*simulation, "driver").position.x(), 2.0);
  simulation->apply(SetEngineParameters{"flat", {{"treel_friction", "0.9"}}});
  tick(*simulation, 10);
  EXPECT_NEAR(twistOf(*simulation, "driver").linear.x(), 5.0 * 0.029, 1e-6);
}

TEST(EngineParametersTest, WhatSlidesInThePlaneTakesTheNewFriction) {
  const auto slideAfter = [](const std::string& friction) {
    World world = threeEngines();
    world.entities += prey("prey", 2.18, 2);  // right in front of the driver, which pushes it
    world.physics =
        "<engine id='flat'><entity id='driver'/><entity id='prey'/></engine>"
        "<engine id='deep'><entity id='falling'/></engine>";
    const auto simulation = started(world);
    tick(*simulation, 20);
    simulation->apply(SetEngineParameters{"flat", {{"ground_friction", friction}, {"treel_friction", "0"}}});
    const double x = poseOf(*simulation, "prey").position.x();
    tick(*simulation, 10);
    return poseOf(*simulation, "prey").position.x() - x;
  };
  EXPECT_LT(slideAfter("1"), 0.02);
  EXPECT_NEAR(slideAfter("0"), 5.0 * 0.029, 0.01);
}

TEST(EngineParametersTest, ABadValueIsRefusedInWords) {
  const auto simulation = started(threeEngines());
  const std::string live =
      "what may change while it runs: iterations, gravity, friction, treel_friction, restitution, "
      "grip_strength, suction_strength, rope_strength, rope_drag, magnet_strength";
  EXPECT_EQ(messageOf(*simulation, "dep", {{"gravity", "1"}}),
            "engine 'dep' does not exist; there are: ground, flat, deep; did you mean 'deep'?");
  EXPECT_EQ(messageOf(*simulation, "deep", {{"gravty", "1"}}),
            "dynamics3d 'deep' has no parameter 'gravty'; " + live + "; did you mean 'gravity'?");
  EXPECT_EQ(messageOf(*simulation, "deep", {{"subclock", "20"}}),
            "dynamics3d 'deep': 'subclock' cannot change while it runs; " + live);
  EXPECT_EQ(messageOf(*simulation, "ground", {{"subclock", "2"}}),
            "kinematics2d 'ground': 'subclock' cannot change while it runs; none of its parameters may change "
            "while it runs");
  EXPECT_EQ(messageOf(*simulation, "deep", {{"gravity", "-1"}}),
            "gravity: found '-1', allowed: a number from 0 to 100 (0, or at least 1e-09)");
  EXPECT_EQ(messageOf(*simulation, "deep", {{"gravity", "a lot"}}),
            "gravity: found 'a lot', allowed: a number from 0 to 100 (0, or at least 1e-09)");
}

TEST(EngineParametersTest, FactorsAreZeroOrLargeEnoughToBeMultiplied) {
  const NamedValues factors{{"gravity", "1e-9"},       {"friction", "1e-9"},        {"treel_friction", "1e-9"},
                            {"restitution", "1e-9"},   {"grip_strength", "1e-9"},   {"suction_strength", "1e-9"},
                            {"rope_strength", "1e-9"}, {"magnet_strength", "1e-9"}, {"rope_drag", "1e-9"}};
  World world = threeEngines();
  world.physics = "<engine id='deep'><entity id='falling'/><entity id='driver'/></engine>";
  const auto simulation = started(world);
  for (const auto& [name, least] : factors) {
    for (const char* const value : {"5e-324", "1e-310", "9.99e-10"}) {  // treel_friction 1e-310: assertion of ODE
      const std::string message = messageOf(*simulation, "deep", {{name, value}});
      EXPECT_EQ(message.rfind(name + ": found '" + value + "', allowed: a number from 0 to ", 0), 0U) << message;
      EXPECT_NE(message.find(" (0, or at least 1e-09)"), std::string::npos) << message;
    }
    EXPECT_EQ(messageOf(*simulation, "deep", {{name, "0"}}), "");
  }
  simulation->apply(SetEngineParameters{"deep", factors});
  tick(*simulation, 100);
  for (const char* const name :
       {"gravity", "ground_friction", "treel_friction", "contact_friction", "restitution", "grip_strength"}) {
    const std::string message = messageOf(*started(threeEngines()), "flat", {{name, "9.99e-10"}});
    EXPECT_NE(message.find(" (0, or at least 1e-09)"), std::string::npos) << name << ": " << message;
  }
}

TEST(EngineParametersTest, OneBadValueAmongGoodOnesChangesNothing) {
  const auto simulation = started(threeEngines());
  EXPECT_NE(messageOf(*simulation, "deep", {{"gravity", "1"}, {"friction", "11"}}), "");
  EXPECT_EQ(simulation->engineParameters("deep").text("gravity"), "9.81");
  tick(*simulation);
  EXPECT_NEAR(fallSpeed(*simulation), 0.981, 1e-9);
  EXPECT_EQ(eventsIn(*simulation), "");
}

TEST(EngineParametersTest, TheValueThatItHasIsNoChange) {
  const auto simulation = started(threeEngines());
  simulation->apply(SetEngineParameters{"deep", {{"gravity", "9.810"}, {"iterations", "50"}}});
  tick(*simulation);
  EXPECT_EQ(eventsIn(*simulation), "");
}

TEST(EngineParametersTest, TheSameChangesGiveTheSameBitsAndAResetUndoesThem) {
  const auto run = [](Simulation& simulation) {
    auto hashes = hashesOf(simulation, 4);
    simulation.apply(SetEngineParameters{"deep", {{"gravity", "3"}}});
    simulation.apply(SetEngineParameters{"flat", {{"treel_friction", "0.01"}, {"contact_friction", "0"}}});
    const auto later = hashesOf(simulation, 10);
    hashes.insert(hashes.end(), later.begin(), later.end());
    return hashes;
  };
  const auto untouched = hashesOf(*started(threeEngines()), 14);
  const auto first = started(threeEngines());
  const auto expected = run(*first);
  EXPECT_NE(expected, untouched);
  EXPECT_EQ(run(*started(threeEngines())), expected);
  first->reset();
  EXPECT_EQ(first->engineParameters("deep").text("gravity"), "9.81");
  EXPECT_EQ(hashesOf(*first, 14), untouched);
  first->reset();
  EXPECT_EQ(run(*first), expected);
}

TEST(EngineReportTest, SaysWhoIsWhere) {
  const auto simulation = started(threeEngines());
  tick(*simulation, 3);
  const std::vector<EngineReport> reports = simulation->engineReports();
  ASSERT_EQ(reports.size(), 3U);
  EXPECT_EQ(reports[0].label, "kinematics2d");
  EXPECT_EQ(reports[1].health.steps_per_tick, 4);
  EXPECT_EQ(reports[2].id, "deep");
  EXPECT_EQ(reports[2].moved, 1U);
  EXPECT_EQ(reports[2].mirrored, 1U);
  EXPECT_EQ(reports[2].health.warning, "");
  const std::vector<std::pair<std::string, std::string>> counters = {{"steps", "30"},
                                                                     {"bodies moved in them", "30"},
                                                                     {"steps solved again for friction", "0"},
                                                                     {"steps solved again for ropes", "0"},
                                                                     {"steps redone", "0"},
                                                                     {"steps left to the iterative solver", "0"},
                                                                     {"steps with large islands", "0"}};
  EXPECT_EQ(reports[2].health.counters, counters);
}

}  // namespace
}  // namespace swarmanoid::test
