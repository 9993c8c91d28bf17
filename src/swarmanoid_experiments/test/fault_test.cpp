// Faults of a device of one robot, which start and end at given ticks.
#include <gtest/gtest.h>

#include "faulty_run.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

namespace swarmanoid::test {
namespace {

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

}  // namespace
}  // namespace swarmanoid::test
