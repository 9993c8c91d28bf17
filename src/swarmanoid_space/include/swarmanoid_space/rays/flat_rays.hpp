/// Rays projected to a plane, stored column by column so that the compiler vectorises the loops; finds the rays that
/// pass near an outline. For rings of sensors, and for engines that cast rays in a plane.
///
/// Coordinates are of any one frame [m]. Threads: const functions may run concurrently.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "swarmanoid_space/rays/line_part.hpp"
#include "swarmanoid_space/rays/ray.hpp"

namespace swarmanoid {

/// @tparam most maximum number of rays, up to 64
template <std::size_t most>
class FlatRays {
  static_assert(most <= 64);

 public:
  FlatRays() {}  // columns stay uninitialised: most bundles hit nothing

  std::size_t size() const { return count_; }
  void resize(std::size_t count) { count_ = count; }
  /// Sets both ends of a ray. @pre k < size(); call `measure` after all are set
  void set(std::size_t k, const Eigen::Vector2d& from, const Eigen::Vector2d& step) {
    from_x_[k] = from.x();
    from_y_[k] = from.y();
    step_x_[k] = step.x();
    step_y_[k] = step.y();
  }
  void measure() {
    for (std::size_t k = 0; k < count_; ++k) {
      const double length_squared = step_x_[k] * step_x_[k] + step_y_[k] * step_y_[k];
      length_[k] = std::sqrt(length_squared);
      half_length_squared_[k] = 0.5 * length_squared;
    }
  }

  Eigen::Vector2d from(std::size_t k) const { return {from_x_[k], from_y_[k]}; }
  Eigen::Vector2d step(std::size_t k) const { return {step_x_[k], step_y_[k]}; }

  /// The fraction of a ray at which it enters a circle; 0 if it starts inside, 1 if it does not reach the circle.
  double entryInto(const Eigen::Vector2d& centre, double radius, std::size_t k) const {
    LinePart inside;
    inside.clipToRound(Eigen::Vector2d(from(k) - centre), step(k), radius);
    return inside.isEmpty() ? 1.0 : inside.from;
  }

  /// The rays near a point: within the radius to their side, and as far before or behind them.
  RayMask nearPoint(const Eigen::Vector2d& point, double radius) const {
    // no branches and divisions, so that the loop is vectorised: all terms are scaled by the length
    const double x = point.x();
    const double y = point.y();
    Column excess;
    for (std::size_t k = 0; k < count_; ++k) {
      const double way_x = x - from_x_[k];
      const double way_y = y - from_y_[k];
      const double across = std::abs(way_x * step_y_[k] - way_y * step_x_[k]);
      const double along = std::abs(way_x * step_x_[k] + way_y * step_y_[k] - half_length_squared_[k]);
      const double beyond = along - half_length_squared_[k];
      excess[k] = (across > beyond ? across : beyond) - radius * length_[k];
    }
    return notAbove0(excess);
  }

  /// The rays whose bounding box meets a box.
  RayMask nearBox(const Eigen::AlignedBox2d& box) const {
    const Eigen::Vector2d middle = box.center();
    const Eigen::Vector2d half = 0.5 * box.sizes();
    Column excess;
    for (std::size_t k = 0; k < count_; ++k) {
      const double half_x = 0.5 * step_x_[k];
      const double half_y = 0.5 * step_y_[k];
      const double beyond_x = std::abs(from_x_[k] + half_x - middle.x()) - std::abs(half_x) - half.x();
      const double beyond_y = std::abs(from_y_[k] + half_y - middle.y()) - std::abs(half_y) - half.y();
      excess[k] = (beyond_x > beyond_y ? beyond_x : beyond_y) - kRounding;
    }
    return notAbove0(excess);
  }

 private:
  using Column = std::array<double, most>;
  static constexpr double kRounding = 1e-9;  // m: contact counts as a hit

  RayMask notAbove0(const Column& excess) const {
    RayMask mask = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      mask |= static_cast<RayMask>(excess[k] <= 0.0) << k;
    }
    return mask;
  }

  std::size_t count_ = 0;
  Column from_x_;
  Column from_y_;
  Column step_x_;
  Column step_y_;
  Column length_;
  Column half_length_squared_;
};

}  // namespace swarmanoid
