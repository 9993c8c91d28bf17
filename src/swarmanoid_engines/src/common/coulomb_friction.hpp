/// Coulomb friction along a surface: the force that opposes a slipping contact. Threads: may run concurrently.
#pragma once

#include <Eigen/Core>

namespace swarmanoid {

/// The friction that ends a slip; if the ground cannot hold that much, friction at its limit, opposed to the remaining
/// slip. The result is exact for any mass behind the contact and any length of step.
/// @param yield velocity of the contact for each unit of friction, symmetric and positive definite [m/s/N]
/// @param slip velocity of the contact over the ground without friction [m/s]
/// @param most limit of the friction [N]; with impulses instead of forces, all in N s
Eigen::Vector2d coulombFriction(const Eigen::Matrix2d& yield, const Eigen::Vector2d& slip, double most);

}  // namespace swarmanoid
