// A charger for robots.
#include <array>

#include "swarmanoid_space/models/arena_object.hpp"

namespace swarmanoid {
namespace {

class ChargingPerchType final : public EntityType {
 public:
  static PluginDescription describe() {
    using Type = Parameter::Type;
    PluginDescription description;
    description.label = "charging_perch";
    description.summary = "A post that holds charge for robots. Its position is the foot of the post.";
    description.parameters = {
        lengthParameter("radius", "Of the post.", "0.05"),
        lengthParameter("height", "Of the post.", "0.3"),
        colorParameter("green", "Of its signal, as cameras see it."),
        makeParameter("capacity", Type::kNumber, "J", "2000", kChargeRange, "Maximum charge."),
        makeParameter("level", Type::kNumber, "", "1", {0.0, 1.0}, "Initial charge, as a part of the maximum."),
        makeParameter("supply", Type::kNumber, "W", "20", kPowerRange, "Initial power that charges the perch.")};
    return description;
  }

  std::shared_ptr<const EntityModel> makeModel(const Configuration& parameters) const override {
    const double capacity = parameters.number("capacity");
    const double charge = parameters.number("level") * capacity;
    const double radius = parameters.number("radius");
    const double height = parameters.number("height");
    const double supply = parameters.number("supply");
    static SharedModels<std::array<double, 5>> models;
    return models.get({radius, height, capacity, charge, supply}, [&] {
      return perchModel(radius, height, {0.0, capacity}, charge, supply);
    });
  }

 private:
  static std::shared_ptr<const EntityModel> perchModel(double radius, double height, Range charges, double charge,
                                                       double supply) {
    const Eigen::Vector3d middle(0.0, 0.0, height / 2.0);
    auto model = std::make_shared<EntityModel>();
    model->type = "charging_perch";
    model->title = "ChargingPerch";
    CollisionShape post;  // a cylinder
    post.half_extent = {radius, radius, height / 2.0};
    post.position = middle;
    model->shapes.push_back(post);
    model->led_positions.push_back(middle);
    model->measureShapes();
    model->properties.push_back({kCharge, "J", "Charge available for robots.", charges, charge});
    model->properties.push_back({kSupply, "W", "Power that charges the perch.", kPowerRange, supply});
    return model;
  }
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ENTITY_TYPE(swarmanoid::ChargingPerchType)
