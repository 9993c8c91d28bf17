/// Occlusion of points around a camera: decides for all points of one entity at once which of them obstacles hide. The
/// result equals that of Space::castRay for each point, bit for bit. Most points have no obstacle before them, which is
/// found without a ray: rays are cast only to points whose line passes through the box around an obstacle.
///
/// Threads  one NearObstacles per thread, kept between calls: its buffers grow to the size needed, and stay.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "led_points.hpp"
#include "swarmanoid_space/rays/led_shades.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// A hit this close to the target point is the point's own surface, not an obstacle (fraction of the way).
constexpr double kOwnSurface = 1e-6;

/// Margin of all boxes, so that rounding misses no obstacle [m].
constexpr double kSightRounding = 1e-9;

class NearObstacles {
 public:
  /// Sets the eye; called for each eye in each tick.
  /// @param self the robot that carries the eye; it hides nothing @param eye in W [m]
  /// @param near all entities that could hide a point between these heights
  /// @param low, high [m]; a line beyond these heights is always cast as a ray
  void begin(const Space& space, Row self, const Eigen::Vector3d& eye, const std::vector<Row>& near, double low,
             double high);

  /// Returns the points of `asked` that an entity other than self and the owner hides.
  /// @param owner kNoRow: no owner @pre begin was called in this tick
  LedSet hidden(const LedPoints& points, const LedSet& asked, Row owner);
  /// Whether an obstacle hides a single point, such as a spot on the ground.
  bool hides(const Eigen::Vector3d& point, Row owner);

 private:
  /// An axis-aligned box in W around all parts of an entity that rays can hit, relative to the eye [m].
  struct Obstacle {
    Row row;
    Eigen::AlignedBox3d box;
  };
  /// Lines from the eye to all points of a small ball.
  struct Bundle {
    Eigen::Vector2d inverse_way;  ///< inverse of the horizontal way to the ball's centre, by coordinate [1/m]
    double radius;                ///< of the ball [m]
    double lowest;                ///< lowest end of a line, relative to the eye [m]
    double highest;               ///< highest end of a line, relative to the eye [m]
  };

  static Obstacle obstacleOf(const Space& space, Row row, const Eigen::Vector3d& eye);
  static Bundle bundleTo(const Eigen::Vector3d& way, double radius, double lowest, double highest);
  static bool mayHide(const Obstacle& obstacle, const Bundle& bundle);
  Bundle bundleOf(const LedPoints& points, const LedSet& asked) const;
  Bundle lineTo(const Eigen::Vector3d& point) const;
  /// Returns the points of `asked` whose lines may pass through an obstacle. @param bundle of all asked points
  LedSet passing(const LedPoints& points, const LedSet& asked, const Bundle& bundle, Row owner);
  LedSet cast(const LedPoints& points, const LedSet& asked, Row owner) const;
  /// Whether the list of obstacles is complete for the bundle.
  bool knowsAllBefore(const Bundle& bundle) const;

  const Space* space_ = nullptr;
  Row self_ = kNoRow;
  Eigen::Vector3d eye_ = Eigen::Vector3d::Zero();
  double low_ = 0.0;   // relative to the eye, m
  double high_ = 0.0;  // relative to the eye, m
  std::vector<Obstacle> obstacles_;
  std::vector<const Obstacle*> on_the_way_;
};

}  // namespace swarmanoid::devices
