/// The entity that panel and tool speak of: a latched topic of rviz's node, ~selected_entity, so that other nodes may
/// follow it or choose another.
///
/// Threads  that of Qt's windows, in which rviz serves ROS callbacks.
#pragma once

#include <ros/publisher.h>
#include <ros/subscriber.h>
#include <std_msgs/String.h>

#include <functional>
#include <memory>
#include <string>

namespace swarmanoid {

class Selection {
 public:
  /// @param on_change called when somebody has chosen another one
  explicit Selection(std::function<void()> on_change);

  /// "" if there is none
  const std::string& name() const { return name_; }
  void choose(const std::string& name);

 private:
  void take(const std_msgs::String& message);

  std::function<void()> on_change_;
  std::string name_;
  std::shared_ptr<ros::Publisher> publisher_;  // one for panel and tool, so that who comes late gets the last name
  ros::Subscriber subscriber_;
};

}  // namespace swarmanoid
