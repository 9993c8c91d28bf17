/// The base class of targets of rays: the entities of an engine.
///
/// Phase    any except during `move`.
/// Threads  all functions are called from many threads.
#pragma once

#include "swarmanoid_interface/span.hpp"
#include "swarmanoid_space/rays/obstacles.hpp"
#include "swarmanoid_space/rays/ray.hpp"

namespace swarmanoid {

class RayTarget {
 public:
  virtual ~RayTarget() = default;

  /// Whether a ray of the bundle could hit anything in this engine; in doubt, true. Does not read the segments, so a
  /// caller may make them after this check.
  virtual bool mayHit(const RayBundle& rays) const = 0;
  /// Finds the solids that the bundle could hit in this engine, also without reading the segments. The default reports
  /// obstacles anywhere if mayHit is true.
  virtual void findObstacles(const RayBundle& rays, Obstacles& found) const;
  /// Replaces the hit of each segment that hits an entity of this engine nearer than its entry in `hits`.
  virtual void raycast(const RayBundle& rays, Span<RayHit> hits) const = 0;
  /// The same for one segment and one solid that findObstacles has found. @pre no entity has moved since
  virtual void castRayAt(const Obstacles::Solid& solid, const Segment& segment, RayHit& hit) const;
  /// Whether a ray hits that entity. The default casts the ray against all entities of the engine, and returns whether
  /// it hits any of them. For callers that know the possible obstacles: a check of one entity costs a fraction of a
  /// search for neighbours. @param ray of one segment @pre this engine moves the entity
  virtual bool blocks(Row row, const RayBundle& ray) const;
  /// Whether rays hit prisms. A prism may protrude from the upright cylinder around its solid, up to the corners of the
  /// square around that cylinder; nothing that rays hit may protrude farther. Rays of an engine with solids hit an
  /// upright cylinder of a model at its actual place. Lines of sight rely on both.
  virtual bool hitsPrisms() const { return false; }
};

}  // namespace swarmanoid
