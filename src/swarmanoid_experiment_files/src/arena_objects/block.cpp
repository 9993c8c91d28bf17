// Walls, obstacles, tables.
#include <array>

#include "swarmanoid_space/models/arena_object.hpp"

namespace swarmanoid {
namespace {

class BlockType final : public EntityType {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "block";
    description.summary = "A brick: a wall, an obstacle, a table. Its position is its centre.";
    description.parameters = {
        makeParameter("size", Parameter::Type::kVector3, "m", std::nullopt, limits::kLength,
                      "Lengths along the brick's own x, y, z."),
        massParameter("0", 0.0, "Of the brick, at least 0.001; 0: it is fixed to the ground."),
        makeParameter("ferromagnetic", Parameter::Type::kBoolean, "", "false", {}, "Whether magnets hold on it.")};
    return description;
  }

  std::shared_ptr<const EntityModel> makeModel(const Configuration& parameters) const override {
    const Eigen::Vector3d size = parameters.vector3("size");
    if (!(size.minCoeff() > 0.0)) {
      throw ConfigError(parameters.find("size")->location(),
                        "size: found '" + parameters.text("size") + "', allowed: three numbers greater than 0");
    }
    const double mass = parameters.number("mass", 0.0);
    if (mass != 0.0 && !limits::kMass.contains(mass)) {
      throw ConfigError(
          parameters.find("mass")->location(),
          "mass: found '" + parameters.text("mass") + "', allowed: 0, or a number " + limits::kMass.toString());
    }
    const bool is_ferromagnetic = parameters.boolean("ferromagnetic", false);
    static SharedModels<std::array<double, 5>> models;
    return models.get({size.x(), size.y(), size.z(), mass, is_ferromagnetic ? 1.0 : 0.0},
                      [&] { return blockModel(size, mass, is_ferromagnetic); });
  }
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ENTITY_TYPE(swarmanoid::BlockType)
