/// What the rays of a bundle may meet, as outlines seen from above: whoever casts many rays around itself, such as a
/// ring of sensors, then casts at each the few alone that pass by it (Space::castRayAt).
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
  static constexpr std::size_t kMostOfAKind = 16;  ///< beyond, they are anywhere

  static constexpr int kWhole = -1;  ///< not a part of an entity, but all of it

  /// Who answers for it, and what it is.
  struct Solid {
    const Engine* engine;  ///< null: the space itself
    Row row;
    int part;  ///< of the entity, as the engine counts them
  };
  /// A circle in the x-y plane of W: what may be hit lies over or under it.
  struct Circle {
    Solid solid;
    Eigen::Vector2d centre;  ///< [m]
    double radius;           ///< [m]
    /// It is as round, and is so at all heights of the rays: they hit it where they come into the circle.
    bool is_exact;
  };
  /// Likewise a box along the axes of W.
  struct Box {
    Solid solid;
    Eigen::Vector2d min;  ///< [m]
    Eigen::Vector2d max;  ///< [m]

    Eigen::Vector2d nearestTo(const Eigen::Vector2d& point) const { return point.cwiseMax(min).cwiseMin(max); }
  };

  void add(const Circle& circle) { keep(circle, circles_, circle_count_); }
  void add(const Box& box) { keep(box, boxes_, box_count_); }
  /// For those who cannot say where.
  void addAnywhere() { are_anywhere_ = true; }

  bool isEmpty() const { return !are_anywhere_ && circle_count_ + box_count_ == 0; }
  /// There are more than the outlines below.
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
