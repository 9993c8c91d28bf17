// Selection and order of the checks that the conformance test runs on a robot.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "../src/conformance/checks.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/devices/lidar.hpp"

namespace swarmanoid::conformance {
namespace {

struct Whistle {
  static constexpr const char* kType = "whistle_of_a_test";
  double loudness = 0.0;
};
template <class Visitor>
void fields(Visitor& visit, Whistle& whistle) {
  visit(whistle.loudness, {"loudness"});
}
REGISTER_DEVICE(Whistle, kActuator, "Makes a noise.")

int rests = 0;
const ChecksRegistration whistle_checks({Whistle::kType,
                                         [](Bench&) -> std::vector<Check> {
                                           return {{"whistles", {Whistle::kType}, "", {}, {}}};
                                         },
                                         [](Surroundings& usual) { usual.wall_distance = 3.0; },
                                         [](const Bench&) { ++rests; }});

/// A robot with devices at rest.
struct TestRobot {
  TestRobot(const std::string& type, const std::vector<std::string>& devices) : robot("r", type, 1) {
    for (const std::string& name : devices) {
      const DeviceType& device = *findDeviceType(name);
      values.push_back(device.make());
      if (device.kind == DeviceKind::kSensor) {
        robot.provideSensor(name, values.back().get());
      } else {
        robot.provideActuator(name, values.back().get());
      }
    }
  }

