/// The bodies of a planar engine: where they are, what they look like in the plane, what is near what.
///
/// A body's index stays as long as it is in the engine. Threads: const functions may run at once.
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

/// What is looked at in every step; kept small, since there may be many: two cache lines.
struct alignas(64) Body {
  PlacedPose pose;

  // What its drive is commanded in this tick: see readCommands.
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< at heading 0 [m/s]
  double turn_rate = 0.0;                              ///< [rad/s]

  double along = 0.0;  ///< of the origin, along the plane's normal [m]
  const PlanarModel* model = nullptr;
  const EntityModel* entity = nullptr;
  EntityNumber number = kNoEntity;
  Row row = kNoRow;

  // Which of its mechanisms are commanded.
  int gripper = -1;  ///< index of the holder; -1: none
  bool is_wheeled = false;
  bool flies = false;

  bool isDriven() const { return is_wheeled || flies; }
  bool isCommandedToStand() const { return turn_rate == 0.0 && velocity.isZero(0.0); }

  bool is_movable = false;
  bool is_large = false;   ///< wider than what the grid is for, such as a wall
  bool has_moved = false;  ///< since the start of the tick
  /// A mirror: rays hit the entity in the engine that moves it, where it is up to date.
  bool is_seen_elsewhere = false;
  Role role = Role::kMove;
};
static_assert(sizeof(Body) == 128);

/// A body's own projection, once its base has changed or a joint has turned some of its shapes.
struct OwnProjection {
  PlanarModel model;
  std::vector<JointState> joints;  ///< of the entity's model; only their angles count
};

/// What is looked at now and then.
struct BodyDetails {
  std::shared_ptr<const EntityModel> entity;
  std::shared_ptr<const PlanarModel> shared_model;  ///< of all bodies with that entity model and base, joints at zero
  std::unique_ptr<OwnProjection> own;
  Eigen::Quaterniond base = Eigen::Quaterniond::Identity();
};

/// The turret of a body that is commanded, and has its body z axis along the normal.
struct Turret {
  BodyIndex body = kNoBody;
  JointCommand command;  ///< of this tick
  int joint = -1;        ///< of the entity's model
  double sense = 1.0;    ///< -1 where a turn to the left is one to the right in the plane
  JointState state;
  double angle_at_start = 0.0;  ///< of the tick [rad]
  PlanarPose held;              ///< what the gripper holds, in the turret's frame, from the moment of gripping
};

class Bodies {
 public:
  void configure(const Plane& plane) { plane_ = plane; }

  BodyIndex add(const Space& space, Row row, Role role);
  void remove(BodyIndex index);
  void clear();
  /// Takes the pose that the entity has in the space, and its joints. @return whether its shapes are others now
  bool place(const Space& space, BodyIndex index);
  void setPose(BodyIndex index, const PlacedPose& pose);
  /// The same but for the look-up of what is near: whoever then isInOtherCell is brought up to date by `refreshCell`
  /// before anybody looks. Threads: may be called at once for different bodies. @pre it is not large
  void setPoseOnly(BodyIndex index, const PlacedPose& pose) {
    Body& body = (*this)[index];
    body.pose = pose;
    body.has_moved = true;
    circles_[static_cast<std::size_t>(index)].centre = pose.position;
  }
  /// @pre it is not large
  bool isInOtherCell(BodyIndex index) const {
    const Body& body = (*this)[index];
    return grid_.isElsewhere(index, body.pose.position);
  }
  void refreshCell(BodyIndex index) { grid_.move(index, (*this)[index].pose.position); }

  /// Before each tick.
  void readTurretCommands(const Space& space);
  /// By entity number.
  std::vector<Turret>& turrets() { return turrets_; }
  /// Null if it has none.
  Turret* findTurret(BodyIndex index);
  const Turret* findTurret(BodyIndex index) const;
  const EntityModel::Joint& jointOf(const Turret& turret) const {
    return (*this)[turret.body].entity->joints[static_cast<std::size_t>(turret.joint)];
  }
  /// What the body would look like with its turret at that angle; valid until the next call.
  const PlanarModel& modelAt(const Turret& turret, double angle);
  /// Turns the shapes of the turret's body to that angle. Its `state` is left alone.
  void turnShapes(const Turret& turret, double angle);
  /// To what angle they are turned.
  double shapesAngle(const Turret& turret) const;

