// The colour of the topmost layer of the floor under a robot, bit for bit; black where there is no ground.
#include "swarmanoid_interface/devices/floor_color.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/devices/footbot_ground.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

namespace swarmanoid::test {
namespace {

constexpr Color kBareColor{200, 100, 1};
constexpr Color kDiscColor{51, 102, 153};

class FloorColorTest : public testing::Test {
 protected:
  void SetUp() override {
    world.space.floor.bare = kBareColor;
    FloorPatch disc;
    disc.position = {4.17, 5.25, 0.0};
    disc.radius = 0.06;
    disc.color = kDiscColor;
    world.space.floor.patches = {disc};
  }

  /// A footbot with a link that looks ahead and down by an angle, from 2 cm ahead of the origin and 3 cm above the
  /// ground.
  static std::shared_ptr<const EntityModel> withLink(double pitch) {
    auto model = std::make_shared<EntityModel>(*robotModel("footbot"));
    Mount& link = model->mounts["floor_color"];
    link.position = {0.02, 0.0, 0.03};
    link.orientation = Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY());
    return model;
  }

  DeviceWorld world;
};

TEST_F(FloorColorTest, OfAnyRobotIsThatUnderItsOrigin) {
  const Row robot = world.addFootbot(4.13, 5.27, 0.83);
  SensorUnderTest<FloorColor> floor(world, robot);
  // (0.04, 0.02) from the disc's centre: 0.0447 m
  EXPECT_EQ(floor.sense().color, kDiscColor);
  world.pose(robot).position = {4.13, 5.295, 0.0};  // 0.0602 m from it
  EXPECT_EQ(floor.sense().color, kBareColor);
  world.space.floor.bare = colors::kOrange;
  EXPECT_EQ(floor.sense().color, colors::kOrange);
}

/// Grey paint with strength 0.4 changes 200, 100 and 1 to 171, 111 and 52.
TEST_F(FloorColorTest, PaintIsMixedIn) {
  SensorUnderTest<FloorColor> floor(world, world.addFootbot(1.0, 1.0));
  world.space.floor.paint = PaintLayer({10.0, 10.0}, 0.02, 0.0);
  world.space.floor.paint.paint({{1.0, 1.0}, 0.2, colors::kGray, 0.4}, 0);
  EXPECT_EQ(floor.sense().color, (Color{171, 111, 52}));
}

TEST_F(FloorColorTest, TheLinkSaysWhereItLooks) {
  // 0.03 / tan(0.7) = 0.0356172 m ahead of the link on the floor, 0.0556172 m ahead of the origin
  const Row robot = world.add(withLink(0.7), {4.17 - 0.0556172 + 0.0599, 5.25, 0.0});
  SensorUnderTest<FloorColor> floor(world, robot);
  EXPECT_EQ(floor.sense().color, kDiscColor);
  world.pose(robot).position.x() += 0.0002;
  EXPECT_EQ(floor.sense().color, kBareColor);
  const Row other = world.add(withLink(-0.7), {4.17, 5.25, 0.0});
  EXPECT_EQ((SensorUnderTest<FloorColor>(world, other).sense().color), colors::kBlack) << "it looks up";
}

TEST_F(FloorColorTest, BeyondTheRangeAndOverAHoleItIsBlack) {
  const Row robot = world.addFootbot(2.0, 2.0);
  SensorUnderTest<FloorColor> floor(world, robot);
  SensorUnderTest<FloorColor> far(world, world.addFootbot(3.0, 2.0), {{"range", "0.2"}});
  world.pose(robot).position.z() = 0.0449;
  EXPECT_EQ(floor.sense().color, kBareColor);
  world.pose(robot).position.z() = 0.0451;
  EXPECT_EQ(floor.sense().color, colors::kBlack);
  EXPECT_EQ(far.sense().color, kBareColor);
  world.pose(robot).position.z() = 0.0;
  FloorHole hole;
  hole.position = {2.3, 2.4, 0.0};
  hole.radius = 0.4999;
  world.space.floor.holes = {hole};
  EXPECT_EQ(floor.sense().color, kBareColor) << "0.1 mm before its rim";
  world.space.floor.holes[0].radius = 0.5001;
  EXPECT_EQ(floor.sense().color, colors::kBlack);
}

TEST_F(FloorColorTest, AgreesWithTheGroundSensorOfTheSamePlace) {
  auto model = std::make_shared<EntityModel>(*robotModel("footbot"));
  model->mounts["floor_color"] = model->mounts.at("ground_5");
  const Row robot = world.add(model, {4.13, 5.27, 0.0}, 0.83);
  SensorUnderTest<FloorColor> color(world, robot);
  SensorUnderTest<FootbotGround> ground(world, robot);
  for (int i = 0; i < 50; ++i) {
    world.pose(robot).position.x() = 4.07 + 0.0043 * i;
    EXPECT_EQ(static_cast<float>(color.sense().color.brightness()), ground.sense().value[5]) << i;
  }
}

TEST_F(FloorColorTest, AnErrorMayChangeIt) {
  SensorUnderTest<FloorColor> floor(world, world.addFootbot(1.0, 1.0), {}, {bias("color.red", "-20.4")});
  EXPECT_EQ(floor.sense().color, (Color{180, 100, 1})) << "rounded to whole numbers";
}

TEST_F(FloorColorTest, SensingAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  SensorUnderTest<FloorColor> floor(world, world.addFootbot(1.0, 1.0));
  const long before = heap_allocations;
  floor.sensor->sense(world.space, 0, 1);
  EXPECT_EQ(heap_allocations - before, 0);
}

}  // namespace
}  // namespace swarmanoid::test
