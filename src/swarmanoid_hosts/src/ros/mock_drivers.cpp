// mock_drivers: drivers of one simulated robot with simple kinematics, with the topics of docs/reference/drivers.md.
//
// Private parameters: `robot`, its name; `type`, such as footbot: it has all devices of such a robot; `devices`,
// further devices, separated by spaces; `without`, devices that are left out, separated by spaces; `rate` of the
// sensors [Hz], 1 to 1000; `watchdog`, the time without commands after which an actuator is stopped safely [s], 0.01 to
// 3600; `world`, its surroundings (../mock/world.hpp).
#include <nav_msgs/Odometry.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "../mock/mock_robot.hpp"
#include "swarmanoid_hosts/period_clock.hpp"
#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_hosts/ros/parameter_reader.hpp"
#include "swarmanoid_hosts/ros/parameters.hpp"
#include "swarmanoid_hosts/ros/tf_frames.hpp"
#include "swarmanoid_interface/process/exit_code.hpp"

namespace swarmanoid::mock {
namespace {

struct Options {
  std::string robot;
  std::vector<std::string> devices;
  Configuration world;
  double rate;      // [Hz]
  double watchdog;  // [s]
};

/// @throws ConfigError
std::vector<std::string> readDevices(ParameterReader& reader) {
  const std::string type = reader.text("type", "");
  std::vector<std::string> devices = devicesOf(type, reader.optionalWords("devices"), reader.location());
  for (const std::string& left_out : reader.optionalWords("without")) {
    if (std::find(devices.begin(), devices.end(), left_out) == devices.end()) {
      throw ConfigError({reader.location().file + "/without", 0},
                        "found '" + left_out + "', allowed: " + joinNames(devices) + didYouMean(left_out, devices));
    }
    devices.erase(std::remove(devices.begin(), devices.end(), left_out), devices.end());
  }
  return devices;
}

Configuration readWorldOf(const ros::NodeHandle& own) {
  XmlRpc::XmlRpcValue values;
  const std::string path = own.getNamespace() + "/world";
  return own.getParam("world", values) ? configurationFrom(values, "world", path)
                                       : Configuration("world", "", {path, 0});
}

/// @throws ConfigError
Options readOptions(const ros::NodeHandle& own) {
  ParameterReader reader(own);
  Options options{reader.text("robot", "robot"), readDevices(reader), readWorldOf(own),
                  reader.number("rate", 50.0, {1.0, 1000.0}), reader.number("watchdog", 0.5, {0.01, 3600.0})};
  reader.refuseUnread({"world"});
  return options;
}

/// Returns the topic that shows people the state of a commanded device: leds/state for leds/command.
DeviceTopic stateTopicOf(const DeviceTopic& command) {
  DeviceTopic state = command;
  const std::size_t end = command.name.rfind("/command");
  state.name = (end == std::string::npos ? command.name : command.name.substr(0, end)) + "/state";
  return state;
}

class Drivers {
 public:
  explicit Drivers(const Options& options)
      : name_(options.robot),
        robot_handle_(name_),
        rate_(options.rate),
        robot_(makeMockRobot(options.devices, options.world)),
        watchdog_(*robot_, options.watchdog) {
    for (std::size_t i = 0; i < robot_->devices().size(); ++i) {
      if (robot_->devices()[i].type->kind == DeviceKind::kSensor) {
        advertiseReadings(robot_->devices()[i]);
      } else {
        subscribeCommands(i);
      }
    }
    constexpr std::uint32_t kQueue = 10;
    truth_ = robot_handle_.advertise<nav_msgs::Odometry>("ground_truth/odom", kQueue);
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
  /// A command that people can see, such as the colours of LEDs.
  struct Shown {
    const MockRobot::Device* device;
    DeviceTopic topic;
    ros::Publisher publisher;
    Bytes last;  ///< last published command
  };

  void advertiseReadings(const MockRobot::Device& sensor) {
    for (const DeviceTopic* topic : topicsOf(sensor.type->type)) {
      sensors_.push_back({topic, topic->advertise(robot_handle_, *topic), sensor.value.get()});
    }
  }

  void subscribeCommands(std::size_t index) {
    const MockRobot::Device& actuator = robot_->devices()[index];
    for (const DeviceTopic* topic : topicsOf(actuator.type->type)) {
      commands_.push_back(topic->subscribe(robot_handle_, *topic, actuator.value.get(), parts_.emplace_back(),
                                           [this, index, topic](const std::string& why) {
                                             if (why.empty()) {
                                               watchdog_.commanded(index);
                                             } else {
                                               ROS_ERROR_THROTTLE(1.0, "%s: a command on %s is refused: %s",
                                                                  name_.c_str(), topic->name.c_str(), why.c_str());
                                             }
                                           }));
    }
    const DeviceTopic* command = mainTopicOf(actuator.type->type);
    if (command != nullptr && actuator.mock && actuator.mock->isShown()) {
      const DeviceTopic state = stateTopicOf(*command);
      shown_.push_back({&actuator, state, state.advertiseLatched(robot_handle_, state), {}});
    }
  }

  void publish() {
    std_msgs::Header header;
    header.stamp = ros::Time::now();
    for (const Output& output : sensors_) {
      header.frame_id = frameOf(name_, output.topic->frame);
      output.topic->publish(output.publisher, *output.topic, output.reading, header);
    }
    header.frame_id = frameOf(name_);
    for (Shown& shown : shown_) {
      publishIfChanged(shown, header);
    }
    publishTruth(header.stamp);
  }

  static void publishIfChanged(Shown& shown, const std_msgs::Header& header) {
    Bytes state;
    ByteWriter out(state);
    shown.device->type->write(shown.device->value.get(), out);
    if (state != shown.last) {
      shown.last = state;
      shown.topic.publish(shown.publisher, shown.topic, shown.device->value.get(), header);
    }
  }

  void publishTruth(ros::Time stamp) {
    nav_msgs::Odometry message;
    message.header.stamp = stamp;
    message.header.frame_id = "world";
    message.child_frame_id = name_ + "/base_link";
    const Pose& pose = robot_->state().pose;
    message.pose.pose.position.x = pose.position.x();
    message.pose.pose.position.y = pose.position.y();
    message.pose.pose.position.z = pose.position.z();
    message.pose.pose.orientation.z = std::sin(0.5 * pose.yaw);
    message.pose.pose.orientation.w = std::cos(0.5 * pose.yaw);
    message.twist.twist.linear.x = robot_->state().twist.linear.x();
    message.twist.twist.linear.y = robot_->state().twist.linear.y();
    message.twist.twist.linear.z = robot_->state().twist.linear.z();
    message.twist.twist.angular.z = robot_->state().twist.yaw_rate;
    truth_.publish(message);
  }

  std::string name_;
  ros::NodeHandle robot_handle_;
  double rate_;  // [Hz]
  std::unique_ptr<MockRobot> robot_;
  CommandWatchdog watchdog_;
  std::vector<Output> sensors_;
  std::deque<VariableParts> parts_;  // addresses stay valid
  std::vector<ros::Subscriber> commands_;
  std::vector<Shown> shown_;
  ros::Publisher truth_;  // the true pose of the robot, for people and tests
};

}  // namespace
}  // namespace swarmanoid::mock

int main(int argc, char** argv) {
  ros::init(argc, argv, "mock_drivers");
  const ros::NodeHandle own("~");  // outlives the drivers: without any handle a node loses its log as well
  try {
    swarmanoid::mock::Drivers(swarmanoid::mock::readOptions(own)).run();
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return toNumber(swarmanoid::ExitCode::kBadInput);
  }
  return toNumber(swarmanoid::ExitCode::kFinished);
}
