#include "device_topics.hpp"

#include "swarmanoid_interface/ros/device_messages.hpp"
#include "swarmanoid_space/ros/world_state.hpp"

namespace swarmanoid {

DeviceTopics::DeviceTopics(const std::string& robot, const ros::NodeHandle& robot_handle) : handle_(robot_handle) {
  id_ = robot;
}

template <class Device, class Message>
void DeviceTopics::addSensor(const Space& space, Row row, const std::string& topic, const std::string& link) {
  if (space.readings.find<Device>(row) == nullptr) {
    return;
  }
  constexpr std::uint32_t kQueue = 10;
  const std::string frame = frameOf(id_, link);
  topics_.push_back({handle_.advertise<Message>(topic, kQueue),
                     [frame](const ros::Publisher& publisher, const Space& seen, Row reader) {
                       if (publisher.getNumSubscribers() == 0) {
                         return;
                       }
                       if (const auto* readings = seen.readings.find<Device>(reader)) {
                         Message message;
                         toMessage(*readings, message);
                         message.header.stamp = stampOf(seen);
                         message.header.frame_id = frame;
                         publisher.publish(message);
                       }
                     }});
}

void DeviceTopics::addLeds(const Space& space, Row row) {
  const std::size_t count = space.entities.model[static_cast<std::size_t>(row)]->led_positions.size();
  if (count == 0) {
    return;
  }
  constexpr bool kLatched = true;
  // latched, so it is sent at every change, whoever listens
  topics_.push_back({handle_.advertise<swarmanoid_msgs::LedArray>("leds/state", 1, kLatched),
                     [this, count, shown = std::vector<Color>()](const ros::Publisher& publisher, const Space& seen,
                                                                 Row owner) mutable {
                       const Span<const Color> ring(seen.ledsOf(owner), count);
                       if (std::vector<Color>(ring.begin(), ring.end()) == shown) {
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

void DeviceTopics::addAll(const Space& space, Row row) {
  addSensor<FootbotProximity, swarmanoid_msgs::ProximityArray>(space, row, "proximity", "base_link");
  addSensor<FootbotCamera, swarmanoid_msgs::ColorBlobs>(space, row, "camera/blobs", "base_link");
  addSensor<EyebotCamera, swarmanoid_msgs::ColorBlobs>(space, row, "camera/blobs", "base_link");
  addSensor<FootbotGripperState, swarmanoid_msgs::GripperState>(space, row, "gripper/state", "gripper_tip");
  addSensor<HandbotArmsState, sensor_msgs::JointState>(space, row, "joint_states", "base_link");
  addSensor<HandbotHandsState, swarmanoid_msgs::HandsState>(space, row, "hands/state", "base_link");
  addSensor<HandbotRopeState, swarmanoid_msgs::RopeState>(space, row, "rope/state", "rope_launcher");
  addSensor<EyebotMagnetState, swarmanoid_msgs::GripperState>(space, row, "magnet/state", "magnet");
  addSensor<FootbotTurretState, sensor_msgs::JointState>(space, row, "turret/state", "base_link");
  addLeds(space, row);
}

void DeviceTopics::draw(const Space& space) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Row row = space.entities.find(id_);
  if (is_closed_ || row == kNoRow) {
    return;  // the robot may be deleted, and come back
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
  topics_.clear();
  handle_.shutdown();
}

}  // namespace swarmanoid
