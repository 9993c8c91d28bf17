// Infrared distance sensors in fixed directions: distances along the x axes of their links, by REP-117.
#include "swarmanoid_interface/devices/distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/devices/eyebot_distance.hpp"
#include "swarmanoid_interface/devices/handbot_distance.hpp"

namespace swarmanoid::test {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();
constexpr float kTooClose = -kNothing;

Eigen::Quaterniond turned(double yaw, double pitch = 0.0) {
  return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY());
}

/// A footbot with two distance sensors: one looks horizontally to its left, one ahead and down by 1.1 rad from 0.4 m.
std::shared_ptr<const EntityModel> pryingRobot() {
  auto model = std::make_shared<EntityModel>(*robotModel("footbot"));
  model->type = "prying_robot";
  model->mounts["distance_0"] = {{0.05, 0.02, 0.08}, turned(0.5), -1};
  model->mounts["distance_1"] = {{0.0, 0.0, 0.4}, turned(-2.0, 1.1), -1};
  return model;
}

TEST(DistanceTest, OfAnyRobotIsTheWayAlongTheLinksOwnAxis) {
  DeviceWorld world;
  const Row robot = world.add(pryingRobot(), {2.0, 3.0, 0.0}, 0.37);
  const Row wall = world.addWall({0.1, 4.0, 0.5}, {2.6, 3.0});
  SensorUnderTest<Distance> sensor(world, robot);
  ASSERT_EQ(2U, sensor.sense().sensors.size());
  // from x = 2.0393840 at 0.87 rad to the face at x = 2.55: 0.5106160 m / cos 0.87
  EXPECT_NEAR(0.7918656, sensor.sense().sensors[0].distance, 2e-6);
  EXPECT_NEAR(0.5, sensor.sense().sensors[0].angle, 1e-6);
  EXPECT_NEAR(0.0, sensor.sense().sensors[0].elevation, 1e-6);
  EXPECT_EQ(0.1F, sensor.sense().range_min);
  EXPECT_EQ(0.8F, sensor.sense().range_max);
  world.pose(wall).position.x() += 0.006;  // 0.8012 m away
  EXPECT_EQ(kNothing, sensor.sense().sensors[0].distance);
  world.pose(wall).position.x() = 2.0393841 + 0.05 + 0.0646;  // 0.0646 m / cos 0.87 away
  EXPECT_NEAR(0.1001820, sensor.sense().sensors[0].distance, 2e-6);
  world.pose(wall).position.x() -= 0.0003;
  EXPECT_EQ(kTooClose, sensor.sense().sensors[0].distance);
}

TEST(DistanceTest, TheFloorIsSeenLevelOrNot) {
  DeviceWorld world;
  const Row robot = world.add(pryingRobot(), {2.0, 3.0, 0.0}, 0.37);
  SensorUnderTest<Distance> sensor(world, robot);
  EXPECT_NEAR(0.4 / std::sin(1.1), sensor.sense().sensors[1].distance, 1e-6);
  EXPECT_NEAR(-2.0, sensor.sense().sensors[1].angle, 1e-6);
  EXPECT_NEAR(-1.1, sensor.sense().sensors[1].elevation, 1e-6);
  EXPECT_EQ(kNothing, sensor.sense().sensors[0].distance) << "looks level";
  world.space.terrain = std::make_shared<const Terrain>(Eigen::Vector2d(1.0, 2.0), Eigen::Vector2d(2.0, 2.0), 2, 2,
                                                        std::vector<double>{0.15, 0.15, 0.15, 0.15});
  EXPECT_NEAR(0.25 / std::sin(1.1), sensor.sense().sensors[1].distance, 1e-6);
  world.pose(robot).position = {4.0, 5.0, 0.0};
  EXPECT_NEAR(0.4 / std::sin(1.1), sensor.sense().sensors[1].distance, 1e-6) << "beside the terrain";
  world.pose(robot).position.z() = 0.32;
  EXPECT_EQ(kNothing, sensor.sense().sensors[1].distance) << "0.808 m to the floor";
}

