/// Finds entities by position (thesis 3.4, "positional information").
///
/// A grid of cells over the arena instead of the thesis's oct-tree: the cost of a query depends on the entities near
/// it, not on their total number. A rebuild takes time linear in the number of entities; it runs in each tick in which
/// the index is queried, and not at all otherwise. optimization="2D" uses columns (one cell in z), "3D" uses cubes.
/// Entities outside the arena are in the border cells, so none is lost.
///
/// Phase   updated in `index`, and between ticks when entities are added, removed or moved. No queries from `move` to
///         `connect`, while poses change.
/// Threads queries are const and thread-safe.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <vector>

#include "swarmanoid_space/index/box_grid.hpp"
#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid {

class PositionalIndex {
 public:
  enum class Optimization { k2D, k3D };

  /// @param size of the arena [m] @param expected_entities determines the cell size
  /// @param corner of the arena, with its least coordinates [m]
  void configure(const Eigen::Vector3d& size, Optimization optimization, std::size_t expected_entities,
                 const Eigen::Vector3d& corner = Eigen::Vector3d::Zero());

  /// Reads the pose and bounds of every living entity. No allocation once the number of entities is steady.
  void rebuild(const Entities& entities);
  /// Marks the start of pose changes: no queries until the next `update`, `rebuild` or `forget`.
  void close();
  /// Called after entities have moved. Rebuilds the index if it was queried since the last rebuild; otherwise the next
  /// query rebuilds it, as after `forget`.
  void update(const Entities& entities);
  /// Invalidates the index; the next query rebuilds it.
  /// @param entities must outlive that query, and not change before it
  void forget(const Entities& entities);

  /// Entities whose bounds (an upright cylinder, or a box for large ones) meet the sphere around `centre`; appended to
  /// `found` in no stated order.
  void collect(const Eigen::Vector3d& centre, double radius, std::vector<Row>& found) const;
  /// The same for an infinite upright cylinder: all entities within a distance of its axis, at any height.
  void collectUpright(const Eigen::Vector2d& axis, double radius, std::vector<Row>& found) const;

  // Queries with a visitor, without a list of results; defined in index/positional_index_visits.hpp.

  /// Calls visit(const LargeOutline&) for each large entity whose box meets the sphere, until it returns false.
  template <class Visit>
  void visitLarge(const Eigen::Vector3d& centre, double radius, Visit visit) const;
  /// Calls visit(Row) for each entity that collectUpright finds.
  template <class Visit>
  void visitUpright(const Eigen::Vector2d& axis, double radius, Visit visit) const;
  /// Pairs of entities whose origins, seen from above, are at most `distance` apart: calls visit(Row, Row, double
  /// square of the distance) once for each pair, in no stated order. Far cheaper than a query around each entity.
  /// @param is_large_meant (Row) whether a large entity may be part of a pair; excluding walls saves time
  template <class IsLargeMeant, class Visit>
  void visitPairs(const Entities& entities, double distance, IsLargeMeant is_large_meant, Visit visit) const;

  /// An upright cylinder around an entity. For an entity that is tilted or has arms, it contains the entity's sphere.
  struct Outline {
    Eigen::Vector2d position;  ///< of its axis, in W [m]
    double radius;             ///< [m]
    double low;                ///< [m]
    double high;               ///< [m]
    Row row;
    /// True if the entity is upright and the cylinder is exactly that of its model, so the model's silhouettes are at
    /// their heights. False if the cylinder contains the sphere around the entity.
    bool is_upright;

    /// Whether it meets the sphere: the test of `collect`, for callers that keep outlines themselves.
    bool meets(const Eigen::Vector3d& centre, double sphere_radius) const {
      const double reach = sphere_radius + radius;
      return (position - centre.head<2>()).squaredNorm() <= reach * reach && low <= centre.z() + sphere_radius &&
             high >= centre.z() - sphere_radius;
    }
  };
  /// An entity that is wider than a cell, such as a wall: a box bounds it better.
  struct LargeOutline {
    Eigen::AlignedBox3d bounds;  ///< in W [m]
    Row row;

