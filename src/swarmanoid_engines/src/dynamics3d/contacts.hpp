/// Finds which bodies touch, and makes ODE's contact joints of it.
///
/// Pairs are gone through in the order of entity numbers and solids, so a run does not depend on memory addresses.
/// Surfaces are looked at before they meet (kMargin): they may come together by no more than their gap in a step.
/// Friction is that of friction.hpp.
#pragma once

#include <utility>
#include <vector>

#include "dynamics3d/body.hpp"
#include "dynamics3d/bounds.hpp"
#include "dynamics3d/friction.hpp"
#include "dynamics3d/ground_surface.hpp"

namespace swarmanoid::dynamics3d {

class Contacts {
 public:
  /// Where two surfaces touch, or nearly do. @see points
  struct Point {
    Eigen::Vector3d position;
    Eigen::Vector3d normal;
  };

  /// @param ground used where it is rough; elsewhere `settings` says what there is. @pre an OdeLock is held
  void configure(dWorldID world, const Settings& settings, const GroundSurface& ground);
  /// Other surfaces from now on; the ground stays where it is.
  void reconfigure(const Settings& settings) { settings_ = settings; }
  /// Gives everything back to ODE. @pre an OdeLock is held
  void release();

  void add(Body& body) {
    near_.add(&body, boundsNow(body));
    friction_.forget();
  }
  void remove(Body& body) {
    near_.remove(&body);
    friction_.forget();
  }

  /// Finds who is near whom in the step that comes. @param bodies how many there are @return those left out of ODE that
  /// somebody is near: they have to be taken in, and looked at once more (boundsNow); valid until the next call
  const std::vector<Body*>& findPairs(std::size_t bodies);
  /// The box around a body, where it is now. Sees where its solids are.
  static Eigen::AlignedBox3d boundsNow(Body& body);

  /// Makes the joints of one step, after findPairs. @param bodies by entity number; @param step [s]
  /// @param attempt counts up while the solver fails: ties between contacts are then broken in another way
  /// @param is_iterative whether the iterative solver makes the step, which finds loads and friction together
  void make(const std::vector<Body*>& bodies, double step, int attempt, bool is_iterative);
  /// After the step was solved: whether friction is Coulomb's everywhere.
  bool isFrictionCoulombs() { return friction_.isCoulombs(); }
  /// After the last solution of a step: keeps the limits of friction for the next step.
  void rememberFriction() { friction_.remember(); }
  /// Makes the joints once more, now with the friction that was found. @pre the bodies are back in the state of the
  /// last make
  void makeAgain(const std::vector<Body*>& bodies);
  /// How deep a body's solid is in those of others that it does not hold and that do not hold it, where it is now [m];
  /// 0: not at all. Who is near, is as of the last step. @pre an OdeLock is held
  double depthAmongBodies(const Body& body, const Solid& solid) const;
  /// Those of the last step.
  const std::vector<Point>& points() const { return points_; }
  /// Where joints belong that are to last for one step.
  dJointGroupID joints() const { return joints_; }
  /// Forgets them again.
  void clear() { dJointGroupEmpty(joints_); }

 private:
  void collideGround(Body& body);
  void collideRoughGround(Body& body, const Solid& solid);
  void collideAll(const std::vector<Body*>& bodies);
  void collidePair(Body& a, Body& b);
  void collideSolids(Body& a, const Solid& solid_a, Body* b, const Solid& solid_b);
  void makeJoint(const Body& a, const Solid& solid_a, const Body* b, const Solid& solid_b, dContactGeom geometry);
  void breakTies(dSurfaceParameters& surface);

  Settings settings_;
  dWorldID world_ = nullptr;
  dJointGroupID joints_ = nullptr;
  Solid level_ground_;
  GroundSurface ground_;
  Friction friction_;
  double step_ = 0.0;
  int joints_made_ = 0;  // in this step
  int attempt_ = 0;
  SortedBounds<Body*> near_;
  std::vector<std::pair<int, int>> pairs_;  // ranks
  std::vector<Body*> reached_;              // scratch of findPairs
  std::vector<Point> points_;
};

}  // namespace swarmanoid::dynamics3d