  /// Around a body: what neighbours are sorted out by, apart from the rest because it is read most.
  struct Circle {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double radius = 0.0;
  };
  const Circle& circle(BodyIndex index) const { return circles_[static_cast<std::size_t>(index)]; }

  BodyIndex find(Row row) const { return index_of_row_.has(row) ? index_of_row_[row] : kNoBody; }
  Body& operator[](BodyIndex index) { return bodies_[static_cast<std::size_t>(index)]; }
  const Body& operator[](BodyIndex index) const { return bodies_[static_cast<std::size_t>(index)]; }
  /// Living bodies, by entity number.
  const std::vector<BodyIndex>& order() const { return order_; }
  const Plane& plane() const { return plane_; }

  BodyDetails& details(BodyIndex index) { return details_[static_cast<std::size_t>(index)]; }
  const BodyDetails& details(BodyIndex index) const { return details_[static_cast<std::size_t>(index)]; }

  /// The box around a wall: what is large, and does not move. Null for all else.
  const Eigen::AlignedBox2d* boundsOfWall(BodyIndex index) const {
    const Body& body = (*this)[index];
    return body.is_large && !body.is_movable ? &walls_.bounds(index) : nullptr;
  }
  /// Whether the circle around a body is farther from a point than that: so what is far is sorted out before the body
  /// itself is read.
  bool isFartherThan(BodyIndex index, const Eigen::Vector2d& point, double distance) const {
    const Circle& around = circle(index);
    const double reach = around.radius + distance;
    return (around.centre - point).squaredNorm() > reach * reach;
  }
  /// From a point to a circle around a body, or to a box around a wall; below 0 if inside.
  double distanceTo(BodyIndex index, const Eigen::Vector2d& point) const {
    const Eigen::AlignedBox2d* bounds = boundsOfWall(index);
    const Body& body = (*this)[index];
    return bounds == nullptr ? (body.pose.position - point).norm() - body.model->radius
                             : bounds->exteriorDistance(point);
  }

  /// Calls visit(index) for all bodies whose surrounding circle may meet the given one, until it returns false.
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
  /// Projections are shared among equal models.
  struct Projection {
    std::weak_ptr<const EntityModel> entity;
    Eigen::Quaterniond base;
    std::weak_ptr<const PlanarModel> model;
  };

  std::shared_ptr<const PlanarModel> project(const std::shared_ptr<const EntityModel>& entity,
                                             const Eigen::Quaterniond& base);
  void findMechanisms(const Space& space, BodyIndex index);
  void findTurret(const Space& space, BodyIndex index);
  bool haveJointsTurned(const Space& space, BodyIndex index) const;
  OwnProjection& ownProjection(BodyIndex index);
  void takeProjection(BodyIndex index);
  /// Of what does not move.
  Eigen::AlignedBox2d boundsOf(const Body& body);

  Plane plane_;
  std::vector<Body> bodies_;
  std::vector<BodyDetails> details_;  // by body
  std::vector<Circle> circles_;       // by body
  std::vector<BodyIndex> holes_;
  std::vector<BodyIndex> order_;
  RowMap<BodyIndex> index_of_row_;
  std::vector<BodyIndex> large_;  // of those that move: looked at one by one
  BoxGrid walls_;                 // large ones that do not
  std::vector<Turret> turrets_;
  OwnProjection tried_;                     // scratch of modelAt
  std::vector<PlanarShape> placed_shapes_;  // scratch of boundsOf
  std::vector<Projection> projections_;
  CellGrid grid_;
  double largest_radius_ = 0.0;  // of bodies in the grid
};

}  // namespace swarmanoid::planar
