/// The devices of one robot as topics in its namespace, under the names and types that a real robot would use:
/// proximity, camera/blobs, gripper/state, turret/state, leds/state. Views: nothing here moves a robot.
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "swarmanoid_interface/ros/device_topic.hpp"
#include "swarmanoid_space/visualisation.hpp"

namespace swarmanoid {

class DeviceTopics final : public Visualisation {
 public:
  /// @param robot_handle whose namespace is the robot's
  DeviceTopics(const std::string& robot, const ros::NodeHandle& robot_handle);

  void configure(const std::string&, const Configuration&, const RunContext&) override {}
  void draw(const Space& space) override;

  /// Publishes no more; the space may keep looking at it until the run is over.
  void close();

 private:
  struct Topic {
    ros::Publisher publisher;
    std::function<void(const ros::Publisher&, const Space&, Row)> publish;
  };

  void addReadings(const Space& space, Row row, const DeviceTopic& device);
  void addLeds(const Space& space, Row row);
  void addAll(const Space& space, Row row);

  std::mutex mutex_;
  ros::NodeHandle handle_;
  std::vector<Topic> topics_;
  bool is_open_ = false;
  bool is_closed_ = false;
};

}  // namespace swarmanoid
