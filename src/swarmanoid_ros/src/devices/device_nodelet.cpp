// Provides the devices of one simulated robot as topics.
#include <pluginlib/class_list_macros.hpp>

#include "device_topics.hpp"
#include "swarmanoid_hosts/ros/part_nodelet.hpp"

namespace swarmanoid {

class DeviceNodelet final : public PartNodelet {
 public:
  DeviceNodelet() : PartNodelet(PluginKind::kObserver) {}
  ~DeviceNodelet() override {
    if (topics_ != nullptr) {
      topics_->close();
    }
  }

 private:
  std::shared_ptr<void> makePart(const AttachmentPoint::Request& request) override {
    topics_ = std::make_shared<DeviceTopics>(request.id, getNodeHandle(), request.commands);
    return std::static_pointer_cast<Observer>(topics_);
  }

  std::shared_ptr<DeviceTopics> topics_;
};

}  // namespace swarmanoid

PLUGINLIB_EXPORT_CLASS(swarmanoid::DeviceNodelet, nodelet::Nodelet)
