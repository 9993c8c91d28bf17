// <error> elements in devices: interaction with motor limits, safe stops, and robots that are added and removed.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "device_world.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/footbot_ground.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

namespace swarmanoid::test {
namespace {

ErrorModelDescription listed(const std::string& kind, const std::string& field, const std::string& parameter = "",
                             const std::string& value = "") {
  ErrorModelDescription error;
  error.kind = kind;
  error.field = field;
  error.parameters = Configuration("error", "", {});
  if (!parameter.empty()) {
    error.parameters.set(parameter, value);
  }
  return error;
}

TEST(DeviceErrorsTest, MotorsLimitWhatErrorsMake) {
  DeviceWorld world;
  ActuatorUnderTest<FootbotWheels> wheels(world, world.addFootbot(1.0, 1.0), {},
                                          {listed("bias", "left", "offset", "100")});
  wheels.command.setAngularVelocity(1.0, 2.0);
  EXPECT_NEAR(wheels.actuate().left, 10.344827586206895, 1e-12);
  EXPECT_EQ(wheels.actuate().right, 2.0);
  EXPECT_EQ(wheels.command.left, 1.0) << "the command stays what it is";
}

TEST(DeviceErrorsTest, ALateMotorStopsLate) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  ActuatorUnderTest<FootbotWheels> wheels(world, robot, {}, {listed("latency", "", "ticks", "2")});
  wheels.command.setAngularVelocity(1.0, 1.0);
  std::vector<double> speeds;
  for (; world.space.tick < 10; ++world.space.tick) {
    if (world.space.tick == 5) {
      wheels.command.left = std::numeric_limits<double>::quiet_NaN();
    }
    wheels.actuate();
    if (world.space.tick == 5) {
      ASSERT_EQ(wheels.faulty.size(), 1U);
      wheels.stop();
    }
    speeds.push_back(world.space.actuation.find<FootbotWheels>(robot)->left);
  }
  EXPECT_EQ(speeds, (std::vector<double>{0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0}));
}

TEST(DeviceErrorsTest, RobotsThatComeAndGoKeepTheirErrors) {
  DeviceWorld world;
  const auto sensor = makeDevice<Sensor>(PluginKind::kSensor, FootbotProximity::kType, {},
                                         {listed("offset_spread", "value", "deviation", "0.2")});
  std::vector<Row> rows;
  std::vector<const FootbotProximity*> readings;
  for (int i = 0; i < 3; ++i) {
    rows.push_back(world.addFootbot(1.0 + 2.0 * i, 1.0));
    readings.push_back(static_cast<const FootbotProximity*>(sensor->add(world.space, rows.back())));
  }
  world.sense(*sensor);
  const FootbotProximity last = *readings[2];
  EXPECT_NE(last.value, readings[0]->value);
  sensor->remove(world.space, rows[0]);
  world.remove(rows[0]);
  ++world.space.tick;
  world.sense(*sensor);
  EXPECT_EQ(last.value, readings[2]->value);
}

constexpr float kBare = 300.0F / 765.0F;  // reading of ground sensors over the floor below

/// Readings of ground spots 2 and 7 over some ticks, with uniform noise of half width 0.05.
std::vector<std::array<double, 2>> noisy(int ticks, std::uint64_t seed, int bystanders) {
  DeviceWorld world(seed);
  world.space.floor.bare = {200, 100, 0};
  const Row robot = world.addFootbot(1.0, 1.0);
  SensorUnderTest<FootbotGround> ground(world, robot, {}, {listed("uniform", "value", "half_width", "0.05")});
  for (int i = 0; i < bystanders; ++i) {
    ground.sensor->add(world.space, world.addFootbot(3.0 + i, 5.0));
  }
  std::vector<std::array<double, 2>> values;
  for (; world.space.tick < static_cast<std::uint64_t>(ticks); ++world.space.tick) {
    const FootbotGround& readings = ground.sense();
    values.push_back({readings.value[2], readings.value[7]});
  }
  return values;
}

TEST(DeviceErrorsTest, NoiseIsThatOfTheExperimentFile) {
  std::vector<double> first;
  std::vector<double> differences;
  for (const auto& [one, other] : noisy(4000, 1, 0)) {
    EXPECT_NEAR(one, kBare, 0.05 + 1e-6);
    first.push_back(one);
    differences.push_back(one - other);
  }
  const Statistics statistics(first);
  EXPECT_NEAR(statistics.mean, kBare, 5.0 * 0.0289 / std::sqrt(4000.0));
  EXPECT_NEAR(statistics.deviation, 0.05 / std::sqrt(3.0), 0.001);
  EXPECT_NEAR(Statistics(differences).deviation, 0.05 * std::sqrt(2.0 / 3.0), 0.0015) << "a draw for each spot";
  EXPECT_EQ(noisy(50, 1, 0), noisy(50, 1, 5)) << "whoever else senses";
  EXPECT_NE(noisy(50, 1, 0), noisy(50, 2, 0));
}

/// A footbot at (1, 1) whose camera sees a prey 0.5 m ahead. The list of its blobs is outside the struct of the
/// readings.
class CameraFaultTest : public testing::Test {
 protected:
  CameraFaultTest() { world.addPrey(1.5, 1.0); }

