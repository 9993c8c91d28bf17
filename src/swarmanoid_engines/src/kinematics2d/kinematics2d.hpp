/// The two-dimensional kinematic engine (thesis 3.5.1): bodies in a plane go where their velocities take them.
///
/// There are no masses and no forces. Bodies move one after another, in the order of their entity numbers, so results
/// do not depend on anything else; one that would overlap another tries its turn alone, and otherwise stays at its last
/// free pose. Nothing overlaps after a tick. A mirror (an entity that another engine moves) may come to overlap a body
/// through no doing of this engine; such a pair hinders a body only from going deeper.
///
/// Wheels are integrated exactly along the arc. What would lead out of the plane is dropped: an eyebot flies the part
/// of its velocity that lies in the plane. A footbot can grip a prey, not another footbot; a prey is gripped by one
/// footbot at a time, and keeps its place in the gripper to the last digits.
///
/// Rays meet bodies as prisms over their planar shapes. A mirror of what another engine moves is not met: that engine
/// answers for it.
#pragma once

#include <vector>

#include "kinematics2d/bodies.hpp"
#include "planar/planar_ray.hpp"
#include "swarmanoid_space/engine.hpp"

namespace swarmanoid::kinematics2d {

class Kinematics2d final : public Engine {
 public:
  static PluginDescription describe();

  void configure(const std::string& id, const Configuration& parameters) override;
  std::string refusal(const EntityModel& model, const std::vector<std::string>& devices) const override;
  std::string misplacement(const EntityModel& model, const Pose& pose) const override;
  using Engine::overlap;
  Row overlap(const EntityModel& model, const Pose& pose, Span<const Row> ignored) const override;
  void add(Space& space, Row row, Role role) override;
  void remove(Space& space, Row row) override;
  void place(Space& space, Row row) override;
  void clear() override {
    bodies_.clear();
    is_somebody_new_ = true;
  }
  void readMirrors(const Space& space) override;
  void move(Space& space, Duration dt) override;
  void connect(Space& space) override;
  bool mayMeet(const RayBundle& rays) const override;
  void castRays(const RayBundle& rays, Span<RayHit> hits) const override;

 private:
  // motion.cpp
  void startTick(const Space& space, double step);
  void readCommands(Body& body);
  void moveBody(BodyIndex index, double dt);
  bool tryPose(BodyIndex index, const PlacedPose& pose);
  bool isFree(BodyIndex index, const PlacedPose& pose, BodyIndex partner, Clearance& clearance);
  void finishTick(Space& space, double dt);

  // rays.cpp
  bool areAllOutOfReach(const RayBundle& rays) const;
  void meetBody(const planar::PlanarRay& ray, const Body& body, RayHit& hit) const;

  // gripping.cpp
  BodyIndex findPrey(BodyIndex gripper) const;
  void grip(Space& space, BodyIndex gripper, BodyIndex prey);
  void join(BodyIndex gripper, BodyIndex prey);
  void takeOverGrips(const Space& space, BodyIndex index);
  void release(Space& space, BodyIndex gripper);
  void forgetGrips(BodyIndex index);

  Bodies bodies_;
  int subclock_ = 1;
  std::vector<PlanarShape> relative_shapes_;  // scratch of modelsOverlap

  // Bounds on how far any body moves: most bodies then need not look around in most steps (see Clearance).
  double mirrors_moved_ = 0.0;    // by at most, before this tick [m]
  double stride_ = 0.0;           // in one step of this tick [m]
  double travelled_ = 0.0;        // up to the end of the step under way [m]
  bool is_somebody_new_ = false;  // clearances hold no longer: a body came, or was put elsewhere
};

/// Whether a model at a pose overlaps a body, heights considered. `scratch` keeps its memory between calls.
bool modelsOverlap(const PlanarModel& model, const PlacedPose& pose, double along, const Body& other,
                   std::vector<PlanarShape>& scratch);

/// Where a velocity, constant in the body's frame while it turns, takes a body: exactly along the arc.
/// @param velocity [m/s]; @param turn_rate [rad/s]; @param dt [s]
PlacedPose integrate(const PlacedPose& start, const Eigen::Vector2d& velocity, double turn_rate, double dt);

}  // namespace swarmanoid::kinematics2d
