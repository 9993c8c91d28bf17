// A charger for eyebots, which hold on to it with their magnets (thesis 1).
#include <array>

#include "swarmanoid_space/models/arena_object.hpp"

namespace swarmanoid {
namespace {

class CeilingPerchType final : public EntityType {
 public:
  static PluginDescription describe() {
    using Type = Parameter::Type;
    PluginDescription description;
    description.label = "ceiling_perch";
    description.summary =
        "A plate under the ceiling that charges attached robots. Its position is that of its lower face.";
    description.parameters = {
        lengthParameter("side", "Of the square plate.", "0.5"),
        lengthParameter("height", "Of the plate.", "0.05"),
        colorParameter("green", "Of its signal, as cameras see it."),
        makeParameter("capacity", Type::kNumber, "J", "2000000", kChargeRange, "Maximum charge."),
        makeParameter("level", Type::kNumber, "", "1", {0.0, 1.0}, "Initial charge, as a part of the maximum."),
        makeParameter("supply", Type::kNumber, "W", "500", kPowerRange, "Initial power that charges the perch.")};
    return description;
  }

  std::shared_ptr<const EntityModel> makeModel(const Configuration& parameters) const override {
    const double capacity = parameters.number("capacity");
    const std::array<double, 5> key{parameters.number("side"), parameters.number("height"), capacity,
                                    parameters.number("level") * capacity, parameters.number("supply")};
    static SharedModels<std::array<double, 5>> models;
    return models.get(key, [&] { return plateModel(key); });
  }

 private:
  static std::shared_ptr<const EntityModel> plateModel(const std::array<double, 5>& key) {
    const auto& [side, height, capacity, charge, supply] = key;
    auto model = std::make_shared<EntityModel>();
    model->type = "ceiling_perch";
    model->title = "CeilingPerch";
    model->is_ferromagnetic = true;
    CollisionShape plate;
    plate.kind = CollisionShape::Kind::kBox;
    plate.half_extent = {side / 2.0, side / 2.0, height / 2.0};
    plate.position = {0.0, 0.0, height / 2.0};
    model->shapes.push_back(plate);
    model->led_positions.emplace_back(0.0, 0.0, 0.0);
    model->measureShapes();
    model->properties.push_back({kCharge, "J", "Charge available for robots.", {0.0, capacity}, charge});
    model->properties.push_back({kSupply, "W", "Power that charges the perch.", kPowerRange, supply});
    return model;
  }
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ENTITY_TYPE(swarmanoid::CeilingPerchType)
