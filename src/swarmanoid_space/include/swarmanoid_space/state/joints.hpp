/// The states of robots' joints, and the poses of the links that they turn.
///
/// Frames: B, the body frame of the entity's model. Angles [rad] are right-handed about the joints' axes, with the zero
/// of the URDF; those of continuous joints are in (-pi, pi].
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>

#include "swarmanoid_space/models/entity_model.hpp"
#include "swarmanoid_space/state/state_visitor.hpp"

namespace swarmanoid {

struct JointState {
  double angle = 0.0;  ///< [rad]
  double speed = 0.0;  ///< [rad/s]
  /// Last torque of the motor and the stops, along positive angles; not set by engines without forces [N m].
  double effort = 0.0;
};

void visitCell(StateVisitor& visitor, const char* name, const CellOwner& owner, Span<const JointState> joints);

/// Displacement of a joint's link from its pose with all joints at zero: a point of the link at p in B moves to
/// displacement * p. @param joint an index of the model's joints; -1: the body, which is never displaced
/// @param states one for each of the model's joints; empty: all at zero
Eigen::Isometry3d displacementOf(const EntityModel& model, Span<const JointState> states, int joint);

/// A shape of the model, turned by its joints.
CollisionShape placeOf(const EntityModel& model, Span<const JointState> states, const CollisionShape& shape);

/// The model with its shapes turned by the joints, for queries about an entity that is not in its engine yet; `model`
/// itself if all joints that turn shapes are at zero. Allocates.
std::shared_ptr<const EntityModel> posedModel(const std::shared_ptr<const EntityModel>& model,
                                              Span<const JointState> states);

/// The current pose of a device in B. @throws std::out_of_range if there is no such mount
Mount placeOf(const EntityModel& model, Span<const JointState> states, const std::string& mount);

}  // namespace swarmanoid
