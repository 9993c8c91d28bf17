// A lamp on a pole. Its intensity is a property: light sensors read it, rules and services change it.
#include <array>

#include "swarmanoid_space/models/arena_object.hpp"

using swarmanoid::Configuration;
using swarmanoid::EntityModel;
using swarmanoid::Parameter;

class LanternType final : public swarmanoid::EntityType {
 public:
  static swarmanoid::PluginDescription describe() {
    swarmanoid::PluginDescription description;
    description.label = "lantern";
    description.summary = "A lamp on a pole. Its position is the foot of the pole.";
    description.parameters = {
        swarmanoid::lengthParameter("height", "Of the pole; the lamp is just above it.", "0.3"),
        swarmanoid::colorParameter("white", "Of its light."),
        swarmanoid::makeParameter(swarmanoid::kIntensity, Parameter::Type::kNumber, "", "1",
                                  swarmanoid::kIntensityRange,
                                  "Of its light at first, in the brightness of an LED of its colour.")};
    return description;
  }

  std::shared_ptr<const EntityModel> makeModel(const Configuration& parameters) const override {
    const double height = parameters.number("height", 0.3);
    const double intensity = parameters.number(swarmanoid::kIntensity, 1.0);
    static swarmanoid::SharedModels<std::array<double, 2>> models;
    return models.get({height, intensity}, [&] {
      auto model = std::make_shared<EntityModel>();
      model->type = "lantern";
      model->title = "Lantern";
      swarmanoid::CollisionShape pole;  // a cylinder
      pole.half_extent = {kRadius, kRadius, 0.5 * height};
      pole.position.z() = 0.5 * height;
      model->shapes.push_back(pole);
      model->measureShapes();
      model->led_positions.emplace_back(0.0, 0.0, height + kRadius);  // position at which cameras see its colour
      model->properties.push_back({swarmanoid::kIntensity, "", "Times the brightness of an LED of its colour.",
                                   swarmanoid::kIntensityRange, intensity});
      return model;
    });
  }

 private:
  static constexpr double kRadius = 0.02;  // of the pole [m]
};

REGISTER_ENTITY_TYPE(LanternType)
