// A station that swaps the batteries of robots (thesis 1, figure 1.1 d).
#include <array>

#include "swarmanoid_space/models/arena_object.hpp"

namespace swarmanoid {
namespace {

class ExchangeStationType final : public EntityType {
 public:
  static PluginDescription describe() {
    using Type = Parameter::Type;
    PluginDescription description;
    description.label = "exchange_station";
    description.summary = "A box with charged batteries for robots. Its position is the middle of its base.";
    description.parameters = {
        lengthParameter("side", "Of its square base.", "0.2"),
        lengthParameter("height", "Of the box.", "0.15"),
        colorParameter("magenta", "Of its signal, as cameras see it."),
        makeParameter("batteries", Type::kInteger, "", "4", {1.0, 16.0}, "How many there are."),
        makeParameter("capacity", Type::kNumber, "J", "133200", kCapacityRange, "Maximum charge of each."),
        makeParameter("level", Type::kNumber, "", "1", {0.0, 1.0}, "Initial charge of each, as a part of the maximum."),
        makeParameter("supply", Type::kNumber, "W", "40", kPowerRange, "Initial power that charges batteries.")};
    return description;
  }

  std::shared_ptr<const EntityModel> makeModel(const Configuration& parameters) const override {
    const std::array<double, 6> key{parameters.number("side"),
                                    parameters.number("height"),
                                    static_cast<double>(parameters.integer("batteries")),
                                    parameters.number("capacity"),
                                    parameters.number("level"),
                                    parameters.number("supply")};
    static SharedModels<std::array<double, 6>> models;
    return models.get(key, [&] { return stationModel(key); });
  }

 private:
  static std::shared_ptr<const EntityModel> stationModel(const std::array<double, 6>& key) {
    const auto& [side, height, count, capacity, level, supply] = key;
    auto model = std::make_shared<EntityModel>();
    model->type = "exchange_station";
    model->title = "ExchangeStation";
    CollisionShape box;
    box.kind = CollisionShape::Kind::kBox;
    box.half_extent = {side / 2.0, side / 2.0, height / 2.0};
    box.position = {0.0, 0.0, height / 2.0};
    model->shapes.push_back(box);
    model->led_positions.emplace_back(0.0, 0.0, height);
    model->measureShapes();
    const Range charges{0.0, capacity};
    for (int i = 1; i <= static_cast<int>(count); ++i) {
      model->properties.push_back(
          {"battery_" + std::to_string(i), "J", "Charge of that battery.", charges, level * capacity});
    }
    model->properties.push_back({"arm", "J", "Charge of the battery that is on its way into a robot.", charges, 0.0});
    model->properties.push_back({kSupply, "W", "Power that charges batteries.", kPowerRange, supply});
    return model;
  }
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ENTITY_TYPE(swarmanoid::ExchangeStationType)