    /// The same for the box.
    bool meets(const Eigen::Vector3d& centre, double sphere_radius) const {
      return bounds.squaredExteriorDistance(centre) <= sphere_radius * sphere_radius;
    }
  };
  /// Position of an entity in the index until the next rebuild, from 0 to placeCount() - 1. Neighbours mostly have
  /// adjacent places, so data kept by place is read faster than data kept by row.
  using Place = std::uint32_t;

  /// Whether entities of a model are large.
  bool isLarge(const EntityModel& model) const { return model.moving_reach > cell_size_; }
  /// Number of places. Large entities have no place.
  std::size_t placeCount() const {
    refresh();
    return items_.size();
  }
  /// @pre the place was obtained after the last rebuild
  const Outline& at(Place place) const { return items_[place]; }
  const std::vector<LargeOutline>& large() const {
    refresh();
    return large_items_;
  }
  /// Margin [m] for rays: engines with a vertical plane cast rays against prisms, whose corners may be outside the
  /// outlines by up to this margin. A caller that collects obstacles of a ray enlarges its sphere by it.
  double prismMargin() const {
    refresh();
    return (M_SQRT2 - 1.0) * largest_small_radius_;
  }
  /// Appends the places of all entities that are not large and whose outlines meet the sphere, in no stated order.
  void collectPlaces(const Eigen::Vector3d& centre, double radius, std::vector<Place>& found) const;

  /// Entities whose origin is within `radius` of `centre`, by entity number.
  std::vector<Row> within(const Entities& entities, const Eigen::Vector3d& centre, double radius) const;
  /// The same around an entity, without itself.
  std::vector<Row> within(const Entities& entities, Row around, double radius) const;

 private:
  using Cell = std::array<int, 3>;

  enum class State {
    kAsked,    ///< up to date, and queried since the rebuild
    kRebuilt,  ///< up to date
    kOld,      ///< out of date
    kClosed    ///< out of date, and poses are changing
  };

  /// Called before each query.
  void refresh() const {
    if (state_.load(std::memory_order_acquire) != State::kAsked) {
      refreshOnce();
    }
  }
  void refreshOnce() const;
  void sortIn(const Entities& entities) const;
  void sortLargeIn() const;
  static Outline outlineOf(const Entities& entities, Row row);
  Cell cellOf(const Eigen::Vector3d& position) const;
  std::size_t flat(const Cell& cell) const;
  template <class Visit>  // visit(Row)
  void visitNear(const Eigen::Vector3d& centre, double radius, Visit visit) const;
  template <class Visit>  // visit(Place) for all in cells that a box may meet; @param reach half size of the box [m]
  void visitPlaces(const Eigen::Vector3d& centre, const Eigen::Vector3d& reach, Visit visit) const;
  // visit(Place, double square of the distance) for later places whose axes are within `distance`
  template <class Visit>
  void visitLaterNear(const Cell& cell, Place place, double distance, Visit visit) const;

  Eigen::Vector3d corner_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d size_ = Eigen::Vector3d::Ones();
  Optimization optimization_ = Optimization::k2D;
  double cell_size_ = 1.0;
  double inverse_cell_size_ = 1.0;
  Cell cells_{1, 1, 1};

  // Derived from the entities on demand; mutable, since a const query may rebuild it.
  mutable std::atomic<State> state_{State::kRebuilt};
  mutable std::mutex mutex_;  // serialises the first queries
  const Entities* entities_ = nullptr;
  bool was_asked_ = false;                         // queried before `close`
  mutable double largest_small_radius_ = 0.0;      // among the items of the cells
  mutable std::vector<std::uint32_t> first_item_;  // by cell; one more than there are cells
  mutable std::vector<Outline> items_;             // sorted by cell
  mutable std::vector<std::uint32_t> cell_of_entity_;
  mutable std::vector<LargeOutline> large_items_;  // not in the cells
  mutable BoxGrid large_grid_;                     // of large_items_, by index
};

}  // namespace swarmanoid
