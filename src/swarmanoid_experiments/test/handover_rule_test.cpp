// Handover rules of the experiment file, by which entities change the engine that moves them (thesis chapter 5).
#include <gtest/gtest.h>

#include "handover_world.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

REGISTER_ENGINE(swarmanoid::test::GlideEngine)

namespace swarmanoid::test {
namespace {

std::string rule(const std::string& entity, const std::string& to, const std::string& condition) {
  return "<handover entity=\"" + entity + "\" to=\"" + to + "\">" + condition + "</handover>";
}

std::string box(const std::string& tag, const std::string& minimum, const std::string& maximum) {
  return "<" + tag + "><minimum>" + minimum + "</minimum><maximum>" + maximum + "</maximum></" + tag + ">";
}

/// "fb" drives along x by 1 cm per tick; "ground" and "twin" are in its plane, "sky" is a metre above.
World lineWorld(const std::string& rules) {
  World world;
  world.entities = footbot("fb", 1, 5, 0);
  world.members = member("fb");
  world.engines =
      "<kinematics2d id=\"twin\"/><kinematics2d id=\"sky\"><distance>1</distance></kinematics2d>"
      "<glide id=\"ice\"/>";
  world.drive = "<left>3.4482758620689655</left><right>3.4482758620689655</right>";
  world.physics = rules;
  world.ticks = 3000;
  return world;
}

/// "fb" grips "prey" in its first tick and releases it in tick 21.
World gripWorld(const std::string& rules) {
  World world = lineWorld(rules);
  world.entities = footbot("fb", 5, 5, 90) + prey("prey", 5, 5.171);
  world.members = member("fb") + member("prey");
  world.drive = "<left>2</left><right>3</right><close_at>0</close_at><open_at>20</open_at>";
  return world;
}

/// The handover events of a number of ticks, each with its tick.
std::string story(Simulation& simulation, int ticks) {
  std::string text;
  for (int i = 0; i < ticks; ++i) {
    simulation.tick();
    for (const Event& event : simulation.space().events) {
      if (event.kind == Event::Kind::kHandedOver || event.kind == Event::Kind::kHandoverRefused) {
        text += std::to_string(simulation.space().tick) + " " + event.entity + " " + event.text + "; ";
      }
    }
  }
  return text;
}

std::string story(const World& world, int ticks) {
  auto simulation = world.make();
  simulation->start();
  return story(*simulation, ticks);
}

TEST(HandoverRuleTest, WhoEntersARegionChangesAndWhoLeavesItChangesBack) {
  const World world = lineWorld(rule("fb", "twin", box("inside", "1.255,4,0", "1.505,6,1")) +
                                rule("fb", "ground", box("outside", "1.255,4,0", "1.505,6,1")));
  // in tick n its position is 1 + n * 0.01
  EXPECT_EQ(story(world, 100), "26 fb from ground to twin; 51 fb from twin to ground; ");
}

TEST(HandoverRuleTest, ARegionHasSixSides) {
  for (const char* maximum : {"1.2,6,1", "9,4.9,1", "9,6,-0.1"}) {
    const std::string entered = story(lineWorld(rule("fb", "twin", box("inside", "1.05,4,-1", maximum))), 100);
    EXPECT_EQ(entered.empty(), std::string(maximum) != "1.2,6,1") << maximum;
  }
}

TEST(HandoverRuleTest, WhoStartsInARegionHasNotEnteredIt) {
  EXPECT_EQ(story(lineWorld(rule("fb", "twin", box("inside", "0,4,0", "1.2,6,1"))), 100), "");
  EXPECT_EQ(story(lineWorld(rule("fb", "twin", box("outside", "2,4,0", "3,6,1"))), 50), "");
}

TEST(HandoverRuleTest, WhoIsPutIntoARegionHasEnteredIt) {
  auto simulation = lineWorld(rule("fb", "twin", box("inside", "7,4,0", "8,6,1"))).make();
  simulation->start();
  simulation->apply(MoveEntity{"fb", {{7.5, 5, 0}, Eigen::Quaterniond::Identity()}});
  EXPECT_EQ(story(*simulation, 3), "1 fb from ground to twin; ");
}

TEST(HandoverRuleTest, GrippingAndLettingGo) {
  const std::string both = "1 prey from ground to twin; 1 fb from ground to twin; ";
  EXPECT_EQ(story(gripWorld(rule("fb", "twin", "<attached/>")), 50), both);
  EXPECT_EQ(story(gripWorld(rule("fb", "twin", "<attached as=\"gripper\"/>")), 50), both);
  EXPECT_EQ(story(gripWorld(rule("fb", "twin", "<attached as=\"gripped\"/>")), 50), "");
  EXPECT_EQ(story(gripWorld(rule("prey", "twin", "<attached/>")), 50), both);
  EXPECT_EQ(story(gripWorld(rule("prey", "twin", "<attached as=\"gripped\"/>")), 50), both);
  EXPECT_EQ(story(gripWorld(rule("prey", "twin", "<attached as=\"gripper\"/>")), 50), "");
  EXPECT_EQ(story(gripWorld(rule("fb", "twin", "<released/>")), 50), "21 fb from ground to twin; ");
  EXPECT_EQ(story(gripWorld(rule("prey", "twin", "<released as=\"gripped\"/>")), 50), "21 prey from ground to twin; ");
  EXPECT_EQ(story(gripWorld(rule("prey", "twin", "<released as=\"gripper\"/>")), 50), "");
  EXPECT_EQ(story(gripWorld(rule("fb", "twin", "<attached/>") + rule("fb", "ground", "<released/>")), 50),
            both + "21 fb from twin to ground; ");
}

TEST(HandoverRuleTest, AControllerSaysWhen) {
  World world = lineWorld(rule("fb", "twin", "<debug key=\"state\">done</debug>"));
  world.drive += "<say_at>7</say_at>";
  EXPECT_EQ(story(world, 50), "8 fb from ground to twin; ");
  world.physics = rule("fb", "twin", "<debug key=\"state\">ready</debug>");
  EXPECT_EQ(story(world, 50), "");
  world.physics = rule("fb", "twin", "<debug key=\"mood\">done</debug>");
  EXPECT_EQ(story(world, 50), "");
}

TEST(HandoverRuleTest, ARefusalIsReportedOnceAndTriedAgainWhileTheConditionHolds) {
  // the post blocks the twin until it is moved away
  World world = lineWorld(rule("fb", "twin", box("inside", "1.095,4,0", "1.605,6,1")));
  world.entities += prey("post", 1.15, 5.1);
  world.physics = "<engine id=\"twin\">" + member("post") + "</engine>" + world.physics;
  auto simulation = world.make();
  simulation->start();
  EXPECT_EQ(story(*simulation, 15), "10 fb to twin: overlaps 'post'; ");
  simulation->apply(DeleteEntity{"post"});
  EXPECT_EQ(story(*simulation, 1), "16 fb from ground to twin; ");
}

TEST(HandoverRuleTest, WhatIsRefusedStaysAndIsReportedAgainForEachTimeItEnters) {
  auto simulation = lineWorld(rule("fb", "sky", box("inside", "1.095,4,0", "1.205,6,1"))).make();
  auto without = lineWorld("").make();
  simulation->start();
  without->start();
  const std::string refused = " fb to sky: found at z = 0, allowed: in the engine's plane, z = 1; ";
  EXPECT_EQ(story(*simulation, 40), "10" + refused);
  story(*without, 40);
  EXPECT_EQ(simulation->stateHash(), without->stateHash());
  for (Simulation* each : {simulation.get(), without.get()}) {
    each->apply(MoveEntity{"fb", {{1, 5, 0}, Eigen::Quaterniond::Identity()}});
  }
  EXPECT_EQ(story(*simulation, 40), "50" + refused);
  story(*without, 40);
  EXPECT_EQ(simulation->stateHash(), without->stateHash());
}

TEST(HandoverRuleTest, TheConnectedGoTogetherOrNotAtAll) {
  World world = gripWorld(rule("fb", "twin", "<attached/>"));
  world.entities += prey("post", 5.05, 5.26);
  world.physics = "<engine id=\"twin\">" + member("post") + "</engine>" + world.physics;
  EXPECT_EQ(story(world, 1), "1 fb to twin: connected cylindric_prey 'prey': overlaps 'post'; ");
}

/// Robots placed and driven at random; the twin moves those in the middle until they leave it.
World crowd(int threads) {
  World world;
  world.size = "4,4,2";
  world.bounded = true;
  world.framework = "<random_seed>5</random_seed><threads>" + std::to_string(threads) + "</threads>";
  world.entities =
      "<distribute quantity=\"60\" layout=\"uniform\"><minimum>0.3,0.3,0</minimum><maximum>3.7,3.7,0"
      "</maximum><footbot id=\"swarm\"><controller>drive</controller></footbot></distribute>";
  world.members = member("swarm");
  world.engines = "<kinematics2d id=\"twin\"/>";
  world.drive = "<left>0</left><right>0</right><random>true</random>";
  world.physics = rule("swarm", "twin", box("inside", "1,1,0", "3,3,1")) +
                  rule("swarm", "ground", box("outside", "0.9,0.9,0", "3.1,3.1,1"));
  world.ticks = 600;
  return world;
}

TEST(HandoverRuleTest, AGroupIsManyEntitiesAndThreadsChangeNothing) {
  auto alone = crowd(1).make();
  auto together = crowd(4).make();
  alone->start();
  together->start();
  std::size_t to_twin = 0;
  std::size_t to_ground = 0;
  for (int i = 0; i < 500; ++i) {
    const std::string expected = story(*alone, 1);
    EXPECT_EQ(story(*together, 1), expected);
    ASSERT_EQ(alone->stateHash(), together->stateHash()) << "tick " << i + 1;
    to_twin += expected.find("to twin;") != std::string::npos ? 1 : 0;
    to_ground += expected.find("to ground;") != std::string::npos ? 1 : 0;
  }
  EXPECT_GT(to_twin, 5U);
  EXPECT_GT(to_ground, 5U);
}

TEST(HandoverRuleTest, WatchingAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  World world = gripWorld(rule("fb", "twin", box("inside", "9,9,0", "10,10,1")) + rule("fb", "twin", "<released/>") +
                          rule("prey", "twin", "<attached as=\"gripper\"/>") +
                          rule("fb", "twin", "<debug key=\"state\">done</debug>"));
  world.drive = "<left>2</left><right>3</right><close_at>0</close_at><say_at>2000</say_at>";
  auto simulation = world.make();
  simulation->start();
  story(*simulation, 300);
  const long before = heap_allocations;
  for (int i = 0; i < 300; ++i) {
    simulation->tick();
  }
  EXPECT_EQ(heap_allocations - before, 0);
  EXPECT_NE(story(*simulation, 1500), "") << "and it was watching";
}

TEST(HandoverRuleTest, ARuleEndsWithItsEntityAndComesBackWithAReset) {
  auto simulation = lineWorld(rule("fb", "twin", box("inside", "1.255,4,0", "2,6,1"))).make();
  simulation->start();
  simulation->apply(DeleteEntity{"fb"});
  EntityDescription other;
  other.type = "footbot";
  other.id = "fb";
  other.controller = "drive";
  other.position = {1, 5, 0};
  simulation->apply(SpawnEntity{other, {"ground"}});
  EXPECT_EQ(story(*simulation, 50), "");
  simulation->reset();
  EXPECT_EQ(story(*simulation, 50), "26 fb from ground to twin; ");
  simulation->reset();
  EXPECT_EQ(story(*simulation, 50), "26 fb from ground to twin; ");
}

std::string refusalOf(const World& world) {
  try {
    world.make();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "(accepted)";
}

TEST(HandoverRuleLoadTest, WhatTheTargetCanNeverTakeIsRefusedAtLoad) {
  EXPECT_EQ(refusalOf(lineWorld(rule("fb", "ice", "<attached/>"))),
            "test.xml:1: handover of footbot 'fb' to engine 'ice': device 'footbot_wheels' cannot be simulated");
  World world = lineWorld(rule("wall", "twin", "<attached/>"));
  world.entities +=
      "<block id=\"wall\"><position>8,8,0.25</position><orientation>0,0,0</orientation>"
      "<size>0.1,2,0.5</size></block>";
  EXPECT_EQ(refusalOf(world), "test.xml:1: handover of block 'wall' to engine 'twin': is fixed, no engine moves it");
  world = gripWorld(rule("prey", "twin", "<debug key=\"state\">done</debug>"));
  EXPECT_EQ(refusalOf(world),
            "test.xml:1: handover of cylindric_prey 'prey' to engine 'twin': has no controller, so it has no debug "
            "values");
  world = crowd(1);
  world.bounded = false;  // the ice engine does not support walls
  world.engines += "<glide id=\"ice\"/>";
  world.physics = rule("swarm", "ice", "<attached/>");
  EXPECT_EQ(refusalOf(world),
            "test.xml:1: handover of footbot 'swarm_1' to engine 'ice': device 'footbot_wheels' cannot be simulated");
}

}  // namespace
}  // namespace swarmanoid::test
