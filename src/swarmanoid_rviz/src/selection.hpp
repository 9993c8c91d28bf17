/// The selected entity, shared by panel and tool over a latched topic of rviz's node, ~selected_entity. Other nodes may
/// subscribe to it or select another entity.
///
/// Threads  Qt's GUI thread only, in which rviz serves ROS callbacks.
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
  /// @param on_change called after another entity was selected
  explicit Selection(std::function<void()> on_change);

  /// "" if none is selected
  const std::string& name() const { return name_; }
  void choose(const std::string& name);

 private:
  void take(const std_msgs::String& message);

  std::function<void()> on_change_;
  std::string name_;
  std::shared_ptr<ros::Publisher> publisher_;  // shared by panel and tool, so that late subscribers get the last name
  ros::Subscriber subscriber_;
};

}  // namespace swarmanoid
