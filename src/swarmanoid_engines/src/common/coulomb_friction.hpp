/// Coulomb's friction along a surface: the force that holds back a place of contact that slips. Threads: any at once.
#pragma once

#include <Eigen/Core>

namespace swarmanoid {

/// The friction that ends a slip, or, if that takes more than the ground holds, the largest one, against the slip that
/// remains. So it is exact for any mass behind the place of contact, and for steps of any length.
/// @param yield velocity of the place for each unit of friction, symmetric and positive definite [m/s/N]
/// @param slip velocity of the place over the ground without friction [m/s]
/// @param most friction [N]; in impulses instead of forces, all in N s
Eigen::Vector2d coulombFriction(const Eigen::Matrix2d& yield, const Eigen::Vector2d& slip, double most);

}  // namespace swarmanoid
