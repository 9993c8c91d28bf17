/// Where robots' joints are, and the links that they turn.
///
/// Frames: B, the body frame of the entity's model. Angles [rad] are right-handed about the joints' axes and 0 where
/// the URDF has them; those of endless joints are in (-pi, pi].
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>

#include "swarmanoid_space/models/entity_model.hpp"
#include "swarmanoid_space/state/state_visitor.hpp"

namespace swarmanoid {

struct JointState {
  double angle = 0.0;   ///< [rad]
  double speed = 0.0;   ///< [rad/s]
  double effort = 0.0;  ///< that the robot's motor and stops gave at last, along positive angles; of no engine without
                        ///< forces [N m]
};

void visitCell(StateVisitor& visitor, const char* name, const CellOwner& owner, Span<const JointState> joints);

/// How the link that a joint turns lies off from where it is with all joints at zero: a point of it that then is at p
/// in B is at displacement * p. @param joint an index of the model's joints; -1: the body, which is never displaced
/// @param states one for each of the model's joints; none: all are at zero
Eigen::Isometry3d displacementOf(const EntityModel& model, Span<const JointState> states, int joint);

/// A shape of the model where the joints have turned it.
CollisionShape placeOf(const EntityModel& model, Span<const JointState> states, const CollisionShape& shape);

/// The model's shapes where the joints have turned them, for callers that ask about an entity that is not in its engine
/// yet; `model` itself, if all joints that turn shapes are at zero. Allocates.
std::shared_ptr<const EntityModel> posedModel(const std::shared_ptr<const EntityModel>& model,
                                              Span<const JointState> states);

/// Where a device sits now, in B. @throws std::out_of_range if there is no such mount
Mount placeOf(const EntityModel& model, Span<const JointState> states, const std::string& mount);

}  // namespace swarmanoid
