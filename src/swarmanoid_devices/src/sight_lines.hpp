/// Lines of sight from one robot to many points around it: which are free is what Space::isOccluded says, at a fraction
/// of the cost. Most lines pass by everything that is near; where one comes near something, only that part of it is
/// cast as a ray. What is near is known by the sphere of EntityModel::bounding_radius, as Space::mayHit knows it.
///
/// Threads  each needs a SightLines of its own, and keeps it: its room grows to what was needed, and stays.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

class SightLines {
 public:
  /// Looks from another eye, or in another tick. @param self whose eye it is, which hides nothing @param eye in W [m]
  /// @param near what PositionalIndex::collect finds in a sphere around the eye that all points are in
  void begin(const Space& space, Row self, const Eigen::Vector3d& eye, const std::vector<Row>& near);

  /// Whether something other than self and the owner stands between the eye and a point. @param point in W [m]
  /// @pre begin was called in this tick
  bool isOccluded(const Eigen::Vector3d& point, Row owner);

 private:
  bool isHitNear(std::size_t obstacle, const Eigen::Vector3d& way, Row owner) const;

  const Space* space_ = nullptr;
  Row self_ = kNoRow;
  Eigen::Vector3d eye_ = Eigen::Vector3d::Zero();

  // Spheres around what could hide something, column by column so that a line is compared with several at once. The
  // columns are as long as they have ever been; the first `count_` places are in use.
  std::size_t count_ = 0;
  std::vector<Row> rows_;
  std::vector<double> x_;  // centres, from the eye [m]
  std::vector<double> y_;  // likewise
  std::vector<double> z_;  // likewise
  std::vector<double>
      outside_;                 // squared distance of the eye minus squared radius: the eye is outside if positive [m2]
  std::vector<double> excess_;  // of the line that is asked about: it passes by if positive
};

}  // namespace swarmanoid::devices
