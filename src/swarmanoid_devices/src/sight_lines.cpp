#include "sight_lines.hpp"

#include <algorithm>
#include <cmath>

namespace swarmanoid::devices {
namespace {

/// Engines in a plane cast rays against prisms: the outline of a solid in the plane, as long as the solid is across it.
/// Neither reaches beyond the sphere that holds the solid, so no corner is farther away than this times its radius.
constexpr double kPrismReach = M_SQRT2;

}  // namespace

void SightLines::begin(const Space& space, Row self, const Eigen::Vector3d& eye, const std::vector<Row>& near) {
  space_ = &space;
  self_ = self;
  eye_ = eye;
  count_ = 0;
  if (rows_.size() < near.size()) {
    rows_.resize(near.size(), kNoRow);
    for (std::vector<double>* column : {&x_, &y_, &z_, &outside_, &excess_}) {
      column->resize(near.size());
    }
  }
  for (const Row row : near) {
    const EntityModel& model = *space.entities.model[row];
    if (row == self || model.shapes.empty()) {
      continue;
    }
    const Eigen::Vector3d centre = space.entities.pose[row].position - eye;
    const double radius = kPrismReach * model.bounding_radius;
    rows_[count_] = row;
    x_[count_] = centre.x();
    y_[count_] = centre.y();
    z_[count_] = centre.z();
    outside_[count_] = centre.squaredNorm() - radius * radius;
    ++count_;
  }
}

bool SightLines::isOccluded(const Eigen::Vector3d& point, Row owner) {
  if (space_->terrain) {
    return space_->isOccluded({eye_, point}, self_, owner);
  }
  // a sphere around c meets the straight line along w if (c^2 - r^2) w^2 <= (c w)^2
  const Eigen::Vector3d way = point - eye_;
  const double squared_length = way.squaredNorm();
  for (std::size_t k = 0; k < count_; ++k) {
    const double along = x_[k] * way.x() + y_[k] * way.y() + z_[k] * way.z();
    excess_[k] = outside_[k] * squared_length - along * along;
  }
  for (std::size_t k = 0; k < count_; ++k) {
    if (excess_[k] <= 0.0 && rows_[k] != owner && isHitNear(k, way, owner)) {
      return true;
    }
  }
  return false;
}

bool SightLines::isHitNear(std::size_t obstacle, const Eigen::Vector3d& way, Row owner) const {
  const double squared_length = way.squaredNorm();
  if (squared_length == 0.0) {
    return false;
  }
  const double along = x_[obstacle] * way.x() + y_[obstacle] * way.y() + z_[obstacle] * way.z();
  const double half = std::sqrt(std::max(0.0, -excess_[obstacle]));
  // the part of the way that is within the sphere, as fractions of the way
  const double from = std::max(0.0, (along - half) / squared_length);
  const double to = std::min(1.0, (along + half) / squared_length);
  if (from >= to) {
    return false;
  }
  // the end is the point itself and nothing beside it: what begins there is not between
  const Eigen::Vector3d end = to < 1.0 ? Eigen::Vector3d(eye_ + to * way) : Eigen::Vector3d(eye_ + way);
  return space_->isOccluded({eye_ + from * way, end}, self_, owner);
}

}  // namespace swarmanoid::devices
