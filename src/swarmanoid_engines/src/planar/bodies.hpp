/// Bodies of a planar engine: their poses, their shapes in the plane, and queries for neighbours.
///
/// The index of a body stays the same as long as the body is in the engine. Threads: const functions may run
/// concurrently.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "common/turret.hpp"
#include "planar/cell_grid.hpp"
#include "planar/placed_pose.hpp"
#include "planar/planar_model.hpp"
#include "swarmanoid_space/index/box_grid.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::planar {

using BodyIndex = std::int32_t;
constexpr BodyIndex kNoBody = -1;

/// The data of a body that every step reads. Kept to two cache lines, since there may be many bodies.
struct alignas(64) Body {
  PlacedPose pose;

  // Command of its drive in this tick, see readCommands.
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< at heading 0 [m/s]
  double turn_rate = 0.0;                              ///< [rad/s]

  double along = 0.0;  ///< coordinate of the origin along the plane's normal [m]
  const PlanarModel* model = nullptr;
  const EntityModel* entity = nullptr;
  EntityNumber number = kNoEntity;
  Row row = kNoRow;

  // Its commanded mechanisms.
  int gripper = -1;  ///< index of the holder; -1 if none
  bool is_wheeled = false;
  bool flies = false;

  bool isDriven() const { return is_wheeled || flies; }
  bool isCommandedToStand() const { return turn_rate == 0.0 && velocity.isZero(0.0); }

  bool is_movable = false;
  bool is_large = false;   ///< too wide for the grid, such as a wall
  bool has_moved = false;  ///< since the start of the tick
  /// Set for mirrors: rays hit the entity in the engine that moves it, which has its current pose.
  bool is_seen_elsewhere = false;
  Role role = Role::kMove;
};
static_assert(sizeof(Body) == 128);

/// The projection of a single body, made once its base changes or a joint turns some of its shapes.
struct OwnProjection {
  PlanarModel model;
  std::vector<JointState> joints;  ///< of the entity's model; only their angles count
};

/// The data of a body that is read less often.
struct BodyDetails {
  std::shared_ptr<const EntityModel> entity;
  std::shared_ptr<const PlanarModel> shared_model;  ///< of all bodies with that entity model and base; joints at zero
  std::unique_ptr<OwnProjection> own;
  Eigen::Quaterniond base = Eigen::Quaterniond::Identity();
};

/// A commanded turret of a body whose z axis is along the normal.
struct Turret {
  BodyIndex body = kNoBody;
  JointCommand command;  ///< of this tick
  int joint = -1;        ///< of the entity's model
  double sense = 1.0;    ///< -1 if a left turn of the joint is a right turn in the plane
  JointState state;
  double angle_at_start = 0.0;  ///< of the tick [rad]
  PlanarPose held;              ///< pose of the gripped body in the turret's frame, from the moment of gripping
};

class Bodies {
 public:
  void configure(const Plane& plane) { plane_ = plane; }

  BodyIndex add(const Space& space, Row row, Role role);
  void remove(BodyIndex index);
  void clear();
  /// Copies the entity's pose and joints from the space. @return whether its shapes changed
  bool place(const Space& space, BodyIndex index);
  /// The projection of a model with a base, if the last body by entity number has the same; else null. Groups of equal
  /// entities are placed one after the other, and try many places.
  const PlanarModel* projectionOfLast(const EntityModel& model, const Eigen::Quaterniond& base) const;
  /// Saves or loads poses, shapes and turrets, for snapshots. @pre when it loads, the bodies are those of the same
  /// entities; their indices may differ
  void archive(StateArchive& state);
  /// Saves or loads the index of a body, or kNoBody.
  void archiveIndex(StateArchive& state, BodyIndex& index) const {
    Row row = index == kNoBody ? kNoRow : (*this)[index].row;
    state(row);
    index = find(row);
  }
  void setPose(BodyIndex index, const PlacedPose& pose);
  /// As setPose, without updating the grid: bodies for which isInOtherCell then holds need `refreshCell` before the
  /// next query of neighbours. Threads: may run concurrently for different bodies. @pre the body is not large
  void setPoseOnly(BodyIndex index, const PlacedPose& pose) {
    Body& body = (*this)[index];
    body.pose = pose;
    body.has_moved = true;
    circles_[static_cast<std::size_t>(index)].centre = pose.position;
  }
  /// @pre the body is not large
  bool isInOtherCell(BodyIndex index) const {
    const Body& body = (*this)[index];
    return grid_.isElsewhere(index, body.pose.position);
  }
  void refreshCell(BodyIndex index) { grid_.move(index, (*this)[index].pose.position); }

