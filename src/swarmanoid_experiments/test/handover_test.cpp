// Handovers of entities between engines during a run (thesis chapter 5), requested by code.
#include <gtest/gtest.h>

#include <algorithm>

#include "handover_world.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

REGISTER_ENGINE(swarmanoid::test::GlideEngine)

namespace swarmanoid::test {
namespace {

void expectEqualToTheBit(const Simulation& a, const Simulation& b, const std::string& name) {
  EXPECT_EQ(poseOf(a, name).position, poseOf(b, name).position) << name;
  EXPECT_EQ(poseOf(a, name).orientation.coeffs(), poseOf(b, name).orientation.coeffs()) << name;
  EXPECT_EQ(twistOf(a, name).linear, twistOf(b, name).linear) << name;
  EXPECT_EQ(twistOf(a, name).angular, twistOf(b, name).angular) << name;
}

/// Hands the footbot over after each of a thousand ticks, to and fro. @return the hashes
std::vector<std::uint64_t> aThousandHandovers(Simulation& simulation) {
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < 1000; ++i) {
    simulation.tick();
    simulation.apply(HandOverEntity{"fb", i % 2 == 0 ? "twin" : "ground"});
    hashes.push_back(simulation.stateHash());
  }
  return hashes;
}

TEST(HandoverTest, AThousandWhileDrivingStraightChangeNothing) {
  World world = carrierWorld();
  world.entities = footbot("fb", 2, 5, 30);
  world.members = member("fb");
  world.drive = "<left>2</left><right>2</right>";
  auto with = started(world);
  auto without = started(world);
  for (int i = 0; i < 1000; ++i) {
    with->apply(HandOverEntity{"fb", i % 2 == 0 ? "twin" : "ground"});
    with->tick();
    without->tick();
    expectEqualToTheBit(*with, *without, "fb");
  }
  EXPECT_GT((poseOf(*with, "fb").position - Eigen::Vector3d(2, 5, 0)).norm(), 5.0) << "it has driven";
}

TEST(HandoverTest, AThousandWhileCarryingAPreyAlongAnArcLoseNothing) {
  auto with = started(carrierWorld());
  auto without = started(carrierWorld());
  const Space& space = with->space();
  double worst = 0.0;
  for (int i = 0; i < 1000; ++i) {
    tick(*with);
    tick(*without);
    with->apply(HandOverEntity{"fb", i % 2 == 0 ? "twin" : "ground"});
    for (const char* name : {"fb", "prey"}) {
      worst = std::max(worst, (poseOf(*with, name).position - poseOf(*without, name).position).norm());
      worst = std::max(worst, poseOf(*with, name).orientation.angularDistance(poseOf(*without, name).orientation));
      worst = std::max(worst, (twistOf(*with, name).linear - twistOf(*without, name).linear).norm());
      worst = std::max(worst, (twistOf(*with, name).angular - twistOf(*without, name).angular).norm());
      EXPECT_EQ(moverOf(*with, name), i % 2 == 0 ? "twin" : "ground");
    }
    ASSERT_EQ(space.structure.grippedBy(space.entities.find("fb")), space.entities.find("prey")) << i;
  }
  RecordProperty("worst_difference", std::to_string(worst * 1e15) + "e-15");
  EXPECT_LT(worst, 1e-9);
  EXPECT_GT(twistOf(*with, "prey").angular.z(), 0.1) << "it turns, and the prey with it";
}

TEST(HandoverTest, IsRepeatableWhateverTheThreads) {
  auto alone = started(carrierWorld());
  World world = carrierWorld();
  world.framework = "<threads>4</threads>";
  auto together = started(world);
  const auto hashes = aThousandHandovers(*alone);
  EXPECT_EQ(aThousandHandovers(*together), hashes);
  alone->reset();
  EXPECT_EQ(aThousandHandovers(*alone), hashes);
}

TEST(HandoverTest, ThereAndBackBetweenTwoTicksIsNothing) {
  auto simulation = started(carrierWorld());
  tick(*simulation, 10);
  const Space& space = simulation->space();
  const auto* wheels = space.commands.find<FootbotWheels>(space.entities.find("fb"));
  const std::uint64_t hash = simulation->stateHash();
  simulation->apply(HandOverEntity{"fb", "twin"});
  EXPECT_NE(simulation->stateHash(), hash) << "the hash knows who moves whom";
  simulation->apply(HandOverEntity{"fb", "ground"});
  EXPECT_EQ(simulation->stateHash(), hash);
  EXPECT_EQ(space.commands.find<FootbotWheels>(space.entities.find("fb")), wheels) << "controllers' references stay";
}

TEST(HandoverTest, WhatIsConnectedGoesAlongWhicheverIsNamed) {
  for (const char* named : {"fb", "prey"}) {
    auto simulation = started(carrierWorld());
    tick(*simulation, 3);
    simulation->apply(HandOverEntity{named, "twin"});
    EXPECT_EQ(moverOf(*simulation, "fb"), "twin");
    EXPECT_EQ(moverOf(*simulation, "prey"), "twin");
    tick(*simulation);
    EXPECT_EQ(eventsIn(*simulation), std::string("intervention ") + named +
                                         " handover to twin; handed_over prey from ground to twin; "
                                         "handed_over fb from ground to twin; ");
    const Eigen::Vector3d before = poseOf(*simulation, "prey").position;
    tick(*simulation, 20);
    EXPECT_GT((poseOf(*simulation, "prey").position - before).norm(), 0.1) << "still carried";
  }
}

TEST(HandoverTest, WhatIsMovedThereAlreadyStaysWithoutAWord) {
  auto simulation = started(carrierWorld());
  tick(*simulation, 3);
  simulation->apply(HandOverEntity{"fb", "ground"});
  tick(*simulation);
  EXPECT_EQ(eventsIn(*simulation), "");
}

TEST(HandoverTest, TheNewEngineGoesOnWithTheTwistOfTheOld) {
  auto simulation = started(carrierWorld());
  tick(*simulation, 10);
  simulation->apply(DeleteEntity{"fb"});  // this releases the moving prey
  const Pose start = poseOf(*simulation, "prey");
  const Twist twist = twistOf(*simulation, "prey");
  ASSERT_GT(twist.linear.norm(), 0.05);
  simulation->apply(HandOverEntity{"prey", "ice"});
  EXPECT_EQ(twistOf(*simulation, "prey").linear, twist.linear);
  tick(*simulation, 10);
  EXPECT_NEAR((poseOf(*simulation, "prey").position - start.position - twist.linear).norm(), 0.0, 1e-9);
  EXPECT_EQ(moverOf(*simulation, "prey"), "ice");
}

TEST(HandoverTest, WhatNobodyMovesCanBeTaken) {
  World world = carrierWorld();
  world.members = member("prey");
  auto simulation = started(world);
  tick(*simulation, 5);
  EXPECT_EQ(poseOf(*simulation, "fb").position, Eigen::Vector3d(5, 5, 0));
  simulation->apply(HandOverEntity{"fb", "twin"});
  tick(*simulation);
  EXPECT_EQ(eventsIn(*simulation), "intervention fb handover to twin; handed_over fb from no engine to twin; ");
  EXPECT_NE(poseOf(*simulation, "fb").position, Eigen::Vector3d(5, 5, 0));
  EXPECT_TRUE(simulation->space().entities_without_engine.isEmpty());
}

TEST(HandoverDynamicsTest, KinematicsAndRigidBodiesTakeOverFromEachOtherWithWhatIsGripped) {
  World world = carrierWorld();
  world.engines += "<dynamics2d id=\"solid\"><subclock>10</subclock></dynamics2d>";
  auto simulation = started(world);
  const Space& space = simulation->space();
  tick(*simulation, 10);
  const auto relative = [&] {
    const Pose& carrier = poseOf(*simulation, "fb");
    return Eigen::Vector3d(carrier.orientation.conjugate() * (poseOf(*simulation, "prey").position - carrier.position));
  };
  const Eigen::Vector3d at_grip = relative();
  const double speed = twistOf(*simulation, "fb").linear.norm();
  for (int i = 0; i < 100; ++i) {
    const Pose pose = poseOf(*simulation, "prey");
    const Twist twist = twistOf(*simulation, "prey");
    simulation->apply(HandOverEntity{"fb", i % 2 == 0 ? "solid" : "ground"});
    EXPECT_EQ(poseOf(*simulation, "prey").position, pose.position);
    EXPECT_EQ(twistOf(*simulation, "prey").linear, twist.linear);
    tick(*simulation, 5);
    ASSERT_EQ(moverOf(*simulation, "prey"), i % 2 == 0 ? "solid" : "ground");
    ASSERT_EQ(space.structure.grippedBy(space.entities.find("fb")), space.entities.find("prey")) << i;
    // a rigid joint of Box2D gives a little; the kinematic engine continues with the displaced pose
    EXPECT_NEAR((relative() - at_grip).norm(), 0.0, 0.005) << i;
    EXPECT_NEAR(twistOf(*simulation, "fb").linear.norm(), speed, 0.1 * speed) << "no jerk from a standstill";
  }
  EXPECT_TRUE(simulation->failures().empty());
}

TEST(HandoverLifeTest, WhatWasHandedOverCanBePutElsewhereDeletedAndSpawnedAnew) {
  auto simulation = started(carrierWorld());
  tick(*simulation, 5);
  simulation->apply(HandOverEntity{"fb", "twin"});
  simulation->apply(MoveEntity{"fb", {{2, 2, 0}, Eigen::Quaterniond::Identity()}});
  tick(*simulation, 5);
  EXPECT_NEAR((poseOf(*simulation, "fb").position - Eigen::Vector3d(2, 2, 0)).norm(), 0.0, 0.1);
  simulation->apply(DeleteEntity{"fb"});
  tick(*simulation, 5);
  EntityDescription again;
  again.type = "footbot";
  again.id = "fb";
  again.controller = "drive";
  again.position = {2, 2, 0};
  simulation->apply(SpawnEntity{again, {"twin"}});
  simulation->apply(HandOverEntity{"fb", "ground"});
  tick(*simulation, 5);
  EXPECT_EQ(moverOf(*simulation, "fb"), "ground");
  EXPECT_EQ(moverOf(*simulation, "prey"), "twin") << "it was let go there";
  EXPECT_TRUE(simulation->failures().empty());
}

TEST(HandoverLifeTest, AResetGivesEverythingBackToTheEngineOfTheFile) {
  auto used = started(carrierWorld());
  auto fresh = started(carrierWorld());
  tick(*used, 50);
  used->apply(HandOverEntity{"prey", "twin"});
  tick(*used, 50);
  used->reset();
  EXPECT_EQ(moverOf(*used, "fb"), "ground");
  EXPECT_EQ(moverOf(*used, "prey"), "ground");
  EXPECT_EQ(hashesOf(*used, 200), hashesOf(*fresh, 200));
}

}  // namespace
}  // namespace swarmanoid::test
