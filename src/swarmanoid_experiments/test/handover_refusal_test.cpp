// Impossible handovers: rejected with a message, and without effect.
#include <gtest/gtest.h>

#include "handover_world.hpp"

REGISTER_ENGINE(swarmanoid::test::GlideEngine)

namespace swarmanoid::test {
namespace {

struct Refusal {
  const char* name;
  const char* engine;
  const char* message;
};

class HandoverRefusalTest : public testing::TestWithParam<Refusal> {};

/// "post" blocks the prey only, in the twin only; "wall" is fixed.
World obstructedWorld() {
  World world = carrierWorld();
  world.entities += prey("post", 5.05, 5.26) + footbot("other", 2, 2, 0) +
                    "<block id=\"wall\"><position>8,8,0.25</position><orientation>0,0,0</orientation>"
                    "<size>0.1,2,0.5</size></block>";
  world.members += member("other") + member("wall");
  world.physics = "<engine id=\"twin\">" + member("post") + "</engine>";
  return world;
}

TEST_P(HandoverRefusalTest, LeavesEverythingAsItWas) {
  auto with = started(obstructedWorld());
  auto without = started(obstructedWorld());
  tick(*with);
  tick(*without);
  const std::uint64_t hash = with->stateHash();
  try {
    with->apply(HandOverEntity{GetParam().name, GetParam().engine});
    FAIL() << "was accepted";
  } catch (const ConfigError& error) {
    EXPECT_EQ(std::string(error.what()), std::string(GetParam().message));
  }
  EXPECT_EQ(with->stateHash(), hash);
  EXPECT_EQ(moverOf(*with, "prey"), "ground");
  EXPECT_EQ(hashesOf(*with, 200), hashesOf(*without, 200));
}

INSTANTIATE_TEST_SUITE_P(
    All, HandoverRefusalTest,
    testing::Values(
        Refusal{"pray", "twin", "there is no entity 'pray'; did you mean 'prey'?"},
        Refusal{"fb", "twins",
                "engine 'twins' does not exist; there are: ground, twin, sky, ice; did you mean 'twin'?"},
        Refusal{"wall", "twin", "block 'wall' cannot be handed over to engine 'twin': is fixed, no engine moves it"},
        Refusal{"wall", "ground",
                "block 'wall' cannot be handed over to engine 'ground': is fixed, no engine moves it"},
        Refusal{"other", "sky",
                "footbot 'other' cannot be handed over to engine 'sky': found at z = 0, allowed: in the engine's "
                "plane, z = 1"},
        Refusal{"other", "ice",
                "footbot 'other' cannot be handed over to engine 'ice': device 'footbot_wheels' cannot be simulated"},
        Refusal{"prey", "twin", "cylindric_prey 'prey' cannot be handed over to engine 'twin': overlaps 'post'"},
        Refusal{
            "fb", "twin",
            "footbot 'fb' cannot be handed over to engine 'twin': connected cylindric_prey 'prey': overlaps 'post'"},
        Refusal{"prey", "ice",
                "cylindric_prey 'prey' cannot be handed over to engine 'ice': connected footbot 'fb': device "
                "'footbot_wheels' cannot be simulated"}));

/// Handover from rigid bodies to kinematics. @return reason of the rejection
std::string refusalOnGround(Simulation& simulation, const std::string& name) {
  const std::uint64_t hash = simulation.stateHash();
  std::string message = "(accepted)";
  try {
    simulation.apply(HandOverEntity{name, "ground"});
  } catch (const ConfigError& error) {
    message = error.what();
    EXPECT_EQ(simulation.stateHash(), hash);
  }
  return message;
}

TEST(HandoverDynamicsTest, GripsThatTheTargetCannotHoldAreRefused) {
  World world = carrierWorld();
  world.members = "";
  world.engines = "<dynamics2d id=\"solid\"/>";
  world.drive = "<left>0</left><right>0</right><close_at>0</close_at>";
  // one footbot behind the other; two more with a prey between them
  world.entities = footbot("fb", 5, 5, 90) + footbot("gb", 5, 5.196, 90) + prey("prey", 2, 2) +
                   footbot("left", 2 - 0.171, 2, 0) + footbot("right", 2 + 0.171, 2, 180);
  world.physics = "<engine id=\"solid\">" + member("fb") + member("gb") + member("prey") + member("left") +
                  member("right") + "</engine>";
  auto simulation = started(world);
  tick(*simulation, 3);
  const Space& space = simulation->space();
  ASSERT_EQ(space.structure.grippedBy(space.entities.find("fb")), space.entities.find("gb"));
  ASSERT_EQ(space.structure.grippersOf(space.entities.find("prey")).size(), 2U);
  EXPECT_EQ(refusalOnGround(*simulation, "fb"),
            "footbot 'fb' cannot be handed over to engine 'ground': grips the robot 'gb', which this engine "
            "cannot hold");
  EXPECT_EQ(refusalOnGround(*simulation, "prey"),
            "cylindric_prey 'prey' cannot be handed over to engine 'ground': connected footbot 'left': is "
            "not alone in gripping 'prey', which this engine cannot hold");
  simulation->apply(DeleteEntity{"right"});
  EXPECT_EQ(refusalOnGround(*simulation, "prey"), "(accepted)");
  EXPECT_EQ(moverOf(*simulation, "left"), "ground");
}

TEST(HandoverTest, TheMembersOfAStructureAreNotInEachOthersWay) {
  World world = carrierWorld();
  world.engines += "<glide id=\"lift\"><takes_wheels>true</takes_wheels></glide>";
  world.physics = "<engine id=\"lift\">" + member("fb") + "</engine>";
  auto simulation = started(world);
  tick(*simulation, 10);
  EXPECT_NO_THROW(simulation->apply(HandOverEntity{"prey", "lift"}));
  EXPECT_EQ(moverOf(*simulation, "fb"), "lift");
  simulation->apply(HandOverEntity{"prey", "twin"});
  EXPECT_NO_THROW(simulation->apply(HandOverEntity{"prey", "lift"})) << "mirrors of the members neither";
}

TEST(HandoverTest, WhatElseIsThereIsInTheWayMoverOrMirror) {
  // in these engines every other body blocks
  World world = obstructedWorld();
  for (const std::string id : {"lift", "hover"}) {
    world.engines += "<glide id=\"" + id + "\"><takes_wheels>true</takes_wheels></glide>";
  }
  world.physics += "<engine id=\"lift\">" + member("other") + "</engine>";
  auto simulation = started(world);
  tick(*simulation);
  simulation->apply(HandOverEntity{"other", "hover"});
  EXPECT_THROW(simulation->apply(HandOverEntity{"prey", "lift"}), ConfigError);
  EXPECT_NO_THROW(simulation->apply(HandOverEntity{"other", "lift"}));
  EXPECT_THROW(simulation->apply(HandOverEntity{"prey", "lift"}), ConfigError);
  simulation->apply(DeleteEntity{"other"});
  EXPECT_NO_THROW(simulation->apply(HandOverEntity{"prey", "lift"}));
}

}  // namespace
}  // namespace swarmanoid::test
