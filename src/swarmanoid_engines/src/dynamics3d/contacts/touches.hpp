/// Narrow phase: the touches of a step.
///
/// The order of touches depends on entity numbers and solids only, never on memory addresses. Solids closer than
/// kMargin touch before they meet: their contact limits the approach speed to the gap per step.
#pragma once

#include <utility>
#include <vector>

#include "dynamics3d/body.hpp"
#include "dynamics3d/bounds.hpp"
#include "dynamics3d/collision/ground_surface.hpp"

namespace swarmanoid::dynamics3d {

/// A contact point of two solids. The first solid is that of a driven body, otherwise that of a dynamic body.
struct Touch {
  Body* a = nullptr;  ///< dynamic
  const Solid* solid_a = nullptr;
  Body* b = nullptr;  ///< null: the ground
  const Solid* solid_b = nullptr;
  dContactGeom geometry = {};  ///< in W; the depth includes kMargin, the normal points out of b
};

/// Touches of a body for which memory is allocated; crowds have fewer.
constexpr std::size_t kMostTouchesOfABody = 24;

class Touches {
 public:
  /// @param ground rough ground; elsewhere the ground is that of `settings` @pre an OdeLock is held
  void configure(const Settings& settings, const GroundSurface& ground);
  /// Destroys all ODE objects. @pre an OdeLock is held
  void release();

  void add(Body& body) { near_.add(&body, boundsNow(body)); }
  /// Also drops all touches of the last step.
  void remove(Body& body) {
    near_.remove(&body);
    touches_.clear();
  }

  /// Broad phase of the next step. @param bodies number of bodies in the world @return bodies left out of ODE
  /// (steady_motion.hpp) with a neighbour; the caller must take them in and update their bounds (boundsNow); valid
  /// until the next call
  const std::vector<Body*>& findPairs(std::size_t bodies);
  /// Returns the current bounding box of a body in W, and updates those of its solids.
  static Eigen::AlignedBox3d boundsNow(Body& body);

  /// Finds the touches of all pairs and of the ground. @param bodies by rank @pre findPairs was called in this step
  void find(const std::vector<Body*>& bodies);
  /// Returns the touches of the last step.
  const std::vector<Touch>& all() const { return touches_; }

  /// Returns the current depth of a solid in other bodies [m]; 0: no overlap. Bodies joined by grips are skipped.
  /// Neighbours are those of the last step. @pre an OdeLock is held
  double depthAmongBodies(const Body& body, const Solid& solid) const;

 private:
  void collideGround(Body& body);
  void collideRoughGround(Body& body, const Solid& solid);
  void collidePair(Body& a, Body& b);
  void collideSolids(Body& a, const Solid& solid_a, Body* b, const Solid& solid_b);

  double level_ = 0.0;  // of the level ground [m]
  Solid level_ground_;
  GroundSurface ground_;
  SortedBounds<Body*> near_;
  std::vector<std::pair<int, int>> pairs_;  // ranks
  std::vector<Body*> reached_;              // scratch of findPairs
  std::vector<Touch> touches_;
};

}  // namespace swarmanoid::dynamics3d
