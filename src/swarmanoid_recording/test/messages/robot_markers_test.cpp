// Bodies of robots in rviz.
#include <gtest/gtest.h>

#include <set>

#include "swarmanoid_experiment_files/testing/small_world.hpp"
#include "swarmanoid_recording/messages/markers.hpp"

namespace swarmanoid {
namespace {

using visualization_msgs::Marker;

std::vector<Marker> bodies(const Space& space) {
  std::vector<Marker> found;
  for (const Marker& marker : arenaMarkers(space).markers) {
    if (marker.ns == "robots") {
      found.push_back(marker);
    }
  }
  return found;
}

TEST(RobotMarkersTest, MoveWithTheirFrames) {
  const auto simulation = test::smallWorld();
  simulation->start();
  std::set<std::string> frames;
  std::set<int> ids;
  for (const Marker& marker : bodies(simulation->space())) {
    EXPECT_TRUE(marker.frame_locked);
    EXPECT_TRUE(marker.header.stamp.isZero());  // otherwise rviz would wait for a transform of that time
    frames.insert(marker.header.frame_id);
    EXPECT_TRUE(ids.insert(marker.id).second);
    EXPECT_GT(marker.scale.x, 0.0);
    EXPECT_GT(marker.color.a, 0.0F);
  }
  std::set<std::string> expected;
  for (const Row row : simulation->space().entities.order) {
    if (simulation->space().entities.model[row]->is_robot) {
      const std::string& name = simulation->space().entities.name[row];
      expected.insert(name + "/base_link");
      // links on joints have their own frames
      for (const EntityModel::Joint& joint : simulation->space().entities.model[row]->joints) {
        expected.insert(name + "/" + joint.link);
      }
    }
  }
  EXPECT_EQ(expected, frames);
}

TEST(RobotMarkersTest, StandOnTheGround) {
  const auto simulation = test::smallWorld();
  simulation->start();
  for (const Marker& marker : bodies(simulation->space())) {
    if (marker.type == Marker::SPHERE) {
      EXPECT_GT(marker.pose.position.z, 0.0);
    }
    EXPECT_LT(std::abs(marker.pose.position.x), 0.5);
    EXPECT_GT(marker.pose.position.z, -0.05);
  }
}

TEST(RobotMarkersTest, AreLeftOutWhenTheirRobotIs) {
  const auto simulation = test::smallWorld();
  simulation->start();
  const std::size_t before = bodies(simulation->space()).size();
  std::string robot;
  for (const Row row : simulation->space().entities.order) {
    if (simulation->space().entities.model[row]->is_robot) {
      robot = simulation->space().entities.name[row];
    }
  }
  simulation->apply(DeleteEntity{robot});
  EXPECT_LT(bodies(simulation->space()).size(), before);
}

}  // namespace
}  // namespace swarmanoid
