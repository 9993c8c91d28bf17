#include "lit_entities.hpp"

#include <algorithm>

namespace swarmanoid::devices {
namespace {

/// Up to this number, checking all of them is faster than searching the surroundings of a robot.
constexpr std::size_t kFew = 32;

bool isLit(const Space& space, Row row, const LightReach& reach) {
  const EntityModel& model = *space.entities.model[row];
  if (reachOfLight(model, reach) <= 0.0) {
    return false;
  }
  if (!model.is_robot) {
    // preys have a surface colour, but do not shine
    return model.findProperty(kIntensity) >= 0 && space.ownColor(row).isLit();
  }
  return isAnyLit(space.leds[row]);
}

}  // namespace

void LitEntities::fill(const Space& space, const LightReach& reach) {
  for (Group* group : {&robots_, &lamps_}) {
    group->small.clear();
    group->large.clear();
    group->count = 0;
  }
  const auto group_of = [&](Row row) -> Group& { return space.entities.model[row]->is_robot ? robots_ : lamps_; };
  is_lit_.resize(space.index.placeCount());
  for (std::size_t place = 0; place < is_lit_.size(); ++place) {
    const PositionalIndex::Outline& outline = space.index.at(static_cast<PositionalIndex::Place>(place));
    const bool is_lit = isLit(space, outline.row, reach);
    is_lit_[place] = is_lit ? 1 : 0;
    if (is_lit && group_of(outline.row).count++ < kFew) {
      group_of(outline.row).small.push_back(outline);
    }
  }
  for (const PositionalIndex::LargeOutline& outline : space.index.large()) {
    if (isLit(space, outline.row, reach)) {
      group_of(outline.row).large.push_back(outline);
    }
  }
}

void LitEntities::collectFew(const Group& group, const Eigen::Vector3d& centre, double radius,
                             std::vector<Row>& found) {
  for (const PositionalIndex::Outline& outline : group.small) {
    if (outline.meets(centre, radius)) {
      found.push_back(outline.row);
    }
  }
}

void LitEntities::collectMany(const Space& space, bool robots, const Eigen::Vector3d& centre, double radius,
                              std::vector<Row>& found) const {
  thread_local std::vector<PositionalIndex::Place> near;  // kept between calls so that a steady state allocates nothing
  near.clear();
  space.index.collectPlaces(centre, radius, near);
  for (const PositionalIndex::Place place : near) {
    const Row row = space.index.at(place).row;
    if (is_lit_[place] != 0 && space.entities.model[row]->is_robot == robots) {
      found.push_back(row);
    }
  }
}

void LitEntities::collect(const Space& space, Row self, const Eigen::Vector3d& centre, double radius,
                          const LightReach& reach, std::vector<Row>& found) const {
  found.clear();
  for (const bool robots : {true, false}) {
    const Group& group = robots ? robots_ : lamps_;
    const double distance = radius + (robots ? reach.of_leds : reach.of_lamps);
    if (group.count <= kFew) {
      collectFew(group, centre, distance, found);
    } else {
      collectMany(space, robots, centre, distance, found);
    }
    for (const PositionalIndex::LargeOutline& outline : group.large) {
      if (outline.meets(centre, distance)) {
        found.push_back(outline.row);
      }
    }
  }
  found.erase(std::remove(found.begin(), found.end(), self), found.end());
  const auto& number = space.entities.number;
  std::sort(found.begin(), found.end(), [&](Row a, Row b) { return number[a] < number[b]; });
}

}  // namespace swarmanoid::devices
