// What device families draw, in worlds whose end points were computed beforehand. A footbot has infrared sensors 8.5 cm
// from its axis and 6 cm above the ground, and ground spots 6.3 cm from the axis and 5 mm above the ground. Its camera
// is 28 cm, its transmitter 13 cm and its top 14.6 cm above the ground.
#include "swarmanoid_space/device_drawing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "message_world.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/footbot_ground.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/imu.hpp"
#include "swarmanoid_interface/devices/light.hpp"
#include "swarmanoid_interface/devices/proximity.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

namespace swarmanoid::test {
namespace {

template <class Device>
DeviceDrawing drawn(const DeviceWorld& world, const Device& device, const DrawnRobots& robots = {}) {
  DeviceDrawing drawing(robots);
  device.draw(world.space, drawing);
  return drawing;
}

void expectNear(const Eigen::Vector3d& found, const Eigen::Vector3d& expected, const std::string& what) {
  EXPECT_NEAR((found - expected).norm(), 0.0, 1e-6)
      << what << ": found " << found.transpose() << ", expected " << expected.transpose();
}

/// A footbot at (4, 5), turned by 0.2 rad, 16.5 cm before a wall across x.
struct ProximityWorld : DeviceWorld {
  Row robot = addFootbot(4.0, 5.0, 0.2);
  Row wall = addWall({0.2, 2.0, 1.0}, {4.265, 5.0});
};

TEST(DeviceDrawingTest, RaysOfProximityEndWhereTheyHit) {
  ProximityWorld world;
  SensorUnderTest<FootbotProximity> proximity(world, world.robot);
  const FootbotProximity& readings = proximity.sense();
  const DeviceDrawing drawing = drawn(world, *proximity.sensor);
  ASSERT_EQ(drawing.lines().size(), 24U);
  expectNear(drawing.lines()[0].from, {4.0833057, 5.0168869, 0.06}, "sensor 0");
  expectNear(drawing.lines()[0].to, {4.165, 5.0334472, 0.06}, "its end");
  expectNear(drawing.lines()[1].to, {4.165, 5.0821192, 0.06}, "that of sensor 1");
  expectNear(drawing.lines()[12].from, {3.9166943, 4.9831131, 0.06}, "the sensor behind");
  expectNear(drawing.lines()[12].to, {3.8186877, 4.9632462, 0.06}, "its end, at the range");
  ASSERT_EQ(drawing.points().size(), 4U) << "of sensors 0, 1, 22 and 23";
  expectNear(drawing.points()[3].place, {4.165, 4.9897901, 0.06}, "hit of sensor 23");
  EXPECT_NEAR(readings.value[23], 0.0076272, 1e-6);
  EXPECT_EQ(drawing.lines()[23].color, (Color{111, 139, 189})) << "0.8 % of the way to red";
  EXPECT_EQ(drawing.lines()[12].color, (Color{110, 140, 190}));
}

TEST(DeviceDrawingTest, TheShadeIsThatOfWhatTheControllerReads) {
  ProximityWorld world;
  SensorUnderTest<Proximity> proximity(world, world.robot, {}, {bias("sensors[].value", "0.5")});
  proximity.sense();
  const DeviceDrawing drawing = drawn(world, *proximity.sensor);
  ASSERT_EQ(drawing.lines().size(), 24U);
  EXPECT_EQ(drawing.lines()[12].color, (Color{183, 70, 95})) << "the error alone";
  proximity.sensor->setFaults(world.space, world.robot, {bias("sensors[].value", "7")});
  proximity.sense();
  EXPECT_EQ(drawn(world, *proximity.sensor).lines()[12].color, colors::kRed) << "a fault";
}

TEST(DeviceDrawingTest, WhatMovedSinceIsWhereItIsNow) {
  ProximityWorld world;
  SensorUnderTest<FootbotProximity> proximity(world, world.robot);
  proximity.sense();
  world.pose(world.wall).position.x() -= 0.03;
  const DeviceDrawing drawing = drawn(world, *proximity.sensor);
  EXPECT_NEAR(drawing.lines()[0].to.x(), 4.135, 1e-9);
  EXPECT_EQ(drawing.lines()[23].color, (Color{111, 139, 189})) << "as it was read";
}

TEST(DeviceDrawingTest, LightIsARayAsLongAsTheValue) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0);
  world.add(lightModel(), {4.0 + 0.085 + 0.4, 5.3, 0.06}, 0.0, colors::kWhite);
  SensorUnderTest<Light> light(world, robot);
  const Light& readings = light.sense();
  const DeviceDrawing drawing = drawn(world, *light.sensor);
  std::size_t lit = 0;
  for (const LightReading& reading : readings.sensors) {
    lit += reading.value > 0.0F ? 1 : 0;
  }
  EXPECT_LT(lit, 20U) << "those behind are in the dark";
  ASSERT_EQ(drawing.lines().size(), lit);
  // 0.8 * (0.1 / 0.5)^2 = 0.032, times 10 cm
  expectNear(drawing.lines()[0].from, {4.085, 5.0, 0.06}, "sensor 0");
  expectNear(drawing.lines()[0].to, {4.0882, 5.0, 0.06}, "its end");
}

