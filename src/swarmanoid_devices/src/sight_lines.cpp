#include "sight_lines.hpp"

#include <algorithm>
#include <cmath>

namespace swarmanoid::devices {
namespace {

/// Engines in a plane cast rays against prisms: the outline of a solid in the plane, as long as the solid is across it.
/// Where the plane stands upright, a prism reaches out of the upright cylinder around the solid, up to the corners of
/// the square around that.
constexpr double kPrismReach = M_SQRT2;

/// So that no rounding makes a line pass by what a ray along it touches [m].
constexpr double kMargin = 1e-9;

RayBundle bundleOf(const Segment& line, Row self, Row owner) {
  RayBundle ray;
  ray.segments = Span<const Segment>(&line, 1);
  ray.centre = 0.5 * (line.from + line.to);
  ray.radius = 0.5 * (line.to - line.from).norm();
  ray.ignored = self;
  ray.also_ignored = owner;
  return ray;
}

/// Whether the heights of a line and of a thing overlap.
bool meetHeights(const Segment& line, double low, double high) {
  return std::min(line.from.z(), line.to.z()) <= high + kMargin &&
         std::max(line.from.z(), line.to.z()) >= low - kMargin;
}

}  // namespace

void SightLines::begin(const Space& space, Row self, const Eigen::Vector3d& eye, double reach,
                       const std::vector<Place>& near) {
  space_ = &space;
  self_ = self;
  eye_ = eye;
  count_ = 0;
  if (outlines_.size() < near.size()) {
    outlines_.resize(near.size(), nullptr);
    for (std::vector<double>* column : {&x_, &y_, &radius_, &excess_}) {
      column->resize(near.size());
    }
  }
  for (const Place place : near) {
    const PositionalIndex::Outline& outline = space.index.at(place);
    outlines_[count_] = &outline;
    x_[count_] = outline.position.x() - eye.x();
    y_[count_] = outline.position.y() - eye.y();
    radius_[count_] = kPrismReach * outline.radius + kMargin;
    count_ += outline.row == self ? 0 : 1;
  }
  large_.clear();
  for (const PositionalIndex::LargeOutline& large : space.index.large()) {
    if (large.row != self && large.bounds.squaredExteriorDistance(eye) <= reach * reach) {
      large_.push_back(&large);
    }
  }
}

void SightLines::begin(const Space& space, Row self, const Eigen::Vector3d& eye, double reach) {
  near_.clear();
  space.index.collectPlaces(eye, reach + space.index.prismMargin(), near_);
  begin(space, self, eye, reach, near_);
}

bool SightLines::isOccluded(const Eigen::Vector3d& point, Row owner) {
  const Segment line{eye_, point};
  const Eigen::Vector3d way = point - eye_;
  const double length = way.head<2>().norm();
  if (space_->terrain || length < kMargin) {
    return space_->isOccluded(line, self_, owner);
  }
  // all is scaled by the length: how far to the side of the line a thing is, and how far before or behind it
  const double half = 0.5 * length * length;
  for (std::size_t k = 0; k < count_; ++k) {
    const double across = std::abs(x_[k] * way.y() - y_[k] * way.x());
    const double beyond = std::abs(x_[k] * way.x() + y_[k] * way.y() - half) - half;
    excess_[k] = (across > beyond ? across : beyond) - radius_[k] * length;
  }
  for (std::size_t k = 0; k < count_; ++k) {
    if (excess_[k] <= 0.0 && isBlocked(k, line, owner)) {
      return true;
    }
  }
  const Eigen::AlignedBox3d box(eye_.cwiseMin(point), eye_.cwiseMax(point));
  const bool is_large_near = std::any_of(large_.begin(), large_.end(), [&](const PositionalIndex::LargeOutline* large) {
    return large->row != owner && large->bounds.squaredExteriorDistance(box) <= kMargin * kMargin;
  });
  return is_large_near && space_->isOccluded(line, self_, owner);
}

bool SightLines::isBlocked(std::size_t obstacle, const Segment& line, Row owner) const {
  const PositionalIndex::Outline& outline = *outlines_[obstacle];
  if (outline.row == owner || !meetHeights(line, outline.low, outline.high)) {
    return false;
  }
  const Engine* engine = space_->mover[outline.row];
  return engine == nullptr ? space_->isOccluded(line, self_, owner)
                           : engine->blocks(outline.row, bundleOf(line, self_, owner));
}

}  // namespace swarmanoid::devices