  static float distance(const FootbotCamera& readings) {
    return readings.blobs.size() == 1 ? readings.blobs[0].distance : -1.0F;
  }

  DeviceWorld world;
  Row robot = world.addFootbot(1.0, 1.0);
};

TEST_F(CameraFaultTest, ListsAreWhatTheyWereAsSoonAsTheFaultEnds) {
  SensorUnderTest<FootbotCamera> camera(world, robot);
  EXPECT_FLOAT_EQ(distance(camera.sense()), 0.5F);
  camera.sensor->setFaults(world.space, robot, {bias("blobs[].distance", "0.25")});
  ++world.space.tick;
  EXPECT_FLOAT_EQ(distance(camera.sense()), 0.75F);
  camera.sensor->setFaults(world.space, robot, {listed("dead", "")});
  const FootbotCamera& readings = *world.space.readings.find<FootbotCamera>(robot);
  EXPECT_FLOAT_EQ(distance(readings), 0.5F) << "before the next tick: that of the camera itself";
  ++world.space.tick;
  EXPECT_EQ(camera.sense().blobs.size(), 0U);
  camera.sensor->setFaults(world.space, robot, {});
  EXPECT_FLOAT_EQ(distance(readings), 0.5F);
  EXPECT_TRUE(camera.sensor->faults(robot).empty());
}

TEST_F(CameraFaultTest, ListsWithErrorsAreToo) {
  SensorUnderTest<FootbotCamera> camera(world, robot, {}, {bias("blobs[].distance", "0.125")});
  EXPECT_FLOAT_EQ(distance(camera.sense()), 0.625F);
  camera.sensor->setFaults(world.space, robot, {bias("blobs[].distance", "0.25")});
  ++world.space.tick;
  EXPECT_FLOAT_EQ(distance(camera.sense()), 0.875F);
  camera.sensor->setFaults(world.space, robot, {});
  EXPECT_FLOAT_EQ(distance(*world.space.readings.find<FootbotCamera>(robot)), 0.625F);
  ++world.space.tick;
  EXPECT_FLOAT_EQ(distance(camera.sense()), 0.625F);
}

TEST(DeviceErrorsTest, AFaultThatDoesNotSuitLeavesTheOneThatIsThere) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  ActuatorUnderTest<FootbotWheels> wheels(world, robot);
  wheels.command.setAngularVelocity(1.0, 2.0);
  wheels.actuator->setFaults(world.space, robot, {bias("left", "0.75")});
  EXPECT_EQ(wheels.actuate().left, 1.75);
  EXPECT_THROW(wheels.actuator->setFaults(world.space, robot, {listed("dead", "lft")}), ConfigError);
  EXPECT_EQ(wheels.actuate().left, 1.75);
  EXPECT_EQ(wheels.actuator->faults(robot).size(), 1U);
  wheels.stop();
  EXPECT_EQ(world.space.actuation.find<FootbotWheels>(robot)->left, 0.75) << "a safe stop goes through it";
  EXPECT_EQ(world.space.actuation.find<FootbotWheels>(robot)->right, 0.0);
}

}  // namespace
}  // namespace swarmanoid::test
