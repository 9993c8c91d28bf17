/// The area on which a body rests, and Coulomb's friction on it.
///
/// Each element of the support carries its share of the weight, and friction opposes the element's own slip with that
/// share of the most that there can be. So friction couples sliding and turning: the forces and torques that can hold a
/// body form its limit surface, and a body that slides has no static torque left (Goyal, Ruina, Papadopoulos, Planar
/// sliding with dry friction, Wear 143, 1991). The sum over elements is taken over some fifty points; an ellipsoid in
/// place of the limit surface would turn a block that is pushed off its middle half as far as it should (decision 38).
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

/// How the weight is spread over the outline on which a body rests.
enum class Pressure {
  kEven,  ///< the same on each square metre of it
  kEdge,  ///< on its corners, or around its rim: as `dynamics3d` holds boxes and cylinders
};

struct Support {
  /// Two points side by side, for vector instructions.
  struct Points {
    Eigen::Array2d arm_x = Eigen::Array2d::Zero();  ///< [m]
    Eigen::Array2d arm_y = Eigen::Array2d::Zero();  ///< [m]
    Eigen::Array2d share = Eigen::Array2d::Zero();  ///< of the weight; those of all points are 1 in sum
  };
  std::vector<Points> points;
  /// From a velocity to friction, while the velocity is far below that at which a point counts as slipping; of a unit
  /// of weight.
  Eigen::Matrix3d resistance_at_rest = Eigen::Matrix3d::Zero();
};

/// The support of a model: the convex outline of its lowest shapes, moved so that the weight is carried below the
/// centre of mass. @param support keeps its memory
void makeSupport(const planar::PlanarModel& model, Pressure pressure, Support& support);

/// Velocity along x and y, and turn rate, of a body.
using PlanarTwist = Eigen::Vector3d;

/// The velocity that a body has after a step in which friction with the ground acts on it: the one of maximal
/// dissipation, which is the minimum of a convex function.
/// @param inertia mass twice, and moment of inertia [kg, kg, kg m2]
/// @param free velocity without friction, in the body's frame @param most impulse of friction in the step [N s]
/// @param guesses of the result; the better one is the start of the iteration
/// @return the velocity at which forces balance within a millionth of `most`
PlanarTwist velocityAfterFriction(const Support& support, const Eigen::Vector3d& inertia, const PlanarTwist& free,
                                  double most, const std::array<PlanarTwist, 2>& guesses);

}  // namespace swarmanoid::dynamics2d
