#include "mock_robot.hpp"

#include <cmath>

namespace swarmanoid::mock {

std::unique_ptr<MockRobot> makeMockRobot(const std::string& type, const Configuration& values) {
  const std::vector<std::string> types{"footbot", "eyebot", "handbot"};
  const bool flies = type == "eyebot";
  constexpr double kAltitude = 1.5;  // [m]
  World world = readWorld(values);
  Pose start;
  start.position = values.vector3("start", {0.0, 0.0, flies ? kAltitude : 0.0});
  start.yaw = values.angle("start_yaw", 0.0);
  values.refuseUnread({"walls", "beacons", "ceiling", "hands", "start", "start_yaw"});
  if (type == "footbot") {
    return makeMockFootbot(std::move(world), start);
  }
  if (type == "eyebot") {
    return makeMockEyebot(std::move(world), start);
  }
  if (type == "handbot") {
    return makeMockHandbot(std::move(world), start);
  }
  throw ConfigError(values.location(),
                    "type: found '" + type + "', allowed: " + joinNames(types) + didYouMean(type, types));
}

ColorBlob blobOf(const Beacon& beacon, const Pose& pose) {
  const Eigen::Vector3d seen = pose.toRobot(beacon.at);
  return {beacon.color, static_cast<float>(std::atan2(seen.y(), seen.x())),
          static_cast<float>(std::hypot(seen.x(), seen.y()))};
}

CommandWatchdog::CommandWatchdog(const MockRobot& robot, double timeout)
    : mock_(robot), robot_("mock", "mock", 0), timeout_(timeout), silence_(robot.actuators().size(), kNever) {
  for (const MockRobot::Sensor& sensor : robot.sensors()) {
    robot_.provideSensor(sensor.device, sensor.reading);
  }
}

void CommandWatchdog::advance(double dt) {
  for (std::size_t i = 0; i < silence_.size(); ++i) {
    if (silence_[i] < 0.0) {
      continue;
    }
    silence_[i] += dt;
    if (hasExpired(i)) {
      const MockRobot::Actuator& actuator = mock_.actuators()[i];
      findDeviceType(actuator.device)->stop(actuator.command, {silence_[i] - timeout_, {}, robot_});
    }
  }
}

}  // namespace swarmanoid::mock
