#include "swarmanoid_hosts/robot_configuration.hpp"

#include <gtest/gtest.h>

namespace swarmanoid {
namespace {

const std::vector<KnownDevice> kKnown{{"footbot_wheels", false, "footbot", {"wheels/command", "cmd_vel"}},
                                      {"footbot_leds", false, "footbot", {"leds/command"}},
                                      {"eyebot_velocity", false, "eyebot", {"cmd_vel"}},
                                      {"footbot_proximity", true, "footbot", {"proximity"}},
                                      {"eyebot_camera", true, "eyebot", {"camera/blobs"}},
                                      {"handbot_rope", false, "handbot", {"rope/command"}},
                                      {"my_sensor", true, "", {"mine"}},
                                      {"my_wheels", false, "", {"wheels"}}};

Configuration smallest() {
  Configuration values("configuration", "", {"/fb_1_controller/configuration", 0});
  values.set("robot_type", "footbot");
  values.set("sensors", "footbot_proximity");
  values.set("actuators", "footbot_wheels, footbot_leds");
  return values;
}

std::string refusalOf(const Configuration& values) {
  try {
    readRobotConfiguration(values, kKnown);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

/// Returns the error of the smallest configuration with another value. @param key of that value
std::string refusalOf(const std::string& key, const std::string& text) {
  Configuration values("configuration", "", {"/c", 0});
  const Configuration base = smallest();
  for (const Configuration& value : base.children()) {
    if (value.name() != key) {
      values.set(value.name(), value.text());
    }
  }
  values.set(key, text);
  return refusalOf(values);
}

TEST(RobotConfiguration, HasDefaults) {
  const RobotConfiguration read = readRobotConfiguration(smallest(), kKnown);
  EXPECT_EQ("footbot", read.robot_type);
  EXPECT_EQ(std::chrono::milliseconds(100), read.period);
  EXPECT_EQ(1U, read.seed);
  ASSERT_EQ(1U, read.sensors.size());
  EXPECT_EQ("proximity", read.sensors[0].topic);
  ASSERT_EQ(2U, read.actuators.size());
  EXPECT_EQ("footbot_wheels", read.actuators[0].type);
  EXPECT_EQ("wheels/command", read.actuators[0].topic);
  EXPECT_EQ("footbot_leds", read.actuators[1].type);
  EXPECT_EQ(std::chrono::milliseconds(500), read.sensor_timeout);
  EXPECT_EQ(std::chrono::seconds(10), read.start_timeout);
  EXPECT_EQ(2.0, read.safe_stop.hover);
  EXPECT_TRUE(read.parameters.children().empty());
}

TEST(RobotConfiguration, ReadsEverything) {
  Configuration values = smallest();
  values.set("rate", "40");
  values.set("seed", "7");
  values.set("sensor_timeout", "0.25");
  values.set("start_timeout", "3");
  values.add(Configuration("topics", "", {})).set("footbot_wheels", "cmd_vel");
  values.add(Configuration("parameters", "", {})).set("speed", "0.1");
  Configuration& stop = values.add(Configuration("safe_stop", "", {}));
  stop.set("hover", "1");
  stop.set("descend_speed", "0.5");
  stop.set("descend_time", "4");
  const RobotConfiguration read = readRobotConfiguration(values, kKnown);
  EXPECT_EQ(std::chrono::milliseconds(25), read.period);
  EXPECT_EQ(7U, read.seed);
  EXPECT_EQ("cmd_vel", read.actuators[0].topic);
  EXPECT_EQ(0.1, read.parameters.number("speed"));
  EXPECT_EQ(std::chrono::milliseconds(250), read.sensor_timeout);
  EXPECT_EQ(std::chrono::seconds(3), read.start_timeout);
  EXPECT_EQ(1.0, read.safe_stop.hover);
  EXPECT_EQ(0.5, read.safe_stop.descend_speed);
  EXPECT_EQ(4.0, read.safe_stop.descend_time);
}

TEST(RobotConfiguration, MayHaveNoSensors) {
  EXPECT_EQ("", refusalOf("sensors", ""));
  EXPECT_EQ("", refusalOf("sensors", "my_sensor")) << "devices of one's own fit every robot";
}

/// Robots that exist as a description only have devices for any robot; no device names their type.
TEST(RobotConfiguration, TakesRobotsThatNoDeviceNames) {
  Configuration values("configuration", "", {"/c", 0});
  values.set("robot_type", "epuck");
  values.set("sensors", "my_sensor");
  values.set("actuators", "my_wheels");
  const RobotConfiguration read = readRobotConfiguration(values, kKnown);
  EXPECT_EQ("epuck", read.robot_type);
  EXPECT_EQ("wheels", read.actuators[0].topic);
  EXPECT_EQ("/c: robot_type: found 'epuck', allowed: footbot, eyebot, handbot", refusalOf("robot_type", "epuck"))
      << "it has devices of a footbot";
}

TEST(RobotConfiguration, SaysWhatIsWrongWithValues) {
  EXPECT_EQ("/c: robot_type: found 'footboot', allowed: footbot, eyebot, handbot; did you mean 'footbot'?",
            refusalOf("robot_type", "footboot"));
  EXPECT_EQ(
      "/c: sensors: found 'footbot_proximty', allowed for a footbot: footbot_proximity, my_sensor; did you mean "
      "'footbot_proximity'?",
      refusalOf("sensors", "footbot_proximty"));
  EXPECT_EQ("/c: sensors: found 'eyebot_camera', allowed for a footbot: footbot_proximity, my_sensor",
            refusalOf("sensors", "eyebot_camera"));
  EXPECT_EQ("/c: actuators: 'footbot_wheels' stands there twice",
            refusalOf("actuators", "footbot_wheels,footbot_wheels"));
  EXPECT_EQ("/c: rate: found '0', allowed: a number from 0.1 to 1000", refusalOf("rate", "0"));
  EXPECT_EQ("/c: sensor_timeout: found 'soon', allowed: a number from 0.01 to 3600",
            refusalOf("sensor_timeout", "soon"));
  EXPECT_NE("", refusalOf("seed", "-1"));
}

TEST(RobotConfiguration, SaysWhatIsWrongWithKeys) {
  EXPECT_EQ(
      "/c: 'sensor_time_out' is not known in <configuration>; allowed: robot_type, rate, seed, sensors, actuators, "
      "topics, parameters, sensor_timeout, start_timeout, safe_stop; did you mean 'sensor_timeout'?",
      refusalOf("sensor_time_out", "1"));
  Configuration values = smallest();
  values.add(Configuration("topics", "", {"/c", 0})).set("footbot_wheels", "cmdvel");
  EXPECT_EQ("/c: footbot_wheels: found 'cmdvel', allowed: wheels/command, cmd_vel; did you mean 'cmd_vel'?",
            refusalOf(values));
  values = smallest();
  values.add(Configuration("topics", "", {"/c", 0})).set("eyebot_velocity", "cmd_vel");
  EXPECT_EQ("/c: 'eyebot_velocity' is not known in <topics>; allowed: footbot_proximity, footbot_wheels, footbot_leds",
            refusalOf(values));
  values = smallest();
  values.add(Configuration("safe_stop", "", {"/c", 0})).set("hovr", "1");
  EXPECT_EQ(
      "/c: 'hovr' is not known in <safe_stop>; allowed: hover, descend_speed, descend_time; did you mean 'hover'?",
      refusalOf(values));
}

}  // namespace
}  // namespace swarmanoid