TEST(DeviceDrawingTest, GroundSpotsAreWhereTheyMeetTheFloor) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0, 0.7);
  FloorPatch patch;
  patch.position = {3.9440641, 5.0289857, 0.0};  // under spot 2
  patch.radius = 0.01;
  patch.color = {51, 102, 153};
  world.space.floor.patches.push_back(patch);
  SensorUnderTest<FootbotGround> ground(world, robot);
  ground.sense();
  const DeviceDrawing drawing = drawn(world, *ground.sensor);
  ASSERT_EQ(drawing.points().size(), 8U);
  ASSERT_EQ(drawing.lines().size(), 8U);
  expectNear(drawing.lines()[0].from, {4.0289857, 5.0559359, 0.005}, "spot 0");
  expectNear(drawing.points()[0].place, {4.0289857, 5.0559359, 0.0}, "what it sees");
  EXPECT_EQ(drawing.points()[2].color, (Color{102, 102, 102})) << "306 of 765";
  world.pose(robot).position.z() = 0.2;
  EXPECT_TRUE(drawn(world, *ground.sensor).points().empty()) << "no ground in range";
}

TEST(DeviceDrawingTest, ACameraHasLinesToItsBlobsAndItsFieldOfView) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0, 0.4);
  world.addPrey(5.1, 4.3, colors::kMagenta);
  world.addPrey(4.0, 7.5);  // out of range
  SensorUnderTest<FootbotCamera> camera(world, robot, {{"range", "1.9"}});
  ASSERT_EQ(camera.sense().blobs.size(), 1U);
  const DeviceDrawing drawing = drawn(world, *camera.sensor);
  ASSERT_EQ(drawing.lines().size(), 24U + 1U) << "a circle and a line";
  expectNear(drawing.lines()[0].from, {5.9, 5.0, 0.0}, "the circle");
  expectNear(drawing.lines()[6].from, {4.0, 6.9, 0.0}, "a quarter of it");
  expectNear(drawing.lines()[24].from, {4.0, 5.0, 0.28}, "the camera");
  expectNear(drawing.lines()[24].to, {5.1, 4.3, 0.05}, "the middle of the prey");
  EXPECT_EQ(drawing.lines()[24].color, colors::kMagenta);
  ASSERT_EQ(drawing.points().size(), 1U);
}

TEST(DeviceDrawingTest, ACameraThatLooksDownHasACone) {
  DeviceWorld world;
  const Row robot = world.addEyebot(3.3, 4.4, 1.65, 1.1);
  const auto radius = [&](const Parameters& parameters) {
    SensorUnderTest<EyebotCamera> camera(world, robot, parameters);
    const DeviceDrawing drawing = drawn(world, *camera.sensor);
    camera.sensor->remove(world.space, robot);
    EXPECT_EQ(drawing.lines().size(), 24U + 4U);
    expectNear(drawing.lines()[24].from, {3.3, 4.4, 1.8}, "the camera");
    return (drawing.lines()[24].to - Eigen::Vector3d(3.3, 4.4, 0.0)).norm();
  };
  EXPECT_NEAR(radius({{"aperture", "30"}}), 1.8 * 0.577350269, 1e-8);
  EXPECT_NEAR(radius({{"range", "0.9"}}), 0.9, 1e-9) << "the range is less than 1.8 m at 45 degrees";
}

TEST(DeviceDrawingTest, AMessageIsALineFromItsSender) {
  MessageWorld world;
  const Board a = world.footbot(3.1, 4.2, 0.7);
  const Board b = world.footbot(4.5, 3.3, -2.2);
  const Board c = world.footbot(9.0, 9.0);  // out of range
  a.command->send({1});
  c.command->send({2});
  world.exchange();
  const DeviceDrawing drawing = drawn(world, *world.receiver);
  ASSERT_EQ(drawing.lines().size(), 1U);
  expectNear(drawing.lines()[0].from, {3.1, 4.2, 0.13}, "the sender");
  expectNear(drawing.lines()[0].to, {4.5, 3.3, 0.13}, "the receiver");
  expectNear(drawing.points().at(0).place, {4.5, 3.3, 0.13}, "the receiver's end");
  EXPECT_TRUE(drawn(world, *world.sender).lines().empty()) << "who sends need not be heard";
  world.remove(a);
  EXPECT_TRUE(drawn(world, *world.receiver).lines().empty()) << "deleted since";
  world.exchange();
  EXPECT_TRUE(drawn(world, *world.receiver).points().empty()) << "nobody is heard";
  EXPECT_EQ(b.messages().size(), 0U);
}

