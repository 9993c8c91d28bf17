// The eyebot's altimeter and its barometer.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "device_world.hpp"
#include "swarmanoid_interface/devices/eyebot_altitude.hpp"
#include "swarmanoid_interface/devices/eyebot_pressure.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

namespace swarmanoid::test {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();
constexpr float kTooClose = -kNothing;

class AltitudeTest : public testing::Test {
 protected:
  float at(const Eigen::Vector3d& position) {
    world.pose(robot).position = position;
    return altitude.sense().distance;
  }

  DeviceWorld world;
  Row robot = world.addEyebot(4.0, 5.0, 1.37, 0.7);
  SensorUnderTest<EyebotAltitude> altitude{world, robot, {{"range", "2.5"}}};
};

TEST_F(AltitudeTest, IsTheHeightOfTheLowerFaceOverTheFloor) {
  EXPECT_NEAR(at({4.0, 5.0, 1.37}), 1.37, 1e-6);
  EXPECT_NEAR(at({4.0, 5.0, 0.0201}), 0.0201, 1e-6);
  EXPECT_NEAR(at({4.0, 5.0, 2.5}), 2.5, 1e-6);
  EXPECT_EQ(altitude.sense().range_max, 2.5F);
}

TEST_F(AltitudeTest, SaysWhenTheGroundIsTooCloseOrTooFar) {
  EXPECT_EQ(at({4.0, 5.0, 0.0199}), kTooClose);
  EXPECT_EQ(at({4.0, 5.0, 0.0}), kTooClose);
  EXPECT_EQ(at({4.0, 5.0, -3e-6}), kTooClose) << "it has sunk in";
  EXPECT_EQ(at({4.0, 5.0, 2.5001}), kNothing);
}

TEST_F(AltitudeTest, IsOverWhateverIsBelow) {
  world.addWall({0.5, 0.5, 0.43}, {6.0, 6.0});
  EXPECT_NEAR(at({6.1, 5.8, 1.37}), 0.94, 1e-6);
  EXPECT_NEAR(at({6.3, 5.8, 1.37}), 1.37, 1e-6);
  EXPECT_EQ(at({6.1, 5.8, 0.43 - 3e-6}), kTooClose) << "it stands there, and has sunk in";
  world.addPrey(2.0, 2.0, colors::kYellow, 0.06, 0.1);
  EXPECT_NEAR(at({2.03, 2.04, 2.55}), 2.45, 1e-6);
  EXPECT_EQ(at({2.05, 2.04, 2.55}), kNothing);
}

TEST_F(AltitudeTest, IsOverTerrainAlsoWhereItHasSunkIn) {
  world.space.terrain = std::make_shared<const Terrain>(Eigen::Vector2d(1.0, 2.0), Eigen::Vector2d(2.0, 2.0), 2, 2,
                                                        std::vector<double>{0.15, 0.15, 0.15, 0.15});
  EXPECT_NEAR(at({2.2, 3.1, 1.37}), 1.22, 1e-6);
  EXPECT_EQ(at({2.2, 3.1, 0.15 - 3e-6}), kTooClose);
  EXPECT_NEAR(at({3.3, 3.1, 1.37}), 1.37, 1e-6) << "beside the terrain";
}

TEST_F(AltitudeTest, ThereIsNoFloorInAHole) {
  FloorHole hole;
  hole.position = {4.0, 5.0, 0.0};
  hole.radius = 0.31;
  world.space.floor.holes = {hole};
  EXPECT_EQ(at({4.2, 5.1, 1.37}), kNothing);
  EXPECT_EQ(at({4.2, 5.1, 0.0}), kNothing);
  EXPECT_NEAR(at({4.3101, 5.0, 1.37}), 1.37, 1e-6) << "beside its rim";
  world.addPrey(4.2, 5.1);
  EXPECT_NEAR(at({4.2, 5.1, 1.37}), 1.27, 1e-6) << "what hangs there is seen";
}

TEST_F(AltitudeTest, LooksAlongTheRobotsOwnAxis) {
  world.pose(robot).orientation = Eigen::Quaterniond(Eigen::AngleAxisd(0.61, Eigen::Vector3d(0.6, 0.8, 0.0)));
  EXPECT_NEAR(at({4.0, 5.0, 1.37}), 1.37 / std::cos(0.61), 1e-6);
  world.pose(robot).orientation = Eigen::Quaterniond(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
  EXPECT_EQ(at({4.0, 5.0, 1.37}), kNothing);
}

TEST_F(AltitudeTest, SensingAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  altitude.sense();
  const long before = heap_allocations;
  altitude.sensor->sense(world.space, 0, 1);
  EXPECT_EQ(heap_allocations - before, 0);
}

/// Differences in the standard atmosphere, computed independently: 101325 Pa (1 - 0.0065 h / 288.15)^5.25588 at 1.37 m,
/// 0.42 m below the start and 2.5 m above it.
TEST(PressureTest, IsThatOfTheStandardAtmosphereAgainstTheStart) {
  DeviceWorld world;
  const Row robot = world.addEyebot(4.0, 5.0, 0.5);
  SensorUnderTest<EyebotPressure> pressure(world, robot);
  EXPECT_EQ(pressure.sense().difference, 0.0);
  world.pose(robot).position = {1.0, 2.0, 1.87};
  EXPECT_NEAR(pressure.sense().difference, -16.45693, 1e-4);
  world.pose(robot).position.z() = 0.08;
  EXPECT_NEAR(pressure.sense().difference, 5.04562, 1e-4);
  world.space.placed[robot] = world.space.tick;
  world.pose(robot).position.z() = 3.0;
  EXPECT_NEAR(pressure.sense().difference, -30.02926, 1e-4) << "also where it was carried";
}

}  // namespace
}  // namespace swarmanoid::test
