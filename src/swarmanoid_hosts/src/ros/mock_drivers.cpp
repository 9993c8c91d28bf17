// mock_drivers: drivers of one simulated robot with simple kinematics, with the topics of docs/reference/drivers.md.
//
// Private parameters: `robot`, its name; `type`, footbot, eyebot or handbot; `rate` of the sensors [Hz], 1 to 1000;
// `watchdog`, how long commands may be missing before an actuator is stopped safely [s], 0.01 to 3600; `without`,
// devices that are left out, separated by spaces; `world`, its surroundings (../mock/world.hpp).
#include <nav_msgs/Odometry.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <sstream>

#include "../mock/mock_robot.hpp"
#include "swarmanoid_hosts/period_clock.hpp"
#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_hosts/ros/parameters.hpp"
#include "swarmanoid_hosts/ros/topics/leds.hpp"
#include "swarmanoid_interface/process/exit_code.hpp"

namespace swarmanoid::mock {
namespace {

/// @throws ConfigError
double readNumber(const ros::NodeHandle& own, const std::string& name, double usual, Range range) {
  const double value = own.param(name, usual);
  if (!range.contains(value)) {
    throw ConfigError({own.getNamespace() + "/" + name, 0},
                      "found " + numberText(value) + ", allowed: " + range.toString());
  }
  return value;
}

class Drivers {
 public:
  explicit Drivers(const ros::NodeHandle& own)
      : name_(own.param("robot", std::string("robot"))),
        robot_handle_(name_),
        rate_(readNumber(own, "rate", 50.0, {1.0, 1000.0})),
        robot_(makeMockRobot(own.param("type", std::string("footbot")), readWorldOf(own))),
        watchdog_(*robot_, readNumber(own, "watchdog", 0.5, {0.01, 3600.0})) {
    std::istringstream words(own.param("without", std::string()));
    const std::vector<std::string> without{std::istream_iterator<std::string>(words), {}};
    const auto has = [&](const std::string& device) {
      return std::find(without.begin(), without.end(), device) == without.end();
    };
    for (const MockRobot::Sensor& sensor : robot_->sensors()) {
      for (const DeviceTopic* topic : topicsOf(sensor.device)) {
        if (has(sensor.device)) {
          sensors_.push_back({topic, topic->advertise(robot_handle_, *topic), sensor.reading});
        }
      }
    }
    for (std::size_t i = 0; i < robot_->actuators().size(); ++i) {
      if (has(robot_->actuators()[i].device)) {
        subscribeCommands(i);
      }
    }
    constexpr std::uint32_t kQueue = 10;
    odometry_ = robot_handle_.advertise<nav_msgs::Odometry>("odom", kQueue);
  }

  /// Runs until the node ends.
  void run() {
    const auto now = [] { return ros::SteadyTime::now().toNSec(); };
    const Duration period(std::llround(1e9 / rate_));
    PeriodClock clock(Duration(now()), period);
    while (ros::ok()) {
      const Duration left = clock.next() - Duration(now());
      if (left > Duration::zero()) {
        ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(toSeconds(left)));
        continue;
      }
      const double dt = toSeconds(static_cast<Duration::rep>(clock.begin(Duration(now()))) * period);
      watchdog_.advance(dt);
      robot_->advance(dt);
      publish();
    }
  }

 private:
  struct Output {
    const DeviceTopic* topic;
    ros::Publisher publisher;
    const void* reading;
  };

  static Configuration readWorldOf(const ros::NodeHandle& own) {
    XmlRpc::XmlRpcValue values;
    const std::string path = own.getNamespace() + "/world";
    return own.getParam("world", values) ? configurationFrom(values, "world", path)
                                         : Configuration("world", "", {path, 0});
  }

  void subscribeCommands(std::size_t index) {
    const MockRobot::Actuator& actuator = robot_->actuators()[index];
    for (const DeviceTopic* topic : topicsOf(actuator.device)) {
      commands_.push_back(topic->subscribe(robot_handle_, *topic, actuator.command, parts_.emplace_back(),
                                           [this, index, topic](const std::string& why) {
                                             if (why.empty()) {
                                               watchdog_.commanded(index);
                                             } else {
                                               ROS_ERROR_THROTTLE(1.0, "%s: a command on %s is refused: %s",
                                                                  name_.c_str(), topic->name.c_str(), why.c_str());
                                             }
                                           }));
    }
    if (actuator.device == FootbotLeds::kType || actuator.device == EyebotLeds::kType) {
      constexpr bool kLatched = true;
      leds_state_ = robot_handle_.advertise<swarmanoid_msgs::LedArray>("leds/state", 1, kLatched);
    }
  }

  void publish() {
    std_msgs::Header header;
    header.stamp = ros::Time::now();
    for (const Output& output : sensors_) {
      header.frame_id = name_ + "/" + output.topic->frame;
      output.topic->publish(output.publisher, output.reading, header);
    }
    header.frame_id = name_ + "/base_link";
    publishLeds(header);
    publishOdometry(header.stamp);
  }

  /// Publishes the LEDs at each change.
  void publishLeds(const std_msgs::Header& header) {
    for (const MockRobot::Actuator& actuator : robot_->actuators()) {
      swarmanoid_msgs::LedArray message;
      if (actuator.device == FootbotLeds::kType) {
        toMessage(*static_cast<const FootbotLeds*>(actuator.command), message);
      } else if (actuator.device == EyebotLeds::kType) {
        toMessage(*static_cast<const EyebotLeds*>(actuator.command), message);
      } else {
        continue;
      }
      if (leds_state_ && message.colors != shown_) {
        shown_ = message.colors;
        message.header = header;
        leds_state_.publish(message);
      }
    }
  }

  void publishOdometry(ros::Time stamp) {
    nav_msgs::Odometry message;
    message.header.stamp = stamp;
    message.header.frame_id = name_ + "/odom";
    message.child_frame_id = name_ + "/base_link";
    const Pose& pose = robot_->pose();
    message.pose.pose.position.x = pose.position.x();
    message.pose.pose.position.y = pose.position.y();
    message.pose.pose.position.z = pose.position.z();
    message.pose.pose.orientation.z = std::sin(0.5 * pose.yaw);
    message.pose.pose.orientation.w = std::cos(0.5 * pose.yaw);
    message.twist.twist.linear.x = robot_->twist().linear.x();
    message.twist.twist.linear.y = robot_->twist().linear.y();
    message.twist.twist.linear.z = robot_->twist().linear.z();
    message.twist.twist.angular.z = robot_->twist().yaw_rate;
    odometry_.publish(message);
  }

  std::string name_;
  ros::NodeHandle robot_handle_;
  double rate_;  // [Hz]
  std::unique_ptr<MockRobot> robot_;
  CommandWatchdog watchdog_;
  std::vector<Output> sensors_;
  std::deque<VariableParts> parts_;  // addresses stay valid
  std::vector<ros::Subscriber> commands_;
  ros::Publisher leds_state_;
  std::vector<std_msgs::ColorRGBA> shown_;
  ros::Publisher odometry_;
};

}  // namespace
}  // namespace swarmanoid::mock

int main(int argc, char** argv) {
  ros::init(argc, argv, "mock_drivers");
  const ros::NodeHandle own("~");  // outlives the drivers: without any handle a node loses its log as well
  try {
    swarmanoid::mock::Drivers(own).run();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return toNumber(swarmanoid::ExitCode::kBadInput);
  }
  return toNumber(swarmanoid::ExitCode::kFinished);
}
