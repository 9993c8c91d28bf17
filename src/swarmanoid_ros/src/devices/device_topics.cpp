#include "device_topics.hpp"

#include <nav_msgs/Odometry.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_recording/messages/world_state.hpp"

namespace swarmanoid {

DeviceTopics::DeviceTopics(const std::string& robot, const ros::NodeHandle& robot_handle,
                           std::shared_ptr<CommandMailbox> commands)
    : handle_(robot_handle), commands_(std::move(commands)) {
  id_ = robot;
}

void DeviceTopics::addReadings(const Space& space, Row row, const DeviceTopic& device) {
  if (space.readings.find(device.device, row) == nullptr) {
    return;
  }
  std_msgs::Header header;
  header.frame_id = frameOf(id_, device.frame);
  topics_.push_back({device.advertise(handle_, device),
                     [header, &device](const ros::Publisher& publisher, const Space& seen, Row reader) mutable {
                       if (publisher.getNumSubscribers() == 0) {
                         return;
                       }
                       const std::optional<ros::Time> sensed = sensedAt(seen, reader);
                       const void* readings = seen.readings.find(device.device, reader);
                       if (!sensed || readings == nullptr) {
                         return;
                       }
                       const ros::Time last = header.stamp;
                       header.stamp = madeAt(device, readings, *sensed);
                       if (header.stamp != last) {  // else already published
                         device.publish(publisher, device, readings, header);
                       }
                     }});
}

void DeviceTopics::addCommands(const Space& space, Row row, const DeviceTopic& device) {
  const DeviceType* type = findDeviceType(device.device);
  if (type == nullptr || space.commands.find(device.device, row) == nullptr) {
    return;
  }
  Commanded& commanded = *commanded_.emplace_back(std::make_unique<Commanded>());
  commanded.device = type->make();
  commanded.subscriber =
      device.subscribe(handle_, device, commanded.device.get(), commanded.parts,
                       [this, &commanded, &device](const std::string& problem) { take(commanded, device, problem); });
}

void DeviceTopics::take(Commanded& commanded, const DeviceTopic& device, const std::string& problem) {
  if (!problem.empty()) {
    constexpr double kInterval = 1.0;  // [s]
    ROS_WARN_THROTTLE(kInterval, "%s/%s: %s", id_.c_str(), device.name.c_str(), problem.c_str());
    return;
  }
  Bytes command;
  ByteWriter out(command);
  findDeviceType(device.device)->write(commanded.device.get(), out);
  const std::string reason = commands_->put(id_, device.device, std::move(command));
  if (!reason.empty() && !commanded.is_refusal_reported) {
    ROS_WARN("%s/%s is refused: %s", id_.c_str(), device.name.c_str(), reason.c_str());
  }
  commanded.is_refusal_reported = !reason.empty();
}

void DeviceTopics::addLeds(const Space& space, Row row) {
  if (space.leds[row].empty()) {
    return;
  }
  constexpr bool kLatched = true;
  // a latched topic is published at every change, even without subscribers
  topics_.push_back(
      {handle_.advertise<swarmanoid_msgs::LedArray>("leds/state", 1, kLatched),
       [this, shown = std::vector<Color>()](const ros::Publisher& publisher, const Space& seen, Row owner) mutable {
         const Span<const Color> ring = seen.leds[owner];
         if (std::equal(ring.begin(), ring.end(), shown.begin(), shown.end())) {
           return;
         }
         shown.assign(ring.begin(), ring.end());
         swarmanoid_msgs::LedArray message;
         toMessage(ring, message);
         message.header.stamp = stampOf(seen);
         message.header.frame_id = frameOf(id_);
         publisher.publish(message);
       }});
}

void DeviceTopics::addGroundTruth() {
  nav_msgs::Odometry reused;
  reused.child_frame_id = frameOf(id_);
  topics_.push_back(
      {handle_.advertise<nav_msgs::Odometry>("ground_truth/odom", 10),
       [message = std::move(reused)](const ros::Publisher& publisher, const Space& seen, Row row) mutable {
         if (publisher.getNumSubscribers() == 0) {
           return;
         }
         const Pose& pose = seen.entities.pose[row];
         const Twist& twist = seen.entities.twist[row];
         const Eigen::Quaterniond to_robot = pose.orientation.conjugate();
         message.header = headerOf(seen);
         message.pose.pose = toMessage(pose);
         message.twist.twist = toMessage(Twist{to_robot * twist.linear, to_robot * twist.angular});
         publisher.publish(message);
       }});
}

void DeviceTopics::addAll(const Space& space, Row row) {
  for (const DeviceTopic* device : deviceTopics()) {
    if (device->kind == DeviceTopic::Kind::kReading) {
      addReadings(space, row, *device);
    } else if (commands_ != nullptr) {
      addCommands(space, row, *device);
    }
  }
  if (commands_ != nullptr) {
    commands_->open(id_);
  }
  addLeds(space, row);
  addGroundTruth();
}

void DeviceTopics::draw(const Space& space) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Row row = space.entities.find(id_);
  if (is_closed_ || row == kNoRow) {
    return;  // the robot may have been deleted, and may be added again
  }
  if (!is_open_) {
    addAll(space, row);
    is_open_ = true;
  }
  for (const Topic& topic : topics_) {
    topic.publish(topic.publisher, space, row);
  }
}

void DeviceTopics::close() {
  const std::lock_guard<std::mutex> lock(mutex_);
  is_closed_ = true;
  if (commands_ != nullptr) {
    commands_->close(id_);
  }
  commanded_.clear();
  topics_.clear();
  handle_.shutdown();
}

}  // namespace swarmanoid
