// Lamps that shine into a cone, seen by light sensors and cameras. A footbot's light sensors are 0.085 m from its axis
// and 0.06 m above the ground; its camera is on the axis, 0.28 m above the ground.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "device_world.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/light.hpp"
#include "swarmanoid_space/models/entity_type.hpp"
#include "swarmanoid_space/models/spot_light.hpp"

namespace swarmanoid::test {
namespace {

class SpotLightTest : public testing::Test {
 protected:
  /// @param tilt of the lamp's axis below the horizontal, before the rotation by the heading [rad]
  Row addSpot(const Eigen::Vector3d& position, double heading, double tilt, double aperture, double intensity = 1.0) {
    const Row row = world.add(spotLightModel(aperture, intensity), position, 0.0, colors::kWhite);
    world.pose(row).orientation =
        Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitY());
    return row;
  }

  DeviceWorld world;
  Row robot = world.addFootbot(4.0, 5.0);
};

TEST_F(SpotLightTest, ShinesWithTheSquareOfTheDistanceAndNotBesideItsCone) {
  // 0.5 m from sensor 0, cosine 0.8: the way to the sensor has the direction -143.130102 degrees
  const Eigen::Vector3d place(4.0 + 0.085 + 0.4, 5.3, 0.06);
  SensorUnderTest<Light> sensor(world, robot);
  const Row lamp = addSpot(place, -143.130102 * kDegree + 0.3, 0.0, 2.0 * (0.3 / kDegree + 1e-3), 3.0);
  EXPECT_NEAR(sensor.sense().sensors[0].value, 3.0 * 0.8 * 0.04, 1e-7);
  EXPECT_EQ(sensor.sense().sensors[12].value, 0.0F) << "looks away";
  world.space.properties[lamp][1] = 2.0 * (0.3 / kDegree - 1e-3);
  EXPECT_EQ(sensor.sense().sensors[0].value, 0.0F);
  world.space.properties[lamp][1] = 360.0;
  EXPECT_NEAR(sensor.sense().sensors[0].value, 3.0 * 0.8 * 0.04, 1e-7);
  world.space.properties[lamp][0] = 0.0;
  EXPECT_EQ(sensor.sense().sensors[0].value, 0.0F);
}

TEST_F(SpotLightTest, LightsSomeSensorsOfARobotOnly) {
  // straight down from 1.3 m above the sensors' plane, 0.105 m ahead of the robot's axis: it lights a disc of
  // the radius 1.3 m tan(2.2 degrees) = 0.049942 m
  constexpr double kLamp = 0.105;
  addSpot({4.0 + kLamp, 5.0, 1.36}, 0.0, M_PI / 2.0, 4.4, 800.0);
  SensorUnderTest<Light> sensor(world, robot);
  const Light& light = sensor.sense();
  int lit = 0;
  for (std::size_t i = 0; i < 24; ++i) {
    const double angle = 15.0 * static_cast<double>(i) * kDegree;
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d to_lamp = Eigen::Vector2d(kLamp, 0.0) - 0.085 * direction;
    const bool is_lit = to_lamp.norm() <= 0.049942 && to_lamp.dot(direction) > 0.0;
    EXPECT_EQ(light.sensors[i].value > 0.0F, is_lit) << i;
    lit += is_lit ? 1 : 0;
  }
  EXPECT_EQ(lit, 3) << "the foremost sensor and its neighbours";
  world.pose(robot).position.x() += 0.03;
  for (const auto& moved : sensor.sense().sensors) {
    EXPECT_EQ(moved.value, 0.0F) << "the lamp is above the body, behind all sensors";
  }
}

TEST_F(SpotLightTest, CastsShadows) {
  addSpot({5.5, 5.0, 0.06}, M_PI, 0.0, 40.0, 100.0);
  SensorUnderTest<Light> sensor(world, robot);
  const float open = sensor.sense().sensors[0].value;
  EXPECT_NEAR(open, 100.0 * 0.01 / (1.415 * 1.415), 1e-6);
  const Row post = world.addPrey(4.8, 5.0, colors::kBlack, 0.02, 0.3);
  EXPECT_EQ(sensor.sense().sensors[0].value, 0.0F);
  EXPECT_GT(sensor.sense().sensors[3].value, 0.0F) << "0.06 m aside";
  world.pose(post).position.z() = 0.07;
  EXPECT_EQ(sensor.sense().sensors[0].value, open) << "the ray runs under it";
}

TEST_F(SpotLightTest, CamerasSeeItThatLookIntoItsCone) {
  // the camera is 0.9 m before the lamp and 0.3 m aside: 18.434949 degrees
  const Row lamp = addSpot({4.9, 5.3, 0.28}, M_PI, 0.0, 2.0 * 18.44);
  SensorUnderTest<FootbotCamera> camera(world, robot);
  ASSERT_EQ(camera.sense().blobs.size(), 1U);
  EXPECT_EQ(camera.sense().blobs[0].color, colors::kWhite);
  EXPECT_NEAR(camera.sense().blobs[0].bearing, std::atan2(0.3, 0.9), 1e-6);
  world.space.properties[lamp][1] = 2.0 * 18.43;
  EXPECT_TRUE(camera.sense().blobs.empty());
}

TEST_F(SpotLightTest, IsAnArenaObjectWithItsParameters) {
  const Registry::Entry* entry = Registry::instance().find(PluginKind::kEntity, "spot_light");
  ASSERT_NE(entry, nullptr);
  Configuration parameters("spot_light", "", {});
  parameters.set("intensity", "7.5");
  parameters.set("aperture", "33");
  const auto model = makePlugin<EntityType>(*entry)->makeModel(parameters);
  EXPECT_EQ(model->properties[static_cast<std::size_t>(model->findProperty("intensity"))].initial, 7.5);
  EXPECT_EQ(model->properties[static_cast<std::size_t>(model->findProperty("aperture"))].initial, 33.0);
  EXPECT_TRUE(model->shapes.empty());
  EXPECT_EQ(makePlugin<EntityType>(*entry)->makeModel(parameters), model) << "equal ones share their model";
}

}  // namespace
}  // namespace swarmanoid::test
