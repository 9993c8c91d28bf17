/// Where a segment hits the solids of an entity, as they are: for entities in no engine, and for engines that have no
/// shapes of their own to cast rays against; and whether an entity's solids hide its own LEDs.
#pragma once

#include <Eigen/Core>
#include <bitset>

#include "swarmanoid_space/rays/ray.hpp"
#include "swarmanoid_space/state/entities.hpp"
#include "swarmanoid_space/state/joints.hpp"

namespace swarmanoid {

/// The fraction of `segment` at which it first hits the entity's shapes; more than 1 if it does not. Thread-safe.
double closestHit(const Segment& segment, const EntityModel& model, const Pose& pose);

/// How far LEDs stand out of the surfaces on which they sit [m].
constexpr double kLedHeight = 0.005;

/// LEDs of one entity: bit k belongs to EntityModel::led_positions[k].
using LedSet = std::bitset<EntityModel::kMaxLeds>;

/// Which of an entity's LEDs its own shapes hide from an eye, by standing between the two.
///
/// Each shape counts without its outer kLedHeight (but never less than half of it, so that thin plates hide too): a
/// LED on a surface, or as deep in it, is seen from its own side of the body and a little beyond the edge of it, as
/// one that stands out by that much. A shape in which the LED lies deeper is a hull around it, such as the cage of an
/// eyebot's rotors or the solid of a prey whose colour is looked at, and does not hide it.
///
/// @param joints states of the model's joints; @param eye in the body frame [m]; @param asked others are left out
/// Thread-safe.
LedSet hiddenLeds(const EntityModel& model, Span<const JointState> joints, const Eigen::Vector3d& eye,
                  const LedSet& asked);

}  // namespace swarmanoid
