/// Finds who touches whom, and makes ODE's contact joints of it.
///
/// Pairs are gone through in the order of entity numbers and solids, so a run does not depend on memory addresses.
/// Surfaces are looked at before they meet (kMargin): they may come together by no more than their gap in a step.
/// Friction follows Coulomb in the direction in which surfaces slide, or would without friction.
#pragma once

#include <utility>
#include <vector>

#include "dynamics3d/body.hpp"
#include "dynamics3d/bounds.hpp"

namespace swarmanoid::dynamics3d {

class Contacts {
 public:
  /// Where two surfaces touch, or nearly do. @see points
  struct Point {
    Eigen::Vector3d position;
    Eigen::Vector3d normal;
  };

  /// @pre a Turn is held
  void configure(dWorldID world, const Settings& settings);
  /// Other surfaces from now on; the ground stays where it is.
  void reconfigure(const Settings& settings) { settings_ = settings; }
  /// Gives everything back to ODE. @pre a Turn is held
  void release();

  void add(Body& body) { near_.add(&body, boundsNow(body)); }
  void remove(Body& body) { near_.remove(&body); }

  /// Makes the joints of one step. @param bodies by entity number; @param step [s]
  /// @param attempt counts up while the solver fails: ties between contacts are then broken in another way
  void make(const std::vector<Body*>& bodies, double step, int attempt);
  /// Those of the last step.
  const std::vector<Point>& points() const { return points_; }
  /// Forgets them again.
  void clear() { dJointGroupEmpty(joints_); }

 private:
  static Eigen::AlignedBox3d boundsNow(const Body& body);
  void meetGround(Body& body);
  void meetPair(Body& a, Body& b);
  void meetSolids(Body& a, const Solid& solid_a, Body* b, const Solid& solid_b);
  void makeJoint(const Body& a, const Solid& solid_a, const Body* b, dContactGeom geometry);
  void breakTies(dSurfaceParameters& surface);
  void chooseFriction(const Body& a, const Body* b, dContact& contact) const;
  Eigen::Vector3d expectedVelocity(const Body* body, const dReal* point) const;

  Settings settings_;
  dWorldID world_ = nullptr;
  dJointGroupID joints_ = nullptr;
  Solid ground_;
  double step_ = 0.0;
  int joints_made_ = 0;  // in this step
  int attempt_ = 0;
  SortedBounds<Body*> near_;
  std::vector<std::pair<int, int>> pairs_;  // ranks
  std::vector<Point> points_;
};

}  // namespace swarmanoid::dynamics3d
