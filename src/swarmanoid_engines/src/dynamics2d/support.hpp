/// The area on which a body rests, and Coulomb friction on it.
///
/// Each element of the support carries its share of the weight, and its friction opposes its own slip, with that share
/// of the limit. So friction couples sliding and turning: the forces and torques that can hold a body form its limit
/// surface, and a sliding body has no static torque left (Goyal, Ruina, Papadopoulos, Planar sliding with dry friction,
/// Wear 143, 1991). Some fifty points stand for all elements; with an ellipsoid in place of the limit surface, a block
/// pushed off its middle would turn half as far as it should (decision 38).
///
/// An element that slips by less than a micrometre a second is held in proportion to its slip: so a body that rests
/// under a load creeps by about that.
///
/// Frame: the body's centre of mass, at heading 0. SI units.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "planar/planar_model.hpp"

namespace swarmanoid::dynamics2d {

/// Distribution of the weight over the outline on which a body rests.
enum class Pressure {
  kEven,  ///< equal on each square metre
  kEdge,  ///< on its corners or its rim: as `dynamics3d` holds boxes and cylinders
};

struct Support {
  /// Two points side by side, for vector instructions.
  struct Points {
    Eigen::Array2d arm_x = Eigen::Array2d::Zero();  ///< [m]
    Eigen::Array2d arm_y = Eigen::Array2d::Zero();  ///< [m]
    Eigen::Array2d share = Eigen::Array2d::Zero();  ///< of the weight; the shares of all points add up to 1
  };
  std::vector<Points> points;
  /// Maps a velocity to friction per unit of weight, while no point is near the speed at which it counts as slipping.
  Eigen::Matrix3d resistance_at_rest = Eigen::Matrix3d::Zero();
};

/// The support of a model: the convex outline of its lowest shapes, shifted so that it carries the weight below the
/// centre of mass. @param support keeps its memory
void makeSupport(const planar::PlanarModel& model, Pressure pressure, Support& support);

/// Velocity along x and y, and turn rate, of a body.
using PlanarTwist = Eigen::Vector3d;

/// Velocity of a body after a step of friction with the ground: the velocity of maximal dissipation, which is the
/// minimum of a convex function.
/// @param inertia the mass, twice, and the moment of inertia [kg, kg, kg m2]
/// @param free velocity without friction, in the body's frame @param most impulse of friction in the step [N s]
/// @param guesses of the result; the better one is the start of the iteration
/// @return the velocity at which forces balance within a millionth of `most`
PlanarTwist velocityAfterFriction(const Support& support, const Eigen::Vector3d& inertia, const PlanarTwist& free,
                                  double most, const std::array<PlanarTwist, 2>& guesses);

}  // namespace swarmanoid::dynamics2d
