// One engine of an experiment as a nodelet. It hosts engines of any label, from this package or another.
#include <pluginlib/class_list_macros.hpp>
#include <stdexcept>

#include "swarmanoid_interface/ros/part_nodelet.hpp"
#include "swarmanoid_space/engine.hpp"

namespace swarmanoid {

class EngineNodelet final : public PartNodelet {
 public:
  EngineNodelet() : PartNodelet(PluginKind::kEngine) {}

 private:
  std::shared_ptr<void> makePart(const AttachmentPoint::Request& request) override {
    const auto* entry = Registry::instance().find(PluginKind::kEngine, request.label);
    if (entry == nullptr) {
      const std::vector<std::string> known = Registry::instance().labels(PluginKind::kEngine);
      throw std::runtime_error("engine '" + request.label + "' is not registered; there are: " + joinNames(known) +
                               didYouMean(request.label, known));
    }
    auto engine = makePlugin<Engine>(*entry);
    engine->configure(request.id, request.parameters);
    return engine;
  }
};

}  // namespace swarmanoid

PLUGINLIB_EXPORT_CLASS(swarmanoid::EngineNodelet, nodelet::Nodelet)
