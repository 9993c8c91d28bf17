#include "distance_rays.hpp"

#include "way_to_ground.hpp"

namespace swarmanoid::devices {
namespace {

/// Fraction of a segment at which it hits the level floor from above; infinity if it does not, or if there is terrain
/// or a hole instead.
double floorFraction(const Space& space, const Segment& segment) {
  if (segment.from.z() < 0.0 || segment.to.z() > 0.0 || segment.from.z() == segment.to.z()) {
    return kInfinity;
  }
  const double fraction = segment.from.z() / (segment.from.z() - segment.to.z());
  return isOnLevelFloor(space, segment.from + fraction * (segment.to - segment.from)) ? fraction : kInfinity;
}

}  // namespace

Parameter tooCloseParameter() {
  Parameter parameter = makeParameter(
      "too_close", Parameter::Type::kChoice, "", kReported, {},
      "Reading below the minimum range: -inf, or folded back to a larger distance, as triangulating sensors read it.");
  parameter.choices = {kReported, kFolded};
  return parameter;
}

void refuseEmptyRange(const Range& range, const Configuration& parameters) {
  if (range.minimum >= range.maximum) {
    throw ConfigError(parameters.location(), "range_min: found " + numberText(range.minimum) +
                                                 ", allowed: less than range_max, which is " +
                                                 numberText(range.maximum));
  }
}

void castDistances(const Space& space, const RayBundle& rays, Span<RayHit> hits) {
  space.raycast(rays, hits);
  for (std::size_t k = 0; k < hits.size(); ++k) {
    const double fraction = floorFraction(space, rays.segments[k]);
    if (fraction < hits[k].fraction) {
      hits[k] = {fraction, kNoRow};
    }
  }
}

}  // namespace swarmanoid::devices
