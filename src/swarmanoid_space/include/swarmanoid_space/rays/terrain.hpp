/// Ground that is not level: heights over a rectangle of the arena, on a regular grid.
///
/// Frame W, SI. Vertex (i, j) is the i-th along x and the j-th along y. Each cell is cut into two triangles, from its
/// corner of least x and y to that of most x and y, as ODE's heightfields are when they lie with z upwards.
///
/// Below the triangles is solid ground, and around the rectangle the floor at z = 0: where the rim is at another height
/// there is a cliff. Rays hit the ground where they go into it; those that come from below the surface pass through
/// it, so engines that move robots in a plane under a hill are not disturbed.
///
/// Threads: const from any number of them.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "swarmanoid_space/rays/ray.hpp"

namespace swarmanoid {

class Terrain {
 public:
  /// Cells whose indices are from `low` to `high`, both included; none if one of `high` is less.
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
  /// The one of the cell's two triangles that reaches to its corner of most x (0), or of most y (1).
  Triangle triangle(int i, int j, int half) const;
  /// From the lowest vertex to the highest.
  const Eigen::AlignedBox3d& bounds() const { return bounds_; }

  /// Whether the point lies above the rectangle, on it or below; its border included.
  bool contains(double x, double y) const {
    return x >= bounds_.min().x() && x <= bounds_.max().x() && y >= bounds_.min().y() && y <= bounds_.max().y();
  }
  /// Of the surface [m]; beyond the rectangle that of the planes of its outermost triangles.
  double heightAt(double x, double y) const;
  /// The cell that holds the point, or the nearest one.
  Eigen::Vector2i cellAt(double x, double y) const;
  /// The triangle above or below the point, or that of the nearest cell.
  Triangle triangleAt(double x, double y) const;
  /// The cells that a rectangle overlaps.
  Cells cellsIn(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const;
  /// The highest vertex of these cells [m]; -infinity for none.
  double highestIn(const Cells& cells) const;

  /// The fraction of the segment at which it first goes into the ground; infinity if it does not.
  double closestHit(const Segment& segment) const;
  /// Whether a ray of the bundle could hit the ground; in doubt, yes. Its segments are not looked at.
  bool mayHit(const RayBundle& rays) const;
  /// For each segment: if it hits the ground nearer than `hits` says so far, that hit replaces it.
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

/// Reads a terrain from a grey PNG image of 8 or 16 bits: its columns along x, its first row at the greatest y, the
/// outermost pixels on the rectangle's border. Grey values are taken as they are; gamma does not count.
/// @param middle of the rectangle, at the height of black [m]; @param height of white over black [m]
/// @throws std::runtime_error what the file is that it should not be, such as "is no PNG image"
Terrain readTerrain(const std::string& file, const Eigen::Vector3d& middle, const Eigen::Vector2d& size, double height);

}  // namespace swarmanoid
