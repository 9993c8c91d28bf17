#include "swarmanoid_hosts/ros/device_topic.hpp"

#include <algorithm>
#include <deque>

namespace swarmanoid {
namespace {

std::deque<DeviceTopic>& topics() {
  static std::deque<DeviceTopic> topics;  // addresses stay valid
  return topics;
}

}  // namespace

void registerDeviceTopic(DeviceTopic topic) {
  const bool is_known = std::any_of(topics().begin(), topics().end(), [&](const DeviceTopic& known) {
    return known.device == topic.device && known.name == topic.name;
  });
  if (!is_known) {
    topics().push_back(std::move(topic));
  }
}

std::vector<const DeviceTopic*> deviceTopics() {
  std::vector<const DeviceTopic*> result;
  for (const DeviceTopic& topic : topics()) {
    result.push_back(&topic);
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const DeviceTopic* a, const DeviceTopic* b) { return a->device < b->device; });
  return result;
}

std::vector<const DeviceTopic*> topicsOf(const std::string& device) {
  std::vector<const DeviceTopic*> result;
  for (const DeviceTopic& topic : topics()) {
    if (topic.device == device) {
      result.push_back(&topic);
    }
  }
  return result;
}

const DeviceTopic* mainTopicOf(const std::string& device) {
  const std::vector<const DeviceTopic*> all = topicsOf(device);
  return all.empty() ? nullptr : all.front();
}

}  // namespace swarmanoid
