/// Outlines, seen from above, of the obstacles that the rays of a bundle may hit. A caller with many rays, such as a
/// ring of sensors, casts at each obstacle only the few rays that pass near it (Space::castRayAt).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "swarmanoid_interface/span.hpp"
#include "swarmanoid_space/state/row.hpp"

namespace swarmanoid {

class Engine;

class Obstacles {
 public:
  static constexpr std::size_t kMostOfAKind = 16;  ///< more are reported as anywhere

  static constexpr int kWhole = -1;  ///< the whole entity, not a part

  /// A solid, and the engine that casts rays against it.
  struct Solid {
    const Engine* engine;  ///< null: the space itself
    Row row;
    int part;  ///< of the entity, as the engine counts them
  };
  /// A circle in the x-y plane of W: the obstacle lies above or below it.
  struct Circle {
    Solid solid;
    Eigen::Vector2d centre;  ///< [m]
    double radius;           ///< [m]
    /// True if the solid has exactly this outline at all heights of the rays: they hit it where they enter the circle.
    bool is_exact;
  };
  /// A box along the axes of W, in the same plane.
  struct Box {
    Solid solid;
    Eigen::Vector2d min;  ///< [m]
    Eigen::Vector2d max;  ///< [m]

    Eigen::Vector2d nearestTo(const Eigen::Vector2d& point) const { return point.cwiseMax(min).cwiseMin(max); }
  };

  void add(const Circle& circle) { keep(circle, circles_, circle_count_); }
  void add(const Box& box) { keep(box, boxes_, box_count_); }
  /// Reports obstacles at unknown places.
  void addAnywhere() { are_anywhere_ = true; }

  bool isEmpty() const { return !are_anywhere_ && circle_count_ + box_count_ == 0; }
  /// Whether there may be obstacles beyond the outlines below.
  bool areAnywhere() const { return are_anywhere_; }
  Span<const Circle> circles() const { return {circles_.data(), circle_count_}; }
  Span<const Box> boxes() const { return {boxes_.data(), box_count_}; }

 private:
  template <class Outline>
  void keep(const Outline& outline, std::array<Outline, kMostOfAKind>& outlines, std::size_t& count) {
    if (count == kMostOfAKind) {
      are_anywhere_ = true;
    } else {
      outlines[count++] = outline;
    }
  }

  std::array<Circle, kMostOfAKind> circles_;
  std::array<Box, kMostOfAKind> boxes_;
  std::size_t circle_count_ = 0;
  std::size_t box_count_ = 0;
  bool are_anywhere_ = false;
};

}  // namespace swarmanoid
