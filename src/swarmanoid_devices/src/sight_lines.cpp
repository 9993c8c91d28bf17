#include "sight_lines.hpp"

#include <algorithm>
#include <cmath>

namespace swarmanoid::devices {
namespace {

/// How far prisms reach out of the upright cylinder around a solid, as a factor: to the corners of the square around
/// it.
constexpr double kPrismReach = M_SQRT2;

/// So that no rounding makes a line pass by what a ray along it touches, or touch what it passes by [m].
constexpr double kMargin = 1e-9;

/// What single precision rounds at most of a distance, as a fraction of how far all that is looked at reaches: some
/// roundings of 6e-8 each.
constexpr double kSingleRounding = 1e-6;

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
  const bool has_prisms = std::any_of(space.engines.begin(), space.engines.end(),
                                      [](const Engine* engine) { return engine->hitsPrisms(); });
  prism_reach_ = has_prisms ? kPrismReach : 1.0;
  if (outlines_.size() < near.size()) {
    outlines_.resize(near.size(), nullptr);
    for (std::vector<float>* column : {&x_, &y_, &radius_, &excess_}) {
      column->resize(near.size());
    }
  }
  const double margin = kMargin + kSingleRounding * reach;
  count_ = 0;
  for (const Place place : near) {
    const PositionalIndex::Outline& outline = space.index.at(place);
    outlines_[count_] = &outline;
    x_[count_] = static_cast<float>(outline.position.x() - eye.x());
    y_[count_] = static_cast<float>(outline.position.y() - eye.y());
    radius_[count_] = static_cast<float>((1.0 + kSingleRounding) * prism_reach_ * outline.radius + margin);
    count_ += outline.row == self ? 0 : 1;
  }
  large_.clear();
  for (const PositionalIndex::LargeOutline& large : space.index.large()) {
    if (large.row != self && large.meets(eye, reach)) {
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
  const Eigen::Vector2f ahead = way.head<2>().cast<float>();
  const auto scale = static_cast<float>(length);
  const float half = 0.5F * scale * scale;
  for (std::size_t k = 0; k < count_; ++k) {
    const float across = std::abs(x_[k] * ahead.y() - y_[k] * ahead.x());
    const float beyond = std::abs(x_[k] * ahead.x() + y_[k] * ahead.y() - half) - half;
    excess_[k] = (across > beyond ? across : beyond) - radius_[k] * scale;
  }
  for (std::size_t k = 0; k < count_; ++k) {
    if (excess_[k] <= 0.0F && isBlocked(*outlines_[k], line, owner)) {
      return true;
    }
  }
  const Eigen::AlignedBox3d box(eye_.cwiseMin(point), eye_.cwiseMax(point));
  const bool is_large_near = std::any_of(large_.begin(), large_.end(), [&](const PositionalIndex::LargeOutline* large) {
    return large->row != owner && large->bounds.squaredExteriorDistance(box) <= kMargin * kMargin;
  });
  return is_large_near && space_->isOccluded(line, self_, owner);
}

bool SightLines::isBlocked(const PositionalIndex::Outline& outline, const Segment& line, Row owner) const {
  if (outline.row == owner || !meetHeights(line, outline.low, outline.high)) {
    return false;
  }
  if (outline.is_upright) {
    const Verdict verdict = judge(outline, line);
    if (verdict != Verdict::kUnsure) {
      return verdict == Verdict::kBlocked;
    }
  }
  const Engine* engine = space_->mover[outline.row];
  return engine == nullptr ? space_->isOccluded(line, self_, owner)
                           : engine->blocks(outline.row, bundleOf(line, self_, owner));
}

/// @param outline of something upright @param line that has a direction seen from above
SightLines::Verdict SightLines::judge(const PositionalIndex::Outline& outline, const Segment& line) const {
  const EntityModel& model = *space_->entities.model[outline.row];
  const double height = outline.low - model.lowest;  // of the body's origin
  const Eigen::Vector2d way = (line.to - line.from).head<2>();
  const Eigen::Vector2d axis = outline.position - line.from.head<2>();
  const double fraction = axis.dot(way) / way.squaredNorm();  // of the way, where it is nearest to the axis
  const bool is_between = fraction > 0.0 && fraction < 1.0;
  const double distance = (axis - std::clamp(fraction, 0.0, 1.0) * way).norm();
  Verdict verdict = Verdict::kFree;
  for (const EntityModel::Silhouette& silhouette : model.silhouettes) {
    const double low = height + silhouette.low;
    const double high = height + silhouette.high;
    if (distance > prism_reach_ * silhouette.radius + kMargin || !meetHeights(line, low, high)) {
      continue;
    }
    const bool is_inside =
        std::min(line.from.z(), line.to.z()) > low + kMargin && std::max(line.from.z(), line.to.z()) < high - kMargin;
    if (silhouette.is_whole && is_between && is_inside && distance < silhouette.radius - kMargin &&
        axis.norm() > silhouette.radius + kMargin) {
      return Verdict::kBlocked;
    }
    verdict = Verdict::kUnsure;
  }
  return verdict;
}

}  // namespace swarmanoid::devices
