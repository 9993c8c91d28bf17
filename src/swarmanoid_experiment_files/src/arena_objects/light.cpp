// A lamp.
#include "swarmanoid_space/models/arena_object.hpp"

namespace swarmanoid {
namespace {

class LightType final : public EntityType {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "light";
    description.summary = "A lamp that cameras and light sensors see; it has no body.";
    description.parameters = {colorParameter("white", "Of its light."), intensityParameter()};
    return description;
  }

  std::shared_ptr<const EntityModel> makeModel(const Configuration& parameters) const override {
    const double intensity = parameters.number(kIntensity, 1.0);
    static SharedModels<double> models;
    return models.get(intensity, [&] { return lightModel(intensity); });
  }
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ENTITY_TYPE(swarmanoid::LightType)
