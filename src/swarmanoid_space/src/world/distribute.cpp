#include "distribute.hpp"

#include <algorithm>
#include <cmath>

#include "entities.hpp"
#include "swarmanoid_space/models/entity_type.hpp"

namespace swarmanoid {

void distribute(World& world, const EntityDescription& group, const std::vector<Membership>& memberships) {
  const Distribution& distribution = *group.distribution;
  const auto type = makePlugin<EntityType>(*Registry::instance().find(PluginKind::kEntity, group.type));
  const auto model = type->makeModel(group.parameters);
  RandomStream random(world.space.seed, "distribute", group.id);
  const Eigen::Vector3d extent = distribution.maximum - distribution.minimum;
  const auto quantity = static_cast<double>(distribution.quantity);
  const double side_by_side = std::ceil(std::sqrt(quantity * extent.x() / std::max(extent.y(), 1e-9)));
  const auto columns = static_cast<std::size_t>(std::clamp(side_by_side, 1.0, quantity));
  const std::size_t rows = (distribution.quantity + columns - 1) / columns;

  EntityDescription entity = group;
  entity.distribution.reset();
  for (std::size_t k = 0; k < distribution.quantity; ++k) {
    entity.id = group.id + "_" + std::to_string(k + 1);
    random.startTick(k);
    int trials = 0;
    for (bool placed = false; !placed; ++trials) {
      if (trials == distribution.max_trials) {
        throw ConfigError(group.location, "no free place found for '" + entity.id + "' of " +
                                              std::to_string(distribution.quantity) + " in " + std::to_string(trials) +
                                              " trials; allow more area or fewer entities");
      }
      const bool is_grid = distribution.layout == Distribution::Layout::kGrid;
      const double u =
          is_grid ? (static_cast<double>(k % columns) + 0.5) / static_cast<double>(columns) : random.uniform();
      const double v =
          is_grid ? (static_cast<double>(k / columns) + 0.5) / static_cast<double>(rows) : random.uniform();
      const double w = is_grid ? 0.0 : random.uniform();
      entity.position = distribution.minimum + extent.cwiseProduct(Eigen::Vector3d(u, v, w));
      if (distribution.random_heading) {
        entity.angles.z() = random.uniform(-M_PI, M_PI);
      }
      const Pose pose{entity.position, orientationFromAngles(entity.angles)};
      placed = is_grid || std::none_of(memberships.begin(), memberships.end(), [&](const Membership& membership) {
                 return membership.engine->overlap(*model, pose, kNoRow) != kNoRow;
               });
    }
    addEntity(world, entity, memberships);
  }
}

}  // namespace swarmanoid
