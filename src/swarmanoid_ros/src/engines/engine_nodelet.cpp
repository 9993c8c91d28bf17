// One engine of an experiment as a nodelet. It hosts engines of any label, from this package or another.
#include <pluginlib/class_list_macros.hpp>

#include "swarmanoid_hosts/ros/part_nodelet.hpp"
#include "swarmanoid_space/engine.hpp"

namespace swarmanoid {

class EngineNodelet final : public PartNodelet {
 public:
  EngineNodelet() : PartNodelet(PluginKind::kEngine) {}

 private:
  std::shared_ptr<void> makePart(const AttachmentPoint::Request& request) override {
    auto engine = makePlugin<Engine>(Registry::instance().require(PluginKind::kEngine, request.label));
    engine->configure(request.id, request.parameters);
    return engine;
  }
};

}  // namespace swarmanoid

PLUGINLIB_EXPORT_CLASS(swarmanoid::EngineNodelet, nodelet::Nodelet)
