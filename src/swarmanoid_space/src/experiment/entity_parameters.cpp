#include "swarmanoid_space/experiment/entity_parameters.hpp"

#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid::experiment {

std::vector<Parameter> poseParameters() {
  using Type = Parameter::Type;
  return {makeParameter("position", Type::kVector3, "m", std::nullopt, limits::kCoordinate, "Of the entity's origin."),
          makeParameter("orientation", Type::kAngles3, "deg", std::nullopt, limits::kTurn,
                        "Turns about the space's x, then y, then z axis.")};
}

std::vector<Parameter> placementParameters(bool is_distributed) {
  std::vector<Parameter> table = poseParameters();
  table.back().value = "0, 0, 0";
  if (is_distributed) {
    table.erase(table.begin());
  }
  return table;
}

std::vector<Parameter> entityParameters(const PluginDescription& type, bool is_distributed) {
  std::vector<Parameter> table = type.parameters;
  const std::vector<Parameter> placement = placementParameters(is_distributed);
  table.insert(table.end(), placement.begin(), placement.end());
  return table;
}

}  // namespace swarmanoid::experiment
