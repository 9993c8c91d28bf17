// Hardware interface of ros_control for the joints of a robot, over the robot's standard topics.
#include <hardware_interface/joint_command_interface.h>
#include <hardware_interface/joint_state_interface.h>
#include <hardware_interface/robot_hw.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <pluginlib/class_list_macros.hpp>

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"

namespace swarmanoid {

class SwarmanoidHardware final : public hardware_interface::RobotHW {
 public:
  bool init(ros::NodeHandle&, ros::NodeHandle& own) override;
  /// Takes the messages received since the last call.
  void read(const ros::Time&, const ros::Duration& period) override;
  void write(const ros::Time& time, const ros::Duration&) override;

 private:
  struct Joint {
    double position = 0.0;  // [rad]
    double velocity = 0.0;  // [rad/s]
    double effort = 0.0;    // [N m]
    double command = 0.0;
  };
  struct Output {
    const DeviceTopic* topic = nullptr;
    const void* device = nullptr;
    ros::Publisher publisher;
  };

  Joint& addJoint(const std::string& name, bool has_velocity_command);
  template <class Device>
  void listen(Device& device);
  template <class Device>
  void speak(const Device& device);

  ros::CallbackQueue queue_;
  ros::NodeHandle robot_;
  std::deque<Joint> joints_;  // a deque keeps addresses valid: the handles point to its elements
  hardware_interface::JointStateInterface states_;
  hardware_interface::VelocityJointInterface velocities_;
  hardware_interface::PositionJointInterface positions_;

  bool is_footbot_ = false;
  FootbotWheels wheels_;
  FootbotTurret turret_;
  FootbotTurretState turret_state_;
  HandbotArms arms_;
  HandbotArmsState arms_state_;
  VariableParts parts_;
  std::vector<ros::Subscriber> inputs_;
  std::vector<Output> outputs_;
};

bool SwarmanoidHardware::init(ros::NodeHandle&, ros::NodeHandle& own) {
  std::string robot;
  std::string type;
  if (!own.getParam("robot", robot) || !own.getParam("type", type) || (type != "footbot" && type != "handbot")) {
    ROS_ERROR("%s: found robot '%s', type '%s', allowed: a namespace; footbot, handbot", own.getNamespace().c_str(),
              robot.c_str(), type.c_str());
    return false;
  }
  robot_ = ros::NodeHandle(robot);
  robot_.setCallbackQueue(&queue_);
  is_footbot_ = type == "footbot";
  if (is_footbot_) {
    addJoint("left_wheel", true);
    addJoint("right_wheel", true);
    addJoint("turret", false);
    listen(turret_state_);
    speak(wheels_);
    speak(turret_);
    registerInterface(&velocities_);
  } else {
    for (const char* name : HandbotArmsState::kNames) {
      addJoint(name, false);
    }
    listen(arms_state_);
    speak(arms_);
  }
  registerInterface(&states_);
  registerInterface(&positions_);
  return true;
}

SwarmanoidHardware::Joint& SwarmanoidHardware::addJoint(const std::string& name, bool has_velocity_command) {
  Joint& joint = joints_.emplace_back();
  states_.registerHandle({name, &joint.position, &joint.velocity, &joint.effort});
  const hardware_interface::JointHandle handle(states_.getHandle(name), &joint.command);
  if (has_velocity_command) {
    velocities_.registerHandle(handle);
  } else {
    positions_.registerHandle(handle);
  }
  return joint;
}

template <class Device>
void SwarmanoidHardware::listen(Device& device) {
  const DeviceTopic& topic = *mainTopicOf(Device::kType);
  inputs_.push_back(topic.subscribe(robot_, topic, &device, parts_, [&topic](const std::string& problem) {
    if (!problem.empty()) {
      constexpr double kInterval = 1.0;  // [s]
      ROS_WARN_THROTTLE(kInterval, "%s: %s", topic.name.c_str(), problem.c_str());
    }
  }));
}

template <class Device>
void SwarmanoidHardware::speak(const Device& device) {
  const DeviceTopic& topic = *mainTopicOf(Device::kType);
  outputs_.push_back({&topic, &device, topic.advertise(robot_, topic)});
}

void SwarmanoidHardware::read(const ros::Time&, const ros::Duration& period) {
  queue_.callAvailable();
  if (is_footbot_) {
    joints_[0].velocity = wheels_.left;
    joints_[1].velocity = wheels_.right;
    joints_[0].position += wheels_.left * period.toSec();
    joints_[1].position += wheels_.right * period.toSec();
    joints_[2].position = turret_state_.angle;
    joints_[2].velocity = turret_state_.speed;
    joints_[2].effort = turret_state_.torque;
    return;
  }
  for (std::size_t i = 0; i < HandbotArmsState::kJoints; ++i) {
    joints_[i].position = arms_state_.joints[i].angle;
    joints_[i].velocity = arms_state_.joints[i].speed;
    joints_[i].effort = arms_state_.joints[i].effort;
  }
}

void SwarmanoidHardware::write(const ros::Time& time, const ros::Duration&) {
  if (is_footbot_) {
    wheels_.setAngularVelocity(joints_[0].command, joints_[1].command);
    turret_.holdAngle(joints_[2].command);
  } else {
    arms_.left = {joints_[0].command, joints_[1].command, joints_[2].command};
    arms_.right = {joints_[3].command, joints_[4].command, joints_[5].command};
  }
  std_msgs::Header header;
  header.stamp = time;
  for (const Output& output : outputs_) {
    output.topic->publish(output.publisher, *output.topic, output.device, header);
  }
}

}  // namespace swarmanoid

PLUGINLIB_EXPORT_CLASS(swarmanoid::SwarmanoidHardware, hardware_interface::RobotHW)
