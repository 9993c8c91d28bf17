// Entities that change the engine that moves them while the experiment runs (thesis chapter 5), asked for from code.
#include <gtest/gtest.h>

#include <cmath>

#include "glide_engine.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "test_world.hpp"

REGISTER_ENGINE(swarmanoid::test::GlideEngine)

namespace swarmanoid::test {
namespace {

std::string prey(const std::string& id, double x, double y) {
  return "<cylindric_prey id=\"" + id + "\"><position>" + std::to_string(x) + "," + std::to_string(y) +
         ",0</position><orientation>0,0,0</orientation><radius>0.06</radius><height>0.1</height></cylindric_prey>";
}

/// A footbot that grips a prey in its first tick and drives on along an arc; two engines in its plane, one in another,
/// one that knows nothing of wheels.
World carrierWorld() {
  World world;
  world.ticks = 3000;
  world.entities = footbot("fb", 5, 5, 90) + prey("prey", 5, 5.171);
  world.members = member("fb") + member("prey");
  world.engines =
      "<kinematics2d id=\"twin\"/><kinematics2d id=\"sky\"><distance>1</distance></kinematics2d>"
      "<glide id=\"ice\"/>";
  world.drive = "<left>2</left><right>3</right><close_at>0</close_at>";
  return world;
}

std::string moverOf(const Simulation& simulation, const std::string& name) {
  const Space& space = simulation.space();
  const Engine* mover = space.mover[static_cast<std::size_t>(space.entities.find(name))];
  return mover == nullptr ? "" : mover->id();
}

std::string toldIn(const Simulation& simulation) {
  std::string told;
  for (const Event& event : simulation.space().events) {
    told += std::string(toString(event.kind)) + " " + event.entity + " " + event.text + "; ";
  }
  return told;
}

void tick(Simulation& simulation, int ticks = 1) {
  for (int i = 0; i < ticks; ++i) {
    simulation.tick();
  }
}

std::unique_ptr<Simulation> started(const World& world) {
  auto simulation = world.make();
  simulation->start();
  return simulation;
}

const Twist& twistOf(const Simulation& simulation, const std::string& name) {
  const Entities& entities = simulation.space().entities;
  return entities.twist[static_cast<std::size_t>(entities.find(name))];
}

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
    simulation.handover("fb", i % 2 == 0 ? "twin" : "ground");
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
    with->handover("fb", i % 2 == 0 ? "twin" : "ground");
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
    with->handover("fb", i % 2 == 0 ? "twin" : "ground");
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
  simulation->handover("fb", "twin");
  EXPECT_NE(simulation->stateHash(), hash) << "the hash knows who moves whom";
  simulation->handover("fb", "ground");
  EXPECT_EQ(simulation->stateHash(), hash);
  EXPECT_EQ(space.commands.find<FootbotWheels>(space.entities.find("fb")), wheels) << "controllers' references stay";
}

TEST(HandoverTest, WhatIsConnectedGoesAlongWhicheverIsNamed) {
  for (const char* named : {"fb", "prey"}) {
    auto simulation = started(carrierWorld());
    tick(*simulation, 3);
    simulation->handover(named, "twin");
    EXPECT_EQ(moverOf(*simulation, "fb"), "twin");
    EXPECT_EQ(moverOf(*simulation, "prey"), "twin");
    tick(*simulation);
    EXPECT_EQ(toldIn(*simulation), std::string("intervention ") + named +
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
  simulation->handover("fb", "ground");
  tick(*simulation);
  EXPECT_EQ(toldIn(*simulation), "");
}

TEST(HandoverTest, TheNewEngineGoesOnWithTheTwistOfTheOld) {
  auto simulation = started(carrierWorld());
  tick(*simulation, 10);
  simulation->remove("fb");  // the prey is let go in mid-motion
  const Pose start = poseOf(*simulation, "prey");
  const Twist twist = twistOf(*simulation, "prey");
  ASSERT_GT(twist.linear.norm(), 0.05);
  simulation->handover("prey", "ice");
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
  simulation->handover("fb", "twin");
  tick(*simulation);
  EXPECT_EQ(toldIn(*simulation), "intervention fb handover to twin; handed_over fb from no engine to twin; ");
  EXPECT_NE(poseOf(*simulation, "fb").position, Eigen::Vector3d(5, 5, 0));
  EXPECT_TRUE(simulation->space().entities_without_engine.empty());
}

struct Refusal {
  const char* name;
  const char* engine;
  const char* message;
};

class HandoverRefusalTest : public testing::TestWithParam<Refusal> {};

/// "post" in the way of the prey alone, in the twin only; "wall" is fixed.
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
    with->handover(GetParam().name, GetParam().engine);
    FAIL() << "was accepted";
  } catch (const ConfigError& error) {
    EXPECT_EQ(std::string(error.what()), "(no file): " + std::string(GetParam().message));
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

/// "fb" drives along x, moved on the ground; "gb" and "tb" stand in its way, gb on the ground, tb in the twin.
World mirroredWorld(const std::string& mirrored) {
  World world;
  world.entities = footbot("fb", 2, 5, 0);
  world.entities += footbot("tb", 4, 5, 0);
  world.members = member("fb");
  world.engines = "<kinematics2d id=\"twin\"/>";
  world.physics = "<engine id=\"twin\">" + member("tb") + mirrored + "</engine>";
  world.drive = "<left>3</left><right>3</right>";
  world.ticks = 1000;
  return world;
}

Row overlapIn(const Simulation& simulation, const std::string& engine_id, const std::string& name) {
  const Space& space = simulation.space();
  const auto row = static_cast<std::size_t>(space.entities.find(name));
  for (const Engine* engine : space.engines) {
    if (engine->id() == engine_id) {
      return engine->overlap(*space.entities.model[row], space.entities.pose[row], kNoRow);
    }
  }
  ADD_FAILURE() << "no engine " << engine_id;
  return kNoRow;
}

TEST(HandoverMirrorTest, MirrorAndMoverChangePlaces) {
  auto simulation = started(mirroredWorld("<entity id=\"fb\" role=\"mirror\"/>"));
  tick(*simulation, 10);
  simulation->handover("fb", "twin");
  EXPECT_EQ(moverOf(*simulation, "fb"), "twin");
  const double x = poseOf(*simulation, "fb").position.x();
  tick(*simulation, 10);
  EXPECT_NEAR(poseOf(*simulation, "fb").position.x(), x + 10 * 0.1 * 3 * 0.029, 1e-9) << "moved once, not twice";
  const Row fb = simulation->space().entities.find("fb");
  EXPECT_EQ(overlapIn(*simulation, "twin", "fb"), fb);
  EXPECT_EQ(overlapIn(*simulation, "ground", "fb"), fb) << "the ground keeps a mirror";
  const RayHit hit = simulation->space().castRay({{2, 5, 0.1}, {9, 5, 0.1}});
  EXPECT_EQ(hit.row, fb);
  EXPECT_NEAR(7 * hit.fraction, poseOf(*simulation, "fb").position.x() - 2 - 0.085, 1e-9) << "met where it is now";
  simulation->handover("fb", "ground");
  simulation->handover("fb", "twin");
  tick(*simulation);
  EXPECT_EQ(toldIn(*simulation),
            "intervention fb handover to ground; handed_over fb from twin to ground; "
            "intervention fb handover to twin; handed_over fb from ground to twin; ");
}

TEST(HandoverMirrorTest, AnEngineThatTheFileDoesNotNameForgetsWhatItGivesUp) {
  auto simulation = started(mirroredWorld(""));
  simulation->handover("fb", "twin");
  tick(*simulation, 5);
  const Row fb = simulation->space().entities.find("fb");
  EXPECT_EQ(overlapIn(*simulation, "twin", "fb"), fb);
  EXPECT_EQ(overlapIn(*simulation, "ground", "fb"), fb);
  simulation->handover("fb", "ground");
  EXPECT_EQ(overlapIn(*simulation, "twin", "fb"), kNoRow);
  EXPECT_EQ(overlapIn(*simulation, "ground", "fb"), fb);
}

TEST(HandoverMirrorTest, ItCollidesWithThoseOfItsNewEngine) {
  // robots of the twin do not move, for only "fb" is driven: "tb" stands where fb wants to go
  World world = mirroredWorld("");
  world.entities = footbot("fb", 2, 5, 0) + prey("tb", 3, 5);
  auto in_twin = started(world);
  auto on_ground = started(world);
  in_twin->handover("fb", "twin");
  tick(*in_twin, 150);
  tick(*on_ground, 150);
  EXPECT_LT(poseOf(*in_twin, "fb").position.x(), 3 - 0.06 - 0.085);
  EXPECT_GT(poseOf(*on_ground, "fb").position.x(), 3.2) << "parallel worlds";
}

TEST(HandoverMirrorTest, AMirrorIsInTheWayWhereItIsAndNotWhereItWas) {
  // the prey is let go in tick 21 and stands still; the ground has seen it last where it was a tick before
  World world = carrierWorld();
  world.drive += "<open_at>20</open_at>";
  auto simulation = started(world);
  tick(*simulation, 5);
  simulation->handover("fb", "twin");
  tick(*simulation, 16);
  EXPECT_NO_THROW(simulation->handover("fb", "ground"));
  EXPECT_EQ(moverOf(*simulation, "fb"), "ground");
  EXPECT_EQ(moverOf(*simulation, "prey"), "twin");
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
    simulation->handover("fb", i % 2 == 0 ? "solid" : "ground");
    EXPECT_EQ(poseOf(*simulation, "prey").position, pose.position);
    EXPECT_EQ(twistOf(*simulation, "prey").linear, twist.linear);
    tick(*simulation, 5);
    ASSERT_EQ(moverOf(*simulation, "prey"), i % 2 == 0 ? "solid" : "ground");
    ASSERT_EQ(space.structure.grippedBy(space.entities.find("fb")), space.entities.find("prey")) << i;
    // a rigid joint of Box2D gives a little; what it has given is what the kinematic engine goes on with
    EXPECT_NEAR((relative() - at_grip).norm(), 0.0, 0.005) << i;
    EXPECT_NEAR(twistOf(*simulation, "fb").linear.norm(), speed, 0.1 * speed) << "no jerk from a standstill";
  }
  EXPECT_TRUE(simulation->failures().empty());
}

/// Handed over from rigid bodies to kinematics. @return why not
std::string refusalOnGround(Simulation& simulation, const std::string& name) {
  const std::uint64_t hash = simulation.stateHash();
  std::string message = "(accepted)";
  try {
    simulation.handover(name, "ground");
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
            "(no file): footbot 'fb' cannot be handed over to engine 'ground': grips the robot 'gb', which this engine "
            "cannot hold");
  EXPECT_EQ(refusalOnGround(*simulation, "prey"),
            "(no file): cylindric_prey 'prey' cannot be handed over to engine 'ground': connected footbot 'left': is "
            "not alone in gripping 'prey', which this engine cannot hold");
  simulation->remove("right");
  EXPECT_EQ(refusalOnGround(*simulation, "prey"), "(accepted)");
  EXPECT_EQ(moverOf(*simulation, "left"), "ground");
}

TEST(HandoverLifeTest, WhatWasHandedOverCanBePutElsewhereDeletedAndSpawnedAnew) {
  auto simulation = started(carrierWorld());
  tick(*simulation, 5);
  simulation->handover("fb", "twin");
  simulation->move("fb", {{2, 2, 0}, Eigen::Quaterniond::Identity()});
  tick(*simulation, 5);
  EXPECT_NEAR((poseOf(*simulation, "fb").position - Eigen::Vector3d(2, 2, 0)).norm(), 0.0, 0.1);
  simulation->remove("fb");
  tick(*simulation, 5);
  EntityDescription again;
  again.type = "footbot";
  again.id = "fb";
  again.controller = "drive";
  again.position = {2, 2, 0};
  simulation->spawn(again, {"twin"});
  simulation->handover("fb", "ground");
  tick(*simulation, 5);
  EXPECT_EQ(moverOf(*simulation, "fb"), "ground");
  EXPECT_EQ(moverOf(*simulation, "prey"), "twin") << "it was let go there";
  EXPECT_TRUE(simulation->failures().empty());
}

TEST(HandoverLifeTest, AResetGivesEverythingBackToTheEngineOfTheFile) {
  auto used = started(carrierWorld());
  auto fresh = started(carrierWorld());
  tick(*used, 50);
  used->handover("prey", "twin");
  tick(*used, 50);
  used->reset();
  EXPECT_EQ(moverOf(*used, "fb"), "ground");
  EXPECT_EQ(moverOf(*used, "prey"), "ground");
  EXPECT_EQ(hashesOf(*used, 200), hashesOf(*fresh, 200));
}

}  // namespace
}  // namespace swarmanoid::test