TEST(DistanceTest, ThereIsNoFloorInAHole) {
  DeviceWorld world;
  const Row robot = world.add(pryingRobot(), {2.0, 3.0, 0.0}, 0.37);
  SensorUnderTest<Distance> sensor(world, robot);
  const double level = 0.4 / std::tan(1.1);  // horizontal distance from the sensor to its target
  const double bearing = 0.37 - 2.0;
  FloorHole hole;
  hole.position = {2.0 + level * std::cos(bearing) + 0.1, 3.0 + level * std::sin(bearing), 0.0};
  hole.radius = 0.1001;
  world.space.floor.holes = {hole};
  EXPECT_EQ(kNothing, sensor.sense().sensors[1].distance) << "just within its rim";
  world.space.floor.holes[0].radius = 0.0999;
  EXPECT_NEAR(0.4 / std::sin(1.1), sensor.sense().sensors[1].distance, 1e-6) << "just beside it";
}

TEST(DistanceTest, RobotsWithoutSensorsAreRefusedAndSoIsARangeWithoutInside) {
  EXPECT_EQ("found the device 'distances' on a footbot, allowed: on robots with links distance_0, ... (1 to 64)",
            refusalOf<SensorUnderTest<Distance>>(robotModel("footbot")));
  try {
    makeDevice<Sensor>(PluginKind::kSensor, Distance::kType, {{"range_min", "0.3"}, {"range_max", "0.3"}});
    FAIL() << "there is nothing that it could measure";
  } catch (const ConfigError& error) {
    EXPECT_STREQ("range_min: found 0.3, allowed: less than range_max, which is 0.3", error.what());
  }
}

/// Errors change finite distances only; distances that leave the field's range are read as out of range.
TEST(DistanceTest, ErrorsKeepInfinities) {
  DeviceWorld world;
  const Row robot = world.add(pryingRobot(), {2.0, 3.0, 0.0}, 0.37);
  const Parameters far_sighted{{"range_max", "20"}};
  SensorUnderTest<Distance> biased(world, robot, {}, {bias("sensors[].distance", "0.25")});
  EXPECT_EQ(kNothing, biased.sense().sensors[0].distance);
  EXPECT_NEAR(0.4 / std::sin(1.1) + 0.25, biased.sense().sensors[1].distance, 1e-6);
  const Row other = world.add(pryingRobot(), {2.0, 5.0, 0.0}, 0.37);
  SensorUnderTest<Distance> low(world, other, {}, {bias("sensors[].distance", "-0.5")});
  EXPECT_EQ(kTooClose, low.sense().sensors[1].distance) << "0.449 m - 0.5 m";
  EXPECT_EQ(kNothing, low.sense().sensors[0].distance);
  const Row third = world.add(pryingRobot(), {2.0, 7.0, 0.0}, 0.37);
  SensorUnderTest<Distance> high(world, third, far_sighted, {bias("sensors[].distance", "19.7")});
  EXPECT_EQ(kNothing, high.sense().sensors[1].distance) << "0.449 m + 19.7 m";
}

TEST(DistanceTest, NoErrorMakesADistanceOfWhatIsNone) {
  const auto error_of = [](const std::string& kind, const Parameters& parameters) {
    ErrorModelDescription error;
    error.kind = kind;
    error.field = "sensors[].distance";
    error.parameters = Configuration("error", "", {});
    for (const auto& [name, value] : parameters) {
      error.parameters.set(name, value);
    }
    return error;
  };
  for (const ErrorModelDescription& error : {error_of("saturation", {{"minimum", "0.2"}, {"maximum", "0.7"}}),
                                             error_of("factor", {{"mean", "-2"}, {"deviation", "0"}}),
                                             error_of("factor", {{"mean", "0"}, {"deviation", "0"}})}) {
    DeviceWorld world;
    const Row robot = world.add(pryingRobot(), {2.0, 3.0, 0.0}, 0.37);
    SensorUnderTest<Distance> sensor(world, robot, {}, {error});
    EXPECT_EQ(kNothing, sensor.sense().sensors[0].distance) << error.kind;
    world.addWall({0.1, 4.0, 0.5}, {2.0393841 + 0.05 + 0.05, 3.0});
    EXPECT_EQ(kTooClose, sensor.sense().sensors[0].distance) << error.kind;
  }
}

