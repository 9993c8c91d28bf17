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
#include <cmath>
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
  /// The same for an upright cylinder without ends: whatever is within a distance of its axis, at any height.
  void collectUpright(const Eigen::Vector2d& axis, double radius, std::vector<Row>& found) const;

  /// An upright cylinder around an entity. What is tilted, or has arms, has one that holds its sphere.
  struct Outline {
    Eigen::Vector2d position;  ///< of its axis, in W [m]
    double radius;             ///< [m]
    double low;                ///< [m]
    double high;               ///< [m]
    Row row;
    /// It is just as wide, low and high as the model says, which stands upright: its silhouettes are where they are,
    /// over `low`. Else it holds the sphere around the entity.
    bool is_upright;

    /// Whether it meets the sphere: the question of collect, for those who keep what they look for themselves.
    bool meets(const Eigen::Vector3d& centre, double sphere_radius) const {
      const double reach = sphere_radius + radius;
      return (position - centre.head<2>()).squaredNorm() <= reach * reach && low <= centre.z() + sphere_radius &&
             high >= centre.z() - sphere_radius;
    }
  };
  /// What is wider than a cell, such as a wall: a box is a better bound for it.
  struct LargeOutline {
    Eigen::AlignedBox3d bounds;  ///< in W [m]
    Row row;

    /// Likewise.
    bool meets(const Eigen::Vector3d& centre, double sphere_radius) const {
      return bounds.squaredExteriorDistance(centre) <= sphere_radius * sphere_radius;
    }
  };
  /// Where an entity stands in the index until the next rebuild, from 0 to placeCount() - 1. What is near each other
  /// has neighbouring places mostly: what is kept by place is read faster than what is kept by row.
  using Place = std::uint32_t;

  /// Large ones have no place.
  std::size_t placeCount() const { return items_.size(); }
  const Outline& at(Place place) const { return items_[place]; }
  const std::vector<LargeOutline>& large() const { return large_items_; }
  /// Engines whose plane stands upright cast rays against prisms, whose corners are outside of outlines, though by no
  /// more than this [m]. Who collects what could stand in the way of a ray collects from a sphere larger by it.
  double prismMargin() const { return (M_SQRT2 - 1.0) * largest_small_radius_; }
  /// The places of those, not large, whose outlines meet the sphere; appended to `found` in no stated order.
  void collectPlaces(const Eigen::Vector3d& centre, double radius, std::vector<Place>& found) const;

  /// Entities whose origin is within `radius` of `centre`, by entity number.
  std::vector<Row> within(const Entities& entities, const Eigen::Vector3d& centre, double radius) const;
  /// The same around an entity, without itself.
  std::vector<Row> within(const Entities& entities, Row around, double radius) const;

 private:
  using Cell = std::array<int, 3>;

  static Outline outlineOf(const Entities& entities, Row row);
  Cell cellOf(const Eigen::Vector3d& position) const;
  std::size_t flat(const Cell& cell) const;
  template <class Visit>  // visit(Row)
  void visitNear(const Eigen::Vector3d& centre, double radius, Visit visit) const;
  template <class Visit>  // visit(Place), of all in cells that a box may meet; @param reach of the box each way [m]
  void visitPlaces(const Eigen::Vector3d& centre, const Eigen::Vector3d& reach, Visit visit) const;

  Eigen::Vector3d size_ = Eigen::Vector3d::Ones();
  Optimization optimization_ = Optimization::k2D;
  double cell_size_ = 1.0;
  double inverse_cell_size_ = 1.0;
  Cell cells_{1, 1, 1};
  double largest_small_radius_ = 0.0;      // among the items of the cells
  std::vector<std::uint32_t> first_item_;  // by cell; one more than there are cells
  std::vector<Outline> items_;             // sorted by cell
  std::vector<std::uint32_t> cell_of_entity_;
  std::vector<LargeOutline> large_items_;  // kept apart, looked at one by one
};

}  // namespace swarmanoid
