#include "selection.hpp"

#include <ros/node_handle.h>

namespace swarmanoid {

Selection::Selection(std::function<void()> on_change) : on_change_(std::move(on_change)) {
  ros::NodeHandle own("~");
  publisher_ = own.advertise<std_msgs::String>("selected_entity", 1, true);
  subscriber_ = own.subscribe("selected_entity", 10, &Selection::take, this);
}

void Selection::choose(const std::string& name) {
  std_msgs::String message;
  message.data = name;
  publisher_.publish(message);  // comes back to all, this one included
}

void Selection::take(const std_msgs::String& message) {
  if (message.data != name_) {
    name_ = message.data;
    on_change_();
  }
}

}  // namespace swarmanoid
