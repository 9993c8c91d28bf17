#include "entity_columns.hpp"

#include <algorithm>

namespace swarmanoid::trajectories {

void EntityColumns::follow(const Space& space, std::uint64_t row) {
  if (run_ != space.run) {
    run_ = space.run;
    known_.clear();  // entity numbers start again
  }
  late_.clear();
  std::fill(rows_.begin(), rows_.end(), kNoRow);
  for (const Row entity : space.entities.order) {
    Known& known = known_.fit(entity);
    if (known.number != space.entities.number[entity]) {
      meet(space, entity, row, known);
    } else if (known.column == kNone) {
      const Pose& pose = space.entities.pose[entity];
      const bool has_moved = pose.position != known.first_pose.position ||
                             pose.orientation.coeffs() != known.first_pose.orientation.coeffs();
      if (has_moved) {
        known.column = columnOf(space, entity);
        late_.push_back({static_cast<std::size_t>(known.column), known.first_row, known.first_pose});
      }
    }
    if (known.column != kNone) {
      rows_[static_cast<std::size_t>(known.column)] = entity;
    }
  }
}

void EntityColumns::meet(const Space& space, Row row, std::uint64_t recorded, Known& known) {
  known = {space.entities.number[row], kNone, recorded, space.entities.pose[row]};
  const bool is_known = columns_.find({space.entities.name[row], space.entities.model[row]->type}) != columns_.end();
  if (is_known || space.entities.model[row]->is_movable) {
    known.column = columnOf(space, row);
  }
}

int EntityColumns::columnOf(const Space& space, Row row) {
  const EntityModel& model = *space.entities.model[row];
  const std::string& name = space.entities.name[row];
  const auto [place, is_new] = columns_.try_emplace({name, model.type}, static_cast<int>(entities_.size()));
  if (is_new) {
    entities_.push_back({name, model.type, model.is_robot});
    rows_.push_back(kNoRow);
  }
  return place->second;
}

}  // namespace swarmanoid::trajectories
