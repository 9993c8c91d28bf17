#include "swarmanoid_hosts/ros/device_topic.hpp"

#include <algorithm>
#include <deque>
#include <mutex>

#include "swarmanoid_hosts/ros/device_fields.hpp"

namespace swarmanoid {
namespace {

std::deque<DeviceTopic>& topics() {
  static std::deque<DeviceTopic> topics;  // addresses stay valid
  return topics;
}

/// Makes the topic of a device that has registered none.
DeviceTopic makeTopicOfFields(const DeviceType& type) {
  using Message = swarmanoid_msgs::DeviceFields;
  const bool is_sensor = type.kind == DeviceKind::kSensor;
  DeviceTopic topic =
      is_sensor
          ? detail::makeTopicOfMessage<Message>(type.type, DeviceTopic::Kind::kReading, type.type, "base_link")
          : detail::makeTopicOfMessage<Message>(type.type, DeviceTopic::Kind::kCommand, type.type + "/command", "");
  topic.publish = [](const ros::Publisher& publisher, const DeviceTopic& entry, const void* device,
                     const std_msgs::Header& header) {
    Message message;
    toMessage(*findDeviceType(entry.device), device, message);
    message.header = header;
    publisher.publish(message);
  };
  topic.subscribe = [](ros::NodeHandle& robot, const DeviceTopic& entry, void* device, VariableParts& parts,
                       DeviceTopic::Receiver receive) {
    return detail::subscribe<Message>(
        robot, entry,
        [type = findDeviceType(entry.device), device, &parts](const Message& message) {
          fromMessage(message, *type, device, parts);
        },
        std::move(receive));
  };
  return topic;
}

/// Returns the topic of a device that has registered none. @return null if there is no such device
const DeviceTopic* topicOfFields(const std::string& device) {
  static std::mutex mutex;
  static std::deque<DeviceTopic> made;  // addresses stay valid
  const DeviceType* type = findDeviceType(device);
  if (type == nullptr) {
    return nullptr;
  }
  const std::lock_guard<std::mutex> lock(mutex);
  const auto known = std::find_if(made.begin(), made.end(), [&](const DeviceTopic& t) { return t.device == device; });
  return known != made.end() ? &*known : &made.emplace_back(makeTopicOfFields(*type));
}

}  // namespace

ros::Time madeAt(const DeviceTopic& topic, const void* readings, const ros::Time& now) {
  if (topic.age == nullptr) {
    return now;
  }
  const double age = topic.age(readings);
  return age > 0.0 ? now - ros::Duration(std::min(age, now.toSec())) : now;
}

void registerDeviceTopic(DeviceTopic topic) {
  const bool is_known = std::any_of(topics().begin(), topics().end(), [&](const DeviceTopic& known) {
    return known.device == topic.device && known.name == topic.name;
  });
  if (!is_known) {
    topics().push_back(std::move(topic));
  }
}

std::vector<const DeviceTopic*> topicsOf(const std::string& device) {
  std::vector<const DeviceTopic*> result;
  for (const DeviceTopic& topic : topics()) {
    if (topic.device == device) {
      result.push_back(&topic);
    }
  }
  if (result.empty()) {
    if (const DeviceTopic* topic = topicOfFields(device)) {
      result.push_back(topic);
    }
  }
  return result;
}

const DeviceTopic* mainTopicOf(const std::string& device) {
  const std::vector<const DeviceTopic*> all = topicsOf(device);
  return all.empty() ? nullptr : all.front();
}

std::vector<const DeviceTopic*> deviceTopics() {
  std::vector<const DeviceTopic*> result;
  for (const DeviceType* type : deviceTypes()) {
    const std::vector<const DeviceTopic*> of_device = topicsOf(type->type);
    result.insert(result.end(), of_device.begin(), of_device.end());
  }
  return result;
}

}  // namespace swarmanoid
