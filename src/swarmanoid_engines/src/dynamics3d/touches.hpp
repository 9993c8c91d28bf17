/// Finds where bodies touch in a step.
///
/// Pairs are gone through in the order of entity numbers and solids, so a run does not depend on memory addresses.
/// Surfaces are looked at before they meet (kMargin): they may come together by no more than their gap in a step.
#pragma once

#include <utility>
#include <vector>

#include "dynamics3d/body.hpp"
#include "dynamics3d/bounds.hpp"
#include "dynamics3d/ground_surface.hpp"

namespace swarmanoid::dynamics3d {

/// One point where two solids touch, or nearly do. Which of two comes first: a body that drives, then one that ODE
/// moves.
struct Touch {
  Body* a = nullptr;  ///< ODE moves it
  const Solid* solid_a = nullptr;
  Body* b = nullptr;  ///< null: the ground
  const Solid* solid_b = nullptr;
  dContactGeom geometry = {};  ///< in W; depth is more by kMargin, and the normal leads out of b
};

/// In a crowd, and more.
constexpr std::size_t kMostTouchesOfABody = 24;

class Touches {
 public:
  /// @param ground used where it is rough; elsewhere `settings` says what there is. @pre an OdeLock is held
  void configure(const Settings& settings, const GroundSurface& ground);
  /// Gives everything back to ODE. @pre an OdeLock is held
  void release();

  void add(Body& body) { near_.add(&body, boundsNow(body)); }
  void remove(Body& body) {
    near_.remove(&body);
    touches_.clear();  // some may be its
  }

  /// Finds who is near whom in the step that comes. @param bodies how many there are @return those left out of ODE that
  /// somebody is near: they have to be taken in, and looked at once more (boundsNow); valid until the next call
  const std::vector<Body*>& findPairs(std::size_t bodies);
  /// The box around a body, where it is now. Sees where its solids are.
  static Eigen::AlignedBox3d boundsNow(Body& body);

  /// Finds where those that are near touch, after findPairs. @param bodies by entity number
  void find(const std::vector<Body*>& bodies);
  /// Those of the last step.
  const std::vector<Touch>& all() const { return touches_; }

  /// How deep a body's solid is in those of others that it does not hold and that do not hold it, where it is now [m];
  /// 0: not at all. Who is near, is as of the last step. @pre an OdeLock is held
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
