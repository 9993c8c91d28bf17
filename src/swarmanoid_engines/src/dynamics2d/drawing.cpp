// Debug drawing of the engine.
#include "dynamics2d/dynamics2d.hpp"
#include "planar/draw_bodies.hpp"
#include "planar/gripper_reach.hpp"

namespace swarmanoid::dynamics2d {

using DrawingKind = EngineDrawing::Kind;

void Dynamics2d::draw(EngineDrawing& drawing) const {
  constexpr double kLength = 0.05;  // m
  PlanarEngine::draw(drawing);
  for (const DrawnContact& contact : contacts_) {
    planar::drawLine(bodies_, contact.body, DrawingKind::kContact, contact.point,
                     contact.point + kLength * contact.normal, drawing);
  }
  for (const BodyIndex index : movers_) {
    const Grip& grip = rigid(index).grip;
    if (grip.isHolding()) {
      const Eigen::Vector2d tip = planar::gripperTip(bodies_, index).position;
      planar::drawLine(bodies_, index, DrawingKind::kJoint, bodies_[index].pose.position, tip, drawing);
      planar::drawLine(bodies_, index, DrawingKind::kJoint, tip, bodies_[grip.gripped].pose.position, drawing);
    }
    drawForces(index, drawing);
  }
}

void Dynamics2d::drawForces(BodyIndex index, EngineDrawing& drawing) const {
  const RigidBody& rigid_body = rigid(index);
  const auto line = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& force) {
    planar::drawLine(bodies_, index, DrawingKind::kForce, from, from + EngineDrawing::kMetresPerNewton * force,
                     drawing);
  };
  if (!rigid_body.is_present || rigid_body.drive != Drive::kTreels) {
    if (rigid_body.drive != Drive::kNone) {
      line(rigid_body.centre, rigid_body.last_push);
    }
    return;
  }
  for (std::size_t i = 0; i < rigid_body.treel_forces.size(); ++i) {
    const Eigen::Vector2d& arm = i == 0 ? rigid_body.treels.left : rigid_body.treels.right;
    line(rigid_body.centre + bodies_[index].pose.rotated(arm), rigid_body.treel_forces[i]);
  }
}

}  // namespace swarmanoid::dynamics2d