  std::vector<std::shared_ptr<void>> values;
  Robot robot;
};

std::vector<std::string> namesOf(const std::vector<Check>& checks) {
  std::vector<std::string> names;
  for (const Check& check : checks) {
    names.push_back(check.name);
  }
  return names;
}

std::vector<std::string> checksOf(const std::string& type, const std::vector<std::string>& devices,
                                  const Configuration& parameters = {"parameters", "", {}}) {
  TestRobot robot(type, devices);
  Bench bench(robot.robot, parameters);
  return namesOf(checksFor(bench));
}

using Names = std::vector<std::string>;

TEST(ConformanceChecks, OfARobotsOwnDevicesAreInTheirOrder) {
  EXPECT_EQ((Names{"footbot_leds", "footbot_camera", "wheels_ahead", "wheels_left", "footbot_proximity",
                   "gripper_closes", "footbot_turret", "gripper_opens"}),
            checksOf("footbot", {"footbot_wheels"}))
      << "those that are not listed too: they are named as unchecked";
  EXPECT_EQ((Names{"eyebot_leds", "eyebot_altitude", "eyebot_camera", "eyebot_position", "eyebot_pressure",
                   "velocity_in_the_plane", "yaw_left", "eyebot_laser", "velocity_up", "eyebot_magnet"}),
            checksOf("eyebot", {}));
  EXPECT_EQ((Names{"handbot_leds", "handbot_arms", "handbot_hands", "handbot_rope"}), checksOf("handbot", {}));
}

TEST(ConformanceChecks, OfOtherRobotsAreThoseOfTheirDevices) {
  EXPECT_EQ(Names{}, checksOf("epuck", {}));
  EXPECT_EQ(Names{"whistles"}, checksOf("epuck", {Whistle::kType}));
  EXPECT_EQ("whistles", checksOf("handbot", {Whistle::kType}).back());
  EXPECT_EQ(Names{"imu_at_rest"}, checksOf("epuck", {"imu"}));
  EXPECT_EQ((Names{"battery_plausible", "battery_drains"}), checksOf("epuck", {"battery"}));
  EXPECT_EQ((Names{"differential_drive", "imu_at_rest", "imu_turns"}),
            checksOf("epuck", {"differential_drive", "imu"}));
  EXPECT_EQ((Names{"rfid_reader", "rfid_reader_leaves", "differential_drive"}),
            checksOf("epuck", {"differential_drive", "rfid_reader"}));
  EXPECT_EQ((Names{"differential_drive", "positioning"}), checksOf("epuck", {"differential_drive", "positioning"}));
  EXPECT_EQ((Names{"differential_drive", "odometry", "wheel_encoders"}),
            checksOf("epuck", {"differential_drive", "odometry", "wheel_encoders"}));
}

TEST(ConformanceChecks, AnObserverLooksThroughTheCameraThatIsListed) {
  Configuration parameters("parameters", "", {});
  parameters.set("role", "observer");
  TestRobot with("eyebot", {"eyebot_camera", Whistle::kType});
  Bench bench(with.robot, parameters);
  const std::vector<Check> checks = checksFor(bench);
  ASSERT_EQ(Names{"leds_of_the_other"}, namesOf(checks));
  EXPECT_EQ(Names{"eyebot_camera"}, checks[0].devices);
  EXPECT_EQ("", checks[0].obstacle);
  TestRobot without("eyebot", {Whistle::kType});
  Bench blind(without.robot, parameters);
  EXPECT_EQ("no camera is listed", checksFor(blind)[0].obstacle);
}

TEST(ConformanceChecks, AnObserverAnswersListensAndLooksByWhatIsListed) {
  Configuration parameters("parameters", "", {});
  parameters.set("role", "observer");
  const auto checksWith = [&](const std::vector<std::string>& devices) {
    return checksOf("footbot", devices, parameters);
  };
  EXPECT_EQ((Names{"leds_of_the_other", "loudspeaker_of_the_other", "wifi_of_the_other"}),
            checksWith({"wifi", "wifi_received", "footbot_camera", "footbot_microphones"}));
  EXPECT_EQ(Names{"range_and_bearing_of_the_other"}, checksWith({"range_and_bearing", "range_and_bearing_received"}));
  parameters.set("one_color", "true");
  EXPECT_EQ(Names{"one_color_of_the_other"}, checksWith({"footbot_camera"}));
  parameters.set("observed_leds", "0");
  EXPECT_EQ(Names{"loudspeaker_of_the_other"}, checksWith({"footbot_camera", "microphones"}));
}

TEST(ConformanceChecks, HoldersThatHoldAreAListOfNumbers) {
  TestRobot robot("epuck", {});
  const auto heldBy = [&robot](const char* text) {
    Configuration parameters("parameters", "", {});
    parameters.set("held", text);
    return Bench(robot.robot, parameters).surroundings().held;
  };
  EXPECT_EQ((std::vector<std::size_t>{0, 2}), heldBy("0, 2"));
  EXPECT_EQ(std::vector<std::size_t>{}, heldBy(""));
  EXPECT_THROW(heldBy("8"), ConfigError);
  EXPECT_THROW(heldBy("left"), ConfigError);
}

TEST(ConformanceChecks, ThePanTiltCameraMissesThePreyBeforeAnythingElse) {
  const auto obstacleWith = [](const char* prey_distance, const char* laser_height) {
    TestRobot robot("eyebot", {"eyebot_pan_tilt", "eyebot_pan_tilt_camera"});
    Configuration parameters("parameters", "", {});
    parameters.set("prey_distance", prey_distance);
    parameters.set("laser_height", laser_height);
    Bench bench(robot.robot, parameters);
    for (const Check& check : checksFor(bench)) {
      if (check.name == "eyebot_pan_tilt") {
        return check.obstacle;
      }
    }
    return std::string("is not checked");
  };
  EXPECT_EQ("there is no prey (prey_distance is 0)", obstacleWith("0", "1.3"));
  EXPECT_EQ("there is no prey (prey_distance is 0)", obstacleWith("0", "0"));
  EXPECT_EQ("the height of the robot is not known (laser_height is 0)", obstacleWith("0.7", "0"));
  EXPECT_EQ("the prey lies too near below the robot", obstacleWith("0.2", "1.3"));
  EXPECT_EQ("", obstacleWith("0.7", "1.3"));
}

TEST(ConformanceChecks, ALidarMeasuresTheWallOnTheRight) {
  TestRobot robot("epuck", {Lidar::kType});
  Configuration parameters("parameters", "", {});
  parameters.set("wall_distance", "0.8");
  Bench bench(robot.robot, parameters);
  const std::vector<Check> checks = checksFor(bench);
  ASSERT_EQ(Names{Lidar::kType}, namesOf(checks));
  EXPECT_EQ("", checks[0].obstacle);
  std::vector<LidarBeam> beams(36);
  auto& lidar = *static_cast<Lidar*>(robot.values[0].get());
  lidar.beams = beams;
  /// @param bearing of the wall, which is 0.74 m away
  const auto failureWithWallTo = [&](double bearing) {
    for (std::size_t i = 0; i < beams.size(); ++i) {
      const double angle = (-180.0 + 10.0 * static_cast<double>(i)) * M_PI / 180.0;
      const double cosine = std::cos(angle - bearing);
      beams[i] = {Distance::reading(cosine > 0.0 ? 0.74 / cosine : INFINITY, Lidar::kUsualRange),
                  static_cast<float>(angle)};
    }
    bench.startCheck("lidar");
    checks[0].stages.at(0).end(1.0);
    return bench.failure();
  };
  EXPECT_EQ("", failureWithWallTo(-M_PI / 2.0));
  EXPECT_EQ(0U, failureWithWallTo(M_PI / 2.0)
                    .find("way from beam 7 to the wall: inf m, expected 0.520 m +- 0.280 m; way from beam 8 to "));
  lidar.beams = Span<const LidarBeam>(beams.data() + 18, 18);  // only the beams to the left
  EXPECT_EQ("not true: some beam looks to the right", failureWithWallTo(M_PI / 2.0));
}

TEST(ConformanceChecks, UsualSurroundingsFollowFromTheDevicesThatAreListed) {
  const Configuration none("parameters", "", {});
  TestRobot footbot("footbot", {"footbot_camera", "footbot_proximity"});
  Bench ground(footbot.robot, none);
  EXPECT_EQ(1.0, ground.surroundings().beacon_distance);
  EXPECT_EQ(0.4, ground.surroundings().wall_distance);
  EXPECT_EQ(0.5, ground.settlingTime());
  TestRobot eyebot("eyebot", {"eyebot_camera", "eyebot_velocity", Whistle::kType});
  Configuration parameters("parameters", "", {});
  parameters.set("beacon_distance", "0.7");
  Bench air(eyebot.robot, parameters);
  EXPECT_EQ(0.7, air.surroundings().beacon_distance) << "what a parameter says";
  EXPECT_EQ(0.6, air.surroundings().prey_distance);
  EXPECT_EQ(3.0, air.surroundings().wall_distance) << "what the whistle says";
  EXPECT_EQ(2.0, air.settlingTime());
}

TEST(ConformanceChecks, RestIsCommandedToTheDevicesThatAreListed) {
  const Configuration none("parameters", "", {});
  TestRobot loud("epuck", {Whistle::kType});
  TestRobot quiet("epuck", {});
  rests = 0;
  Bench(quiet.robot, none).rest();
  EXPECT_EQ(0, rests);
  Bench(loud.robot, none).rest();
  EXPECT_EQ(1, rests);
}

TEST(ConformanceChecks, WhatIsShownComesFirstAndEachComesAfterThoseThatItNames) {
  Check shown{"shown", {}, "", {}, {}};
  shown.is_only_shown = true;
  const Check needs{"needs", {}, "", {"other"}, {}};
  Check follows{"follows", {}, "", {}, {}};
  follows.follows = {"needs", "is not done here"};
  const Check other{"other", {}, "", {}, {}};
  EXPECT_EQ((Names{"shown", "other", "needs", "follows"}), namesOf(inOrder({follows, needs, other, shown})));
  Check at_start{"at start", {}, "", {}, {}};
  at_start.is_at_start = true;
  Check trusts{"trusts", {}, "", {}, {}};
  trusts.is_at_start = true;
  trusts.trusts = {"other"};
  EXPECT_EQ((Names{"shown", "at start", "other", "trusts", "needs", "follows"}),
            namesOf(inOrder({follows, needs, trusts, other, at_start, shown})));
  const Check circle{"other", {}, "", {"needs"}, {}};
  EXPECT_THROW(inOrder({needs, circle}), std::logic_error);
}

}  // namespace
}  // namespace swarmanoid::conformance
