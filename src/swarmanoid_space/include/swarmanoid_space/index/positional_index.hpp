/// Finds entities by place (thesis 3.4, "positional information").
///
/// A grid of cells over the arena instead of the thesis's oct-tree: a query costs what is near, whatever the number of
/// entities, and the whole index is rebuilt in time linear in that number: each tick where somebody asks, else not at
/// all. optimization="2D" keeps columns (one cell in z), "3D" keeps cubes. What has left the arena is kept in the
/// border cells, so nothing is ever lost.
///
/// Phase   updated in `index`, and between ticks when entities come, go or are moved. Not to be asked from `move` to
///         `connect`, while poses are under way.
/// Threads queries are const, and safe from many threads.
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

  /// @param size of the arena [m] @param expected_entities picks the cell size @param corner of the arena, with its
  /// least coordinates [m]
  void configure(const Eigen::Vector3d& size, Optimization optimization, std::size_t expected_entities,
                 const Eigen::Vector3d& corner = Eigen::Vector3d::Zero());

  /// Reads every living entity's pose and bounds. No allocation once the number of entities is steady.
  void rebuild(const Entities& entities);
  /// Poses are under way from now on: nobody may ask until they are there.
  void close();
  /// Entities have moved: rebuilds the index if anybody has asked since it was rebuilt last. Else it is left to the
  /// first who asks, as `forget` does.
  void update(const Entities& entities);
  /// What the index holds counts no more: whoever asks next rebuilds it. @param entities stay, and stay as they are
  /// until then
  void forget(const Entities& entities);

  /// Entities whose bounds (an upright cylinder, or a box for large ones) meet the sphere around `centre`; appended to
  /// `found` in no stated order.
  void collect(const Eigen::Vector3d& centre, double radius, std::vector<Row>& found) const;
  /// The same for an upright cylinder without ends: whatever is within a distance of its axis, at any height.
  void collectUpright(const Eigen::Vector2d& axis, double radius, std::vector<Row>& found) const;

  // For questions of many at once, without a list of who is found; defined in index/positional_index_visits.hpp.

  /// Of those that are large: visit(const LargeOutline&) of each whose box meets the sphere, until it returns false.
  template <class Visit>
  void visitLarge(const Eigen::Vector3d& centre, double radius, Visit visit) const;
  /// As collectUpright: visit(Row) of each.
  template <class Visit>
  void visitUpright(const Eigen::Vector2d& axis, double radius, Visit visit) const;
  /// Pairs of entities whose origins, seen from above, are at most `distance` from each other: visit(Row, Row, double
  /// square of their distance) once of each pair, in no stated order. Far cheaper than to ask around each of them.
  /// @param is_large_meant (Row) whether what is large may be one of a pair: walls mostly are not, and would cost
  template <class IsLargeMeant, class Visit>
  void visitPairs(const Entities& entities, double distance, IsLargeMeant is_large_meant, Visit visit) const;

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

  /// Whether entities of a model are large.
  bool isLarge(const EntityModel& model) const { return model.moving_reach > cell_size_; }
  /// Large ones have no place.
  std::size_t placeCount() const {
    refresh();
    return items_.size();
  }
  /// @pre whoever asks has got the place since the last rebuild
  const Outline& at(Place place) const { return items_[place]; }
  const std::vector<LargeOutline>& large() const {
    refresh();
    return large_items_;
  }
  /// Engines whose plane stands upright cast rays against prisms, whose corners are outside of outlines, though by no
  /// more than this [m]. Who collects what could stand in the way of a ray collects from a sphere larger by it.
  double prismMargin() const {
    refresh();
    return (M_SQRT2 - 1.0) * largest_small_radius_;
  }
  /// The places of those, not large, whose outlines meet the sphere; appended to `found` in no stated order.
  void collectPlaces(const Eigen::Vector3d& centre, double radius, std::vector<Place>& found) const;

  /// Entities whose origin is within `radius` of `centre`, by entity number.
  std::vector<Row> within(const Entities& entities, const Eigen::Vector3d& centre, double radius) const;
  /// The same around an entity, without itself.
  std::vector<Row> within(const Entities& entities, Row around, double radius) const;

 private:
  using Cell = std::array<int, 3>;

  enum class State {
    kAsked,    ///< holds where entities are, and somebody has asked
    kRebuilt,  ///< holds where entities are
    kOld,      ///< does not
    kClosed    ///< does not, and entities are on their way
  };

  /// Before each answer.
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
  template <class Visit>  // visit(Place), of all in cells that a box may meet; @param reach of the box each way [m]
  void visitPlaces(const Eigen::Vector3d& centre, const Eigen::Vector3d& reach, Visit visit) const;
  template <class Visit>  // visit(Place, double square of the distance), of later places whose axes are that near
  void visitLaterNear(const Cell& cell, Place place, double distance, Visit visit) const;

  Eigen::Vector3d corner_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d size_ = Eigen::Vector3d::Ones();
  Optimization optimization_ = Optimization::k2D;
  double cell_size_ = 1.0;
  double inverse_cell_size_ = 1.0;
  Cell cells_{1, 1, 1};

  // What follows from the entities, made when somebody asks: so a query, which is const, may write it.
  mutable std::atomic<State> state_{State::kRebuilt};
  mutable std::mutex mutex_;  // of those who ask first
  const Entities* entities_ = nullptr;
  bool was_asked_ = false;                         // when it was closed
  mutable double largest_small_radius_ = 0.0;      // among the items of the cells
  mutable std::vector<std::uint32_t> first_item_;  // by cell; one more than there are cells
  mutable std::vector<Outline> items_;             // sorted by cell
  mutable std::vector<std::uint32_t> cell_of_entity_;
  mutable std::vector<LargeOutline> large_items_;  // kept apart
  mutable BoxGrid large_grid_;                     // of them, by their place in that list
};

}  // namespace swarmanoid
