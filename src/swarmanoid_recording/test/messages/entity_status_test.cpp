#include "swarmanoid_recording/messages/entity_status.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "swarmanoid_experiment_files/testing/small_world.hpp"
#include "swarmanoid_recording/messages/world_state.hpp"

namespace swarmanoid {
namespace {

using Response = swarmanoid_msgs::Inspect::Response;

swarmanoid_msgs::Inspect::Request named(const std::string& name) {
  swarmanoid_msgs::Inspect::Request request;
  request.name = name;
  return request;
}

swarmanoid_msgs::Inspect::Request nearTo(double x, double y, double z, double within) {
  swarmanoid_msgs::Inspect::Request request;
  request.near.x = x;
  request.near.y = y;
  request.near.z = z;
  request.within = within;
  return request;
}

TEST(EntityStatusTest, WhoHasNoControllerIsAPlaceAndAType) {
  const auto simulation = test::smallWorld();
  simulation->start();
  simulation->tick();
  Response answer;
  inspect(*simulation, named("fb_1"), answer);
  EXPECT_EQ(1U, answer.tick);
  EXPECT_EQ(stampOf(simulation->space()), answer.stamp);
  EXPECT_EQ("fb_1", answer.name);
  EXPECT_EQ("footbot", answer.type);
  EXPECT_DOUBLE_EQ(2.0, answer.pose.position.y);
  EXPECT_EQ("", answer.engine + answer.controller + answer.command_source + answer.failure + answer.gripped);
  EXPECT_TRUE(answer.devices.empty());
}

TEST(EntityStatusTest, WhoIsNotThereIsNamedAndTheClockIsRight) {
  const auto simulation = test::smallWorld();
  simulation->start();
  simulation->tick();
  Response answer;
  try {
    inspect(*simulation, named("fb_3"), answer);
    FAIL() << "there is no fb_3";
  } catch (const ConfigError& error) {
    EXPECT_STREQ("there is no entity 'fb_3'; did you mean 'fb_1'?", error.what());
  }
  EXPECT_EQ(1U, answer.tick);
  inspect(*simulation, named(""), answer);
  EXPECT_EQ("", answer.type);
}

TEST(EntityStatusTest, TheNearestIsFoundIfItIsNearEnough) {
  const auto simulation = test::smallWorld();
  const auto nameNear = [&](double x, double y, double z, double within) {
    Response answer;
    inspect(*simulation, nearTo(x, y, z, within), answer);
    return answer.name;
  };
  EXPECT_EQ("fb_1", nameNear(1.49, 2.1, 0.1, 5.0));
  EXPECT_EQ("fb_2", nameNear(1.51, 2.1, 0.1, 5.0));
  EXPECT_EQ("eb", nameNear(2.0, 2.0, 1.6, 5.0));
  EXPECT_EQ("fb_1", nameNear(1.3, 2.4, 0.0, 0.51));
  EXPECT_EQ("", nameNear(1.3, 2.4, 0.0, 0.49));
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ("fb_2", nameNear(2.0, 2.0, 0.0, infinity));
  EXPECT_THROW(nameNear(infinity, 0.0, 0.0, 1.0), std::runtime_error);
  EXPECT_THROW(nameNear(1.0, 2.0, 0.0, -1.0), std::runtime_error);
  EXPECT_THROW(nameNear(1.0, 2.0, 0.0, std::nan("")), std::runtime_error);
}

}  // namespace
}  // namespace swarmanoid