TEST(DistanceTest, EyebotsMeasureAroundUpwardsAndDownwards) {
  DeviceWorld world;
  const Row robot = world.addEyebot(5.0, 5.0, 1.2, 0.41);
  world.add(blockModel({3.0, 3.0, 0.1}), {5.0, 5.0, 2.9});
  const double way = 0.41 + 3.0 * M_PI / 8.0;  // direction of sensor 3
  world.addEyebot(5.0 + 1.13 * std::cos(way), 5.0 + 1.13 * std::sin(way), 1.2);
  SensorUnderTest<EyebotDistance> sensor(world, robot);
  const EyebotDistance& distance = sensor.sense();
  EXPECT_NEAR(1.13 - 0.25 - 0.25, distance.around[3], 1e-6);
  for (std::size_t i = 0; i < EyebotDistance::kAround; ++i) {
    EXPECT_EQ(i == 3, std::isfinite(distance.around[i])) << i;
    EXPECT_NEAR(std::remainder(static_cast<double>(i) * M_PI / 8.0 - EyebotDistance::angle(i), 2.0 * M_PI), 0.0, 1e-12);
  }
  EXPECT_NEAR(2.85 - 1.2 - 0.36, distance.up, 1e-6);
  EXPECT_NEAR(1.35, distance.down, 1e-6);
  // a pole between the two robots hides the other one
  world.addPrey(5.0 + 0.5 * std::cos(way), 5.0 + 0.5 * std::sin(way), colors::kBlack, 0.01, 2.0);
  EXPECT_NEAR(0.5 - 0.25 - 0.01, sensor.sense().around[3], 1e-6);
  world.pose(robot).position.z() = 0.0;
  EXPECT_EQ(kTooClose, sensor.sense().down) << "has landed";
  EXPECT_EQ(kNothing, sensor.sense().up);
  world.pose(robot).position.z() = 1.4;
  EXPECT_EQ(kNothing, sensor.sense().down) << "1.55 m";
}

TEST(DistanceTest, ATiltedEyebotMeasuresAlongItsOwnAxes) {
  DeviceWorld world;
  const Row robot = world.addEyebot(5.0, 5.0, 0.5);
  world.pose(robot).orientation = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX());
  SensorUnderTest<EyebotDistance> sensor(world, robot);
  EXPECT_NEAR((0.5 + 0.15 * std::cos(0.3)) / std::cos(0.3), sensor.sense().down, 1e-6);
  EXPECT_EQ(kNothing, sensor.sense().around[12]);
  const Row other = world.addEyebot(2.0, 2.0, 0.5);
  world.pose(other).orientation = world.pose(robot).orientation;
  SensorUnderTest<EyebotDistance> far_sighted(world, other, {{"range_max", "3"}});
  // the sensor to the right, 0.25 m aside and 0.29 m up, is 0.7031675 m above the floor and looks down by 0.3 rad
  EXPECT_NEAR(2.3794228, far_sighted.sense().around[12], 1e-6);
  EXPECT_EQ(kNothing, far_sighted.sense().around[4]) << "looks up";
  EXPECT_EQ(3.0F, far_sighted.sense().range_max);
}

TEST(DistanceTest, HandbotsMeasureAWallByTheAngleOfEachSensor) {
  DeviceWorld world;
  const Row robot = world.add(robotModel("handbot"), {4.0, 5.0, 0.0}, 0.2);
  world.addWall({0.1, 4.0, 0.5}, {4.0 + 0.36 + 0.05, 5.0});
  SensorUnderTest<HandbotDistance> sensor(world, robot);
  int finite = 0;
  for (std::size_t i = 0; i < HandbotDistance::kCount; ++i) {
    const double cosine = std::cos(0.2 + HandbotDistance::angle(i));
    const double distance = cosine > 0.0 ? 0.36 / cosine - HandbotDistance::kRingRadius : 1.0;
    finite += distance <= 0.3 ? 1 : 0;
    EXPECT_FLOAT_EQ(Distance::reading(distance, {0.04, 0.3}), sensor.sense().distance[i]) << i;
  }
  EXPECT_EQ(2, finite);
  world.pose(robot).position.x() += 0.187;
  EXPECT_EQ(kTooClose, sensor.sense().distance[0]) << "0.031 m";
  EXPECT_EQ(kTooClose, sensor.sense().distance[11]) << "0.037 m";
  EXPECT_NEAR(0.173 / std::cos(0.2 + M_PI / 6.0) - 0.145, sensor.sense().distance[1], 1e-6) << "0.086 m";
}

TEST(DistanceTest, LawOfRep117) {
  const Range range{0.2, 1.5};
  EXPECT_EQ(0.2F, Distance::reading(0.2, range));
  EXPECT_EQ(1.5F, Distance::reading(1.5, range));
  EXPECT_EQ(kTooClose, Distance::reading(0.1999, range));
  EXPECT_EQ(kTooClose, Distance::reading(-0.1, range));
  EXPECT_EQ(kNothing, Distance::reading(1.5001, range));
  EXPECT_EQ(kNothing, Distance::reading(kInfinity, range));
}

}  // namespace
}  // namespace swarmanoid::test
