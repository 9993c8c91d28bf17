/// What stands around a camera: which of the points of one thing it hides, by one question for all of them. The answer
/// is what Space::castRay says of each, to the last bit. Most things have nothing before them, which is found without a
/// ray: rays are cast only to points whose line passes the box around something.
///
/// Threads  each needs a NearObstacles of its own, and keeps it: its room grows to what was needed, and stays.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "led_points.hpp"
#include "swarmanoid_space/rays/led_shades.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// A surface this near to the point looked at is the point's own surface, not an obstacle (fraction of the way).
constexpr double kOwnSurface = 1e-6;

/// By how much more is looked at than is there, so that rounding leaves nothing out [m].
constexpr double kSightRounding = 1e-9;

class NearObstacles {
 public:
  /// Looks from another eye, or in another tick. @param self whose eye it is, which hides nothing @param eye in W [m]
  /// @param near all that could stand before points of these heights that the eye is asked about
  /// @param low, high [m]; beyond these heights each line is cast as a ray
  void begin(const Space& space, Row self, const Eigen::Vector3d& eye, const std::vector<Row>& near, double low,
             double high);

  /// Returns those of the asked points that something other than self and the owner stands before.
  /// @param owner kNoRow: nobody's @pre begin was called in this tick
  LedSet hidden(const LedPoints& points, const LedSet& asked, Row owner);
  /// Whether something hides a single point, such as a spot on the ground.
  bool hides(const Eigen::Vector3d& point, Row owner);

 private:
  /// A box along the axes of W that holds all that rays hit of a thing, as seen from the eye [m].
  struct Obstacle {
    Row row;
    Eigen::AlignedBox3d box;
  };
  /// Lines from the eye to all points of a small ball.
  struct Bundle {
    Eigen::Vector2d inverse_way;  ///< of the way to the middle of the ball, seen from above, by coordinate [1/m]
    double radius;                ///< of the ball [m]
    double lowest;                ///< end of a line, over the eye [m]
    double highest;               ///< likewise
  };

  static Obstacle obstacleOf(const Space& space, Row row, const Eigen::Vector3d& eye);
  static Bundle bundleTo(const Eigen::Vector3d& way, double radius, double lowest, double highest);
  static bool mayHide(const Obstacle& obstacle, const Bundle& bundle);
  Bundle bundleOf(const LedPoints& points, const LedSet& asked) const;
  Bundle lineTo(const Eigen::Vector3d& point) const;
  /// Returns those whose lines may pass through something. @param bundle of all that are asked about
  LedSet passing(const LedPoints& points, const LedSet& asked, const Bundle& bundle, Row owner);
  LedSet cast(const LedPoints& points, const LedSet& asked, Row owner) const;
  /// Whether all that could stand before the bundle is known.
  bool knowsAllBefore(const Bundle& bundle) const;

  const Space* space_ = nullptr;
  Row self_ = kNoRow;
  Eigen::Vector3d eye_ = Eigen::Vector3d::Zero();
  double low_ = 0.0;   // over the eye, m
  double high_ = 0.0;  // likewise
  std::vector<Obstacle> obstacles_;
  std::vector<const Obstacle*> on_the_way_;
};

}  // namespace swarmanoid::devices
