// An object for robots to grip and carry.
#include <array>

#include "swarmanoid_space/models/arena_object.hpp"

namespace swarmanoid {
namespace {

class CylindricPreyType final : public EntityType {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "cylindric_prey";
    description.summary = "A target object with a gripping strip. Its position is the middle of its lower face.";
    description.parameters = {
        lengthParameter("radius", "Of the cylinder."), lengthParameter("height", "Of the cylinder."),
        massParameter("0.3", limits::kMass.minimum, "Of the prey."), colorParameter("white", "As cameras see it.")};
    return description;
  }

  std::shared_ptr<const EntityModel> makeModel(const Configuration& parameters) const override {
    const double radius = parameters.number("radius");
    const double height = parameters.number("height");
    const double mass = parameters.number("mass", kPreyMass);
    static SharedModels<std::array<double, 3>> models;
    return models.get({radius, height, mass}, [&] { return cylindricPreyModel(radius, height, mass); });
  }
};

}  // namespace
}  // namespace swarmanoid

REGISTER_ENTITY_TYPE(swarmanoid::CylindricPreyType)
