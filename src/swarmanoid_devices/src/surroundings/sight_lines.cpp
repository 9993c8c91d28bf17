#include "sight_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "swarmanoid_space/index/positional_index_visits.hpp"

namespace swarmanoid::devices {
namespace {

/// Factor by which prisms exceed the upright cylinder around a solid: they reach the corners of its bounding square.
constexpr double kPrismReach = M_SQRT2;

/// Margin against rounding: no line may miss a solid that its ray touches, or touch one that the ray misses [m].
constexpr double kMargin = 1e-9;

/// Bound of the rounding error of distances in single precision, as a fraction of the reach: several errors of 6e-8
/// each.
constexpr double kSingleRounding = 1e-6;

/// Radius of unused entries of a batch: no line touches them [m].
constexpr float kPassedByAll = -1.0F;

constexpr std::array<std::uint32_t, 32> makeBits() {
  std::array<std::uint32_t, 32> bits{};
  for (std::size_t k = 0; k < bits.size(); ++k) {
    bits[k] = std::uint32_t{1} << k;
  }
  return bits;
}
constexpr std::array<std::uint32_t, 32> kBits = makeBits();

RayBundle bundleOf(const Segment& line, Row self, Row owner) {
  RayBundle ray;
  ray.segments = Span<const Segment>(&line, 1);
  ray.centre = 0.5 * (line.from + line.to);
  ray.radius = 0.5 * (line.to - line.from).norm();
  ray.ignored = self;
  ray.also_ignored = owner;
  return ray;
}

constexpr double squareOf(double number) { return number * number; }

/// Whether the height ranges of a line and of an entity overlap.
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
  fillBatches(near, kMargin + kSingleRounding * reach);
  large_.clear();
  space.index.visitLarge(eye, reach, [&](const PositionalIndex::LargeOutline& large) {
    if (large.row != self) {
      large_.push_back(&large);
    }
    return true;
  });
}

void SightLines::fillBatches(const std::vector<Place>& near, double margin) {
  if (batches_.size() * Batch::kSize < near.size()) {
    batches_.resize((near.size() + Batch::kSize - 1) / Batch::kSize);
  }
  const double widening = (1.0 + kSingleRounding) * prism_reach_;
  count_ = 0;
  for (const Place place : near) {
    const PositionalIndex::Outline& outline = space_->index.at(place);
    Batch& batch = batches_[count_ / Batch::kSize];
    const std::size_t k = count_ % Batch::kSize;
    batch.outlines[k] = &outline;
    batch.x[k] = static_cast<float>(outline.position.x() - eye_.x());
    batch.y[k] = static_cast<float>(outline.position.y() - eye_.y());
    batch.radius[k] = static_cast<float>(widening * outline.radius + margin);
    count_ += outline.row == self_ ? 0 : 1;
  }
  for (std::size_t b = 0; b * Batch::kSize < count_; ++b) {
    Batch& batch = batches_[b];
    const std::size_t in_use = std::min(count_ - b * Batch::kSize, Batch::kSize);
    batch.lanes = (in_use + Batch::kLanes - 1) / Batch::kLanes * Batch::kLanes;
    std::fill(batch.radius.data() + in_use, batch.radius.data() + batch.lanes, kPassedByAll);
  }
}

std::uint32_t SightLines::Batch::meeting(const Eigen::Vector2f& way, float length) const {
  // distances across the line and beyond its ends, all multiplied by its length
  const float ahead_x = way.x();
  const float ahead_y = way.y();
  const float half = 0.5F * length * length;
  std::uint32_t met = 0;
  for (std::size_t k = 0; k < lanes / kLanes * kLanes; ++k) {  // shows compilers that no lane is left over
    const float across = std::abs(x[k] * ahead_y - y[k] * ahead_x);
    const float beyond = std::abs(x[k] * ahead_x + y[k] * ahead_y - half) - half;
    const float excess = (across > beyond ? across : beyond) - radius[k] * length;
    met |= kBits[k] & (0U - static_cast<std::uint32_t>(excess <= 0.0F));
  }
  return met;
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
  for (std::size_t b = 0; b * Batch::kSize < count_; ++b) {
    const Batch& batch = batches_[b];
    std::uint32_t met = batch.meeting(way.head<2>().cast<float>(), static_cast<float>(length));
    for (; met != 0; met &= met - 1) {
      if (isBlocked(*batch.outlines[static_cast<std::size_t>(__builtin_ctz(met))], line, owner)) {
        return true;
      }
    }
  }
  return !large_.empty() && isBlockedByLarge(line, owner);
}

bool SightLines::isBlockedByLarge(const Segment& line, Row owner) const {
  const Eigen::AlignedBox3d box(line.from.cwiseMin(line.to), line.from.cwiseMax(line.to));
  const bool is_one_near = std::any_of(large_.begin(), large_.end(), [&](const PositionalIndex::LargeOutline* large) {
    return large->row != owner && large->bounds.squaredExteriorDistance(box) <= kMargin * kMargin;
  });
  return is_one_near && space_->isOccluded(line, self_, owner);
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

/// @param outline of an upright entity @param line not vertical
SightLines::Verdict SightLines::judge(const PositionalIndex::Outline& outline, const Segment& line) const {
  const EntityModel& model = *space_->entities.model[outline.row];
  const double height = outline.low - model.lowest;  // of the body's origin
  const Eigen::Vector2d way = (line.to - line.from).head<2>();
  const Eigen::Vector2d axis = outline.position - line.from.head<2>();
  const double fraction = axis.dot(way) / way.squaredNorm();  // of the way, at its closest point to the axis
  const bool is_between = fraction > 0.0 && fraction < 1.0;
  const double squared_distance = (axis - std::clamp(fraction, 0.0, 1.0) * way).squaredNorm();
  Verdict verdict = Verdict::kFree;
  for (const EntityModel::Silhouette& silhouette : model.silhouettes) {
    const double low = height + silhouette.low;
    const double high = height + silhouette.high;
    if (squared_distance > squareOf(prism_reach_ * silhouette.radius + kMargin) || !meetHeights(line, low, high)) {
      continue;
    }
    const bool is_inside =
        std::min(line.from.z(), line.to.z()) > low + kMargin && std::max(line.from.z(), line.to.z()) < high - kMargin;
    const double inner_radius = std::max(0.0, silhouette.radius - kMargin);
    if (silhouette.is_whole && is_between && is_inside && squared_distance < squareOf(inner_radius) &&
        axis.squaredNorm() > squareOf(silhouette.radius + kMargin)) {
      return Verdict::kBlocked;
    }
    verdict = Verdict::kUnsure;
  }
  return verdict;
}

}  // namespace swarmanoid::devices
