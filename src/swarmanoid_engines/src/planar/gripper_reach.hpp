/// Reach of grippers: a gripper closes on a gripping strip within kGripperReach of its tip.
#pragma once

#include <cmath>

#include "common/grips.hpp"
#include "planar/bodies.hpp"

namespace swarmanoid::planar {

/// Tip of a gripper: position in the plane, and coordinate along its normal.
struct GripperTip {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
  double along = 0.0;                                  ///< [m]
};

/// Whether the gripper is commanded to close. @pre the body has a commanded gripper
inline bool isGripperClosed(const Space& space, const Body& body) {
  return space.holder_commands[body.row][static_cast<std::size_t>(body.gripper)].holds;
}

/// @pre the body has a gripper
GripperTip gripperTip(const Bodies& bodies, BodyIndex gripper);

/// Distance from the tip to the gripping strip around a body, seen along the normal [m]. Infinite if the body has no
/// strip, if the strip is not a circle in the plane, or if the tip is at another height.
double distanceToStrip(const Bodies& bodies, BodyIndex body, const GripperTip& tip);

/// The body nearest to the gripper's tip, among those within reach for which `may_be_gripped(index)` is true; at equal
/// distances the oldest. kNoBody if there is none.
template <class Filter>
BodyIndex findInReach(const Bodies& bodies, BodyIndex gripper, Filter may_be_gripped) {
  const GripperTip tip = gripperTip(bodies, gripper);
  BodyIndex nearest = kNoBody;
  double nearest_distance = kGripperReach;
  bodies.visitNear(tip.position, kGripperReach, [&](BodyIndex index) {
    const double distance = distanceToStrip(bodies, index, tip);
    const bool is_nearer = distance < nearest_distance || (nearest != kNoBody && distance == nearest_distance &&
                                                           bodies[index].number < bodies[nearest].number);
    if (is_nearer && index != gripper && may_be_gripped(index)) {
      nearest = index;
      nearest_distance = distance;
    }
    return true;
  });
  return nearest;
}

}  // namespace swarmanoid::planar
