#include "swarmanoid_recording/messages/world_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "swarmanoid_experiment_files/testing/small_world.hpp"

namespace swarmanoid {
namespace {

TEST(WorldStateTest, HoldsEveryEntityInTheOrderOfNumbers) {
  const auto simulation = test::smallWorld();
  simulation->start();
  simulation->tick();
  swarmanoid_msgs::WorldState state;
  toMessage(simulation->space(), state);
  EXPECT_EQ("world", state.header.frame_id);
  EXPECT_EQ(ros::Time(1, 100000000), state.header.stamp);
  EXPECT_EQ(1U, state.tick);
  EXPECT_EQ(simulation->stateHash(), state.state_hash);
  EXPECT_EQ((std::vector<std::string>{"wall", "lamp", "prey", "fb_1", "fb_2", "eb"}), state.names);
  EXPECT_EQ("cylindric_prey", state.types[2]);
  EXPECT_EQ("", state.engines[3]);
  EXPECT_EQ("", state.gripped[3]);
  EXPECT_DOUBLE_EQ(2.0, state.poses[3].position.y);
  EXPECT_NEAR(std::sqrt(0.5), state.poses[3].orientation.z, 1e-12);
  EXPECT_FLOAT_EQ(1.0F, state.colors[2].r);  // yellow
  EXPECT_FLOAT_EQ(0.0F, state.colors[3].a);  // all LEDs are dark
}

TEST(WorldStateTest, StampsKeepRisingOverAReset) {
  const auto simulation = test::smallWorld();
  simulation->start();
  simulation->tick();
  const ros::Time before = stampOf(simulation->space());
  simulation->reset();
  EXPECT_GT(stampOf(simulation->space()), before);
  EXPECT_EQ(stampOf(simulation->space()), clockMessage(simulation->space()).clock);
}

TEST(WorldStateTest, RefusesPosesInOtherFramesAndNumbersThatAreNone) {
  std_msgs::Header header;
  geometry_msgs::Pose pose;
  pose.position.x = 2.0;
  EXPECT_DOUBLE_EQ(2.0, fromMessage(header, pose).position.x());
  EXPECT_DOUBLE_EQ(1.0, fromMessage(header, pose).orientation.w());  // a missing orientation
  header.frame_id = "map";
  EXPECT_THROW(fromMessage(header, pose), std::runtime_error);
  header.frame_id = "world";
  pose.position.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(fromMessage(header, pose), std::runtime_error);
}

TEST(WorldStateTest, OutsideChangesAreSeenOnce) {
  const auto simulation = test::smallWorld();
  simulation->start();
  OutsideChanges changes;
  EXPECT_TRUE(changes.look(simulation->space()));
  EXPECT_FALSE(changes.look(simulation->space()));
  simulation->apply(DeleteEntity{"fb_1"});
  EXPECT_TRUE(changes.look(simulation->space()));
  simulation->tick();
  EXPECT_TRUE(changes.look(simulation->space()));  // and its event
  simulation->tick();
  EXPECT_FALSE(changes.look(simulation->space()));
  simulation->apply(SetProperty{"lamp", "color", "blue"});
  simulation->tick();
  EXPECT_TRUE(changes.look(simulation->space()));
  simulation->tick();
  EXPECT_FALSE(changes.look(simulation->space()));
}

TEST(WorldStateTest, ADarkLampHasNoColour) {
  const auto simulation = test::smallWorld();
  simulation->start();
  swarmanoid_msgs::WorldState state;
  toMessage(simulation->space(), state);
  EXPECT_FLOAT_EQ(1.0F, state.colors[1].a);
  simulation->apply(SetProperty{"lamp", "intensity", "0"});
  toMessage(simulation->space(), state);
  EXPECT_FLOAT_EQ(0.0F, state.colors[1].a);
}

}  // namespace
}  // namespace swarmanoid
