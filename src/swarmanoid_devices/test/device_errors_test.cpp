// <error> elements in devices: what the limits of motors, safe stops and robots that come and go make of them.
#include <gtest/gtest.h>

#include <limits>

#include "device_world.hpp"
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

}  // namespace
}  // namespace swarmanoid::test
