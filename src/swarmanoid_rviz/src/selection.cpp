#include "selection.hpp"

#include <ros/node_handle.h>

namespace swarmanoid {
namespace {

std::shared_ptr<ros::Publisher> publisherOf(ros::NodeHandle& own) {
  static std::weak_ptr<ros::Publisher> shared;
  std::shared_ptr<ros::Publisher> publisher = shared.lock();
  if (!publisher) {
    publisher = std::make_shared<ros::Publisher>(own.advertise<std_msgs::String>("selected_entity", 1, true));
    shared = publisher;
  }
  return publisher;
}

}  // namespace

Selection::Selection(std::function<void()> on_change) : on_change_(std::move(on_change)) {
  ros::NodeHandle own("~");
  publisher_ = publisherOf(own);
  subscriber_ = own.subscribe("selected_entity", 10, &Selection::take, this);
}

void Selection::choose(const std::string& name) {
  std_msgs::String message;
  message.data = name;
  publisher_->publish(message);  // all selections receive it, this one included
}

void Selection::take(const std_msgs::String& message) {
  if (message.data != name_) {
    name_ = message.data;
    on_change_();
  }
}

}  // namespace swarmanoid
