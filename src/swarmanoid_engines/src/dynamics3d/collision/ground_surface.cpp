#include "dynamics3d/collision/ground_surface.hpp"

#include <algorithm>

namespace swarmanoid::dynamics3d {

double GroundSurface::foot() const {
  constexpr double kDeep = 1.0;  // m: depth of cliffs without a level ground
  return level_.value_or(terrain_->bounds().min().z() - kDeep);
}

double GroundSurface::highestAt(const Eigen::AlignedBox3d& box) const {
  const double highest = terrain_->highestIn(cellsIn(box));
  return level_ ? std::max(highest, *level_) : highest;
}

std::optional<GroundSurface::Column> GroundSurface::columnAt(const Eigen::Vector3d& point) const {
  if (terrain_->contains(point.x(), point.y())) {
    return Column{terrain_->heightAt(point.x(), point.y()), terrain_->triangleAt(point.x(), point.y()).normal};
  }
  return level_ ? std::optional<Column>(Column{*level_, Eigen::Vector3d::UnitZ()}) : std::nullopt;
}

}  // namespace swarmanoid::dynamics3d
