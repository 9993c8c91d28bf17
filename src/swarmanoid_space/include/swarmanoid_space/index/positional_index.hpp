/// Finds entities by place (thesis 3.4, "positional information").
///
/// A grid of cells over the arena instead of the thesis's oct-tree: a query costs what is near, whatever the number of
/// entities, and the whole index is rebuilt each tick in time linear in that number. optimization="2D" keeps columns
/// (one cell in z), "3D" keeps cubes. What has left the arena is kept in the border cells, so nothing is ever lost.
///
/// Phase   rebuilt in `index`; queries are const and safe from many threads.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid {

class PositionalIndex {
 public:
  enum class Optimization { k2D, k3D };

  /// @param size of the arena, which spans from 0 to size in each axis [m]; @param expected_entities picks the cell
  /// size
  void configure(const Eigen::Vector3d& size, Optimization optimization, std::size_t expected_entities);

  /// Reads every living entity's pose and bounds. No allocation once the number of entities is steady.
  void rebuild(const Entities& entities);

  /// Entities whose bounds (an upright cylinder, or a box for large ones) meet the sphere around `centre`; appended to
  /// `found` in no stated order.
  void collect(const Eigen::Vector3d& centre, double radius, std::vector<Row>& found) const;

  /// Entities whose origin is within `radius` of `centre`, by entity number.
  std::vector<Row> within(const Entities& entities, const Eigen::Vector3d& centre, double radius) const;
  /// The same around an entity, without itself.
  std::vector<Row> within(const Entities& entities, Row around, double radius) const;

 private:
  /// An upright cylinder around an entity. What is tilted has one that holds its sphere.
  struct Item {
    Eigen::Vector2d position;
    double radius;
    double low;
    double high;
    Row row;
  };
  /// Wider than a cell, such as a wall: a box is a better bound for it than a sphere.
  struct LargeItem {
    Eigen::AlignedBox3d bounds;
    Row row;
  };
  using Cell = std::array<int, 3>;

  static Item itemOf(const Entities& entities, Row row);
  Cell cellOf(const Eigen::Vector3d& position) const;
  std::size_t flat(const Cell& cell) const;
  template <class Visit>  // bool visit(Row): false stops
  void visitNear(const Eigen::Vector3d& centre, double radius, Visit visit) const;

  Eigen::Vector3d size_ = Eigen::Vector3d::Ones();
  Optimization optimization_ = Optimization::k2D;
  double cell_size_ = 1.0;
  double inverse_cell_size_ = 1.0;
  Cell cells_{1, 1, 1};
  double largest_small_radius_ = 0.0;      // among the items of the cells
  std::vector<std::uint32_t> first_item_;  // by cell; one more than there are cells
  std::vector<Item> items_;                // sorted by cell
  std::vector<std::uint32_t> cell_of_entity_;
  std::vector<LargeItem> large_items_;  // kept apart, looked at one by one
};

}  // namespace swarmanoid
