/// Provides the devices of one robot as topics in its namespace, with the names and types of a real robot's topics:
/// proximity, camera/blobs, gripper/state, leds/state; wheels/command, cmd_vel, leds/command. Commands move the robot
/// if its command source is `topics`; otherwise they are refused, and the log reports it once.
/// ground_truth/odom is its true pose in the world, with its velocity in its own frame (nav_msgs/Odometry), for users
/// and tests; no controller reads it.
/// Each reading is published once, with the stamp of the state that was sensed (sensedAt in world_state.hpp).
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/command_mailbox.hpp"
#include "swarmanoid_space/observer.hpp"

namespace swarmanoid {

class DeviceTopics final : public Observer {
 public:
  /// @param robot_handle handle in the robot's namespace
  /// @param commands mailbox for commands; null: no command topics
  DeviceTopics(const std::string& robot, const ros::NodeHandle& robot_handle, std::shared_ptr<CommandMailbox> commands);

  void configure(const std::string&, const Configuration&, const RunContext&) override {}
  void draw(const Space& space) override;

  /// Ends publishing; the space may keep calling this observer until the run is over.
  void close();

 private:
  struct Topic {
    ros::Publisher publisher;
    std::function<void(const ros::Publisher&, const Space&, Row)> publish;
  };

  /// The last command on the topic of an actuator.
  struct Commanded {
    std::shared_ptr<void> device;
    VariableParts parts;
    bool is_refusal_reported = false;
    ros::Subscriber subscriber;  // last member, so that it is destroyed first
  };

  void addReadings(const Space& space, Row row, const DeviceTopic& device);
  void addLeds(const Space& space, Row row);
  void addGroundTruth();
  void addCommands(const Space& space, Row row, const DeviceTopic& device);
  void take(Commanded& commanded, const DeviceTopic& device, const std::string& problem);
  void addAll(const Space& space, Row row);

  std::mutex mutex_;
  ros::NodeHandle handle_;
  std::vector<Topic> topics_;
  std::shared_ptr<CommandMailbox> commands_;
  std::vector<std::unique_ptr<Commanded>> commanded_;
  bool is_open_ = false;
  bool is_closed_ = false;
};

}  // namespace swarmanoid
