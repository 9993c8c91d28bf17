/// A fake space that answers with the state that a test sets, for states that are too short in a real one.
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <ros/spinner.h>
#include <std_srvs/Trigger.h>
#include <swarmanoid_msgs/Inspect.h>

#include <atomic>
#include <mutex>

namespace swarmanoid {

class FakeSpace {
 public:
  FakeSpace() : node_("/fake") {
    node_.setCallbackQueue(&queue_);
    inspect_ = node_.advertiseService("inspect", &FakeSpace::inspect, this);
    pause_ = node_.advertiseService("pause", &FakeSpace::pause, this);
    spinner_.start();
  }

  void say(const swarmanoid_msgs::Inspect::Response& state) {
    const std::lock_guard<std::mutex> lock(mutex_);
    state_ = state;
  }
  int pauses() const { return pauses_; }

 private:
  bool inspect(swarmanoid_msgs::Inspect::Request& /*request*/, swarmanoid_msgs::Inspect::Response& response) {
    const std::lock_guard<std::mutex> lock(mutex_);
    response = state_;
    return true;
  }
  bool pause(std_srvs::Trigger::Request& /*request*/, std_srvs::Trigger::Response& response) {
    ++pauses_;
    response.success = 1;
    return true;
  }

  std::mutex mutex_;
  swarmanoid_msgs::Inspect::Response state_;
  std::atomic<int> pauses_{0};
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::ServiceServer inspect_, pause_;
  ros::AsyncSpinner spinner_{1, &queue_};
};

}  // namespace swarmanoid