TEST(DeviceDrawingTest, WhatAccelerometersFeelIsAnArrow) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0, 0.9);
  SensorUnderTest<Imu> imu(world, robot);
  const Eigen::Vector3d ahead(0.6216100, 0.7833269, 0.0);
  imu.sense();
  ++world.space.tick;
  world.space.entities.twist[robot].linear = 0.06 * ahead;
  imu.sense();
  const DeviceDrawing drawing = drawn(world, *imu.sensor);
  ASSERT_EQ(drawing.lines().size(), 3U);
  expectNear(drawing.lines()[0].from, {4.0, 5.0, 0.146}, "the top");
  // 0.6 m/s2 ahead and 9.81 m/s2 up, 2 cm for each m/s2
  expectNear(drawing.lines()[0].to, {4.0074593, 5.0093999, 0.3422}, "the tip");
}

TEST(DeviceDrawingTest, OnlyChosenRobotsAreDrawn) {
  DeviceWorld world;
  const Row first = world.addFootbot(2.0, 2.0);
  const Row second = world.addFootbot(4.0, 5.0);
  SensorUnderTest<FootbotProximity> proximity(world, first);
  proximity.sensor->add(world.space, second);
  proximity.sense();
  EXPECT_EQ(drawn(world, *proximity.sensor).lines().size(), 48U);
  EXPECT_EQ(drawn(world, *proximity.sensor, {false, {"e*"}}).lines().size(), 48U);
  const DeviceDrawing drawing = drawn(world, *proximity.sensor, {false, {"e2"}});
  ASSERT_EQ(drawing.lines().size(), 24U);
  expectNear(drawing.lines()[0].from, {4.085, 5.0, 0.06}, "that of the second");
  EXPECT_TRUE(drawn(world, *proximity.sensor, {false, {"fb"}}).lines().empty());
}

TEST(DeviceDrawingTest, DevicesWithoutALookDrawNothing) {
  DeviceWorld world;
  const ActuatorUnderTest<FootbotWheels> wheels(world, world.addFootbot(4.0, 5.0));
  EXPECT_FALSE(drawn(world, *wheels.actuator).isUsed());
}

TEST(DeviceDrawingTest, DrawingAgainAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  MessageWorld world;
  world.addPrey(3.4, 4.4);
  world.add(lightModel(), {3.5, 4.8, 0.3}, 0.0, colors::kWhite);
  std::vector<Board> boards;
  std::vector<std::shared_ptr<Sensor>> sensors{world.receiver};
  for (int i = 0; i < 7; ++i) {
    boards.push_back(world.footbot(3.0 + 0.25 * i, 4.1, 0.7 * i));
    boards.back().command->send({1});
  }
  for (const char* type : {Proximity::kType, FootbotProximity::kType, Light::kType, FootbotGround::kType,
                           FootbotCamera::kType, Imu::kType}) {
    sensors.push_back(makeDevice<Sensor>(PluginKind::kSensor, type, {}));
    for (const Board& board : boards) {
      sensors.back()->add(world.space, board.row);
    }
    world.sense(*sensors.back());
  }
  world.exchange();
  DeviceDrawing drawing;
  const auto draw = [&] {
    drawing.clear();
    for (const auto& sensor : sensors) {
      sensor->draw(world.space, drawing);
    }
    return drawing.lines().size();
  };
  const std::size_t lines = draw();
  // rings of rays, spots, circles and arrows of seven robots, messages of neighbours, and detections of cameras and
  // light sensors
  EXPECT_GT(lines, 7U * (24U + 24U + 8U + 24U + 3U) + 12U);
  const std::uint64_t state = stateHash(world.space);
  const std::uint64_t deep = deepHash(world.space);
  const long before = heap_allocations;
  EXPECT_EQ(draw(), lines);
  EXPECT_EQ(heap_allocations - before, 0);
  EXPECT_EQ(stateHash(world.space), state);
  EXPECT_EQ(deepHash(world.space), deep);
}

}  // namespace
}  // namespace swarmanoid::test
