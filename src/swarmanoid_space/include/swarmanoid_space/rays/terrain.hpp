/// A heightfield: ground that is not level, as heights over a rectangle of the arena, on a regular grid.
///
/// Frame W, SI. Vertex (i, j) is the i-th along x and the j-th along y. Each cell is cut into two triangles, from its
/// corner of least x and y to that of greatest x and y, like ODE's heightfields with z upwards.
///
/// The ground below the triangles is solid. Around the rectangle is the floor at z = 0; a rim at another height forms a
/// cliff. Rays hit the ground where they enter it. Rays from below the surface pass through it, so a hill does not
/// disturb engines that move robots in a plane below it.
///
/// Threads: const functions may run concurrently.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "swarmanoid_space/rays/ray.hpp"

namespace swarmanoid {

class Terrain {
 public:
  /// Cells with indices from `low` to `high`, both included; none if a component of `high` is less than that of `low`.
  struct Cells {
    Eigen::Vector2i low = Eigen::Vector2i::Zero();
    Eigen::Vector2i high = Eigen::Vector2i::Constant(-1);
  };
  /// Counterclockwise as seen from above.
  struct Triangle {
    Eigen::Vector3d corners[3];
    Eigen::Vector3d normal;  ///< upwards
  };

  /// @param low the rectangle's corner of least x and y [m]; @param size its sides [m], greater than 0
  /// @param columns, rows numbers of vertices along x and y, at least 2
  /// @param heights z of the vertices [m], row after row along x, beginning at `low`
  /// @throws std::invalid_argument if these do not fit together
  Terrain(const Eigen::Vector2d& low, const Eigen::Vector2d& size, int columns, int rows, std::vector<double> heights);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  Eigen::Vector3d vertex(int i, int j) const { return {lineX(i), lineY(j), height(i, j)}; }
  /// One of the cell's two triangles: that at its corner of greatest x and least y (half 0), or of least x and greatest
  /// y (half 1).
  Triangle triangle(int i, int j, int half) const;
  /// Box around the rectangle, from the lowest vertex to the highest.
  const Eigen::AlignedBox3d& bounds() const { return bounds_; }

  /// Whether the point is above, on or below the rectangle, its border included.
  bool contains(double x, double y) const {
    return x >= bounds_.min().x() && x <= bounds_.max().x() && y >= bounds_.min().y() && y <= bounds_.max().y();
  }
  /// Height of the surface [m]; beyond the rectangle, of the planes of its outermost triangles.
  double heightAt(double x, double y) const;
  /// The cell that contains the point, or the nearest one.
  Eigen::Vector2i cellAt(double x, double y) const;
  /// The triangle above or below the point, or that of the nearest cell.
  Triangle triangleAt(double x, double y) const;
  /// The cells that a rectangle overlaps.
  Cells cellsIn(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const;
  /// The greatest height of the vertices of these cells [m]; -infinity for none.
  double highestIn(const Cells& cells) const;

  /// The fraction of the segment at which it first enters the ground; infinity if it does not.
  double closestHit(const Segment& segment) const;
  /// Whether a ray of the bundle could hit the ground; in doubt, true. Does not read its segments.
  bool mayHit(const RayBundle& rays) const;
  /// Replaces the hit of each segment that hits the ground nearer than its entry in `hits`.
  void raycast(const RayBundle& rays, Span<RayHit> hits) const;

 private:
  class Descent;

  double height(int i, int j) const {
    return heights_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i)];
  }
  double lineX(int i) const { return bounds_.min().x() + i * step_.x(); }
  double lineY(int j) const { return bounds_.min().y() + j * step_.y(); }
  double heightInCell(const Eigen::Vector2i& cell, double x, double y, int half) const;

  int columns_;
  int rows_;
  Eigen::Vector2d step_;  // between vertices [m]
  Eigen::AlignedBox3d bounds_;
  std::vector<double> heights_;
};

}  // namespace swarmanoid
