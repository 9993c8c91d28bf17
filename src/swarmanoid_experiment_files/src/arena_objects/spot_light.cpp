// A lamp with a light cone.
#include "swarmanoid_space/models/spot_light.hpp"

#include <array>

#include "swarmanoid_space/models/arena_object.hpp"

namespace swarmanoid {
namespace {

class SpotLightType final : public EntityType {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "spot_light";
    description.summary = "A lamp that shines into a cone around its x axis; it has no body.";
    description.parameters = {colorParameter("white", "Of its light."), intensityParameter(),
                              makeParameter(kAperture, Parameter::Type::kNumber, "deg", "60", kApertureRange,
                                            "Of its cone at first, from side to side.")};
    return description;
  }

  std::shared_ptr<const EntityModel> makeModel(const Configuration& parameters) const override {
    const double aperture = parameters.number(kAperture);
    const double intensity = parameters.number(kIntensity);
    static SharedModels<std::array<double, 2>> models;
    return models.get({aperture, intensity}, [&] { return spotLightModel(aperture, intensity); });
  }
};

}  // namespace

std::shared_ptr<const EntityModel> spotLightModel(double aperture, double intensity) {
  auto model = std::make_shared<EntityModel>(*lightModel(intensity));
  model->type = "spot_light";
  model->title = "SpotLight";
  model->properties.push_back(
      {kAperture, "deg", "Of the cone into which it shines, from side to side.", kApertureRange, aperture});
  return model;
}

}  // namespace swarmanoid

REGISTER_ENTITY_TYPE(swarmanoid::SpotLightType)