  /// Called before each tick.
  void readTurretCommands(const Space& space);
  /// Sorted by entity number.
  std::vector<Turret>& turrets() { return turrets_; }
  /// Null if the body has no turret.
  Turret* findTurret(BodyIndex index);
  const Turret* findTurret(BodyIndex index) const;
  const EntityModel::Joint& jointOf(const Turret& turret) const {
    return (*this)[turret.body].entity->joints[static_cast<std::size_t>(turret.joint)];
  }
  /// The body's model with its turret at that angle; valid until the next call.
  const PlanarModel& modelAt(const Turret& turret, double angle);
  /// Turns the shapes of the turret's body to that angle; does not change `state`.
  void turnShapes(const Turret& turret, double angle);
  /// Angle that the shapes are turned to [rad].
  double shapesAngle(const Turret& turret) const;

  /// Circle around a body, for the first test of neighbours. Stored apart from Body because it is read most.
  struct Circle {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double radius = 0.0;
  };
  const Circle& circle(BodyIndex index) const { return circles_[static_cast<std::size_t>(index)]; }

  BodyIndex find(Row row) const { return index_of_row_.has(row) ? index_of_row_[row] : kNoBody; }
  Body& operator[](BodyIndex index) { return bodies_[static_cast<std::size_t>(index)]; }
  const Body& operator[](BodyIndex index) const { return bodies_[static_cast<std::size_t>(index)]; }
  /// Bodies of the engine, by entity number.
  const std::vector<BodyIndex>& order() const { return order_; }
  const Plane& plane() const { return plane_; }

  BodyDetails& details(BodyIndex index) { return details_[static_cast<std::size_t>(index)]; }
  const BodyDetails& details(BodyIndex index) const { return details_[static_cast<std::size_t>(index)]; }

  /// Bounding box of a wall, which is a large body that does not move. Null for other bodies.
  const Eigen::AlignedBox2d* boundsOfWall(BodyIndex index) const {
    const Body& body = (*this)[index];
    return body.is_large && !body.is_movable ? &walls_.bounds(index) : nullptr;
  }
  /// Whether the circle around a body is farther away from a point than `distance`. Rejects distant bodies without
  /// reading Body.
  bool isFartherThan(BodyIndex index, const Eigen::Vector2d& point, double distance) const {
    const Circle& around = circle(index);
    const double reach = around.radius + distance;
    return (around.centre - point).squaredNorm() > reach * reach;
  }
  /// Distance from a point to the circle around a body, or to the bounding box of a wall; below 0 inside the circle, 0
  /// inside the box.
  double distanceTo(BodyIndex index, const Eigen::Vector2d& point) const {
    const Eigen::AlignedBox2d* bounds = boundsOfWall(index);
    const Body& body = (*this)[index];
    return bounds == nullptr ? (body.pose.position - point).norm() - body.model->radius
                             : bounds->exteriorDistance(point);
  }

  /// Calls visit(index) for all bodies whose circle may overlap the given one, until it returns false.
  template <class Visit>
  void visitNear(const Eigen::Vector2d& centre, double radius, Visit visit) const {
    for (const BodyIndex index : large_) {
      const Circle& circle = circles_[static_cast<std::size_t>(index)];
      const double reach = radius + circle.radius;
      if ((circle.centre - centre).squaredNorm() <= reach * reach && !visit(index)) {
        return;
      }
    }
    if (!walls_.visitNear(centre, radius, visit)) {
      return;
    }
    grid_.visitNear(centre, radius + largest_radius_, [&](BodyIndex index) {
      const Circle& circle = circles_[static_cast<std::size_t>(index)];
      const double reach = radius + circle.radius;
      return (circle.centre - centre).squaredNorm() > reach * reach || visit(index);
    });
  }

 private:
  std::shared_ptr<const PlanarModel> project(const std::shared_ptr<const EntityModel>& entity,
                                             const Eigen::Quaterniond& base) const;
  void findMechanisms(const Space& space, BodyIndex index);
  void findTurret(const Space& space, BodyIndex index);
  bool haveJointsTurned(const Space& space, BodyIndex index) const;
  OwnProjection& ownProjection(BodyIndex index);
  void takeProjection(BodyIndex index);
  void archiveProjection(StateArchive& state, BodyIndex index);
  /// For walls, which do not move.
  Eigen::AlignedBox2d boundsOf(const Body& body);

  Plane plane_;
  std::vector<Body> bodies_;
  std::vector<BodyDetails> details_;  // by body
  std::vector<Circle> circles_;       // by body
  std::vector<BodyIndex> holes_;
  std::vector<BodyIndex> order_;
  RowMap<BodyIndex> index_of_row_;
  std::vector<BodyIndex> large_;  // large bodies that move: every query tests each of them
  BoxGrid walls_;                 // large bodies that do not move
  std::vector<Turret> turrets_;
  OwnProjection tried_;                     // scratch of modelAt
  std::vector<PlanarShape> placed_shapes_;  // scratch of boundsOf
  CellGrid grid_;
  double largest_radius_ = 0.0;  // of bodies in the grid
};

}  // namespace swarmanoid::planar
