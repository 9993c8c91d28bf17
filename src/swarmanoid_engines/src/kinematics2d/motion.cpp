// Phase `move`: velocities to poses, and no pose that overlaps.
#include <cmath>

#include "kinematics2d/kinematics2d.hpp"
#include "planar/planar_overlap.hpp"

namespace swarmanoid::kinematics2d {

PlacedPose integrate(const PlacedPose& start, const Eigen::Vector2d& velocity, double turn_rate, double dt) {
  const double turn = turn_rate * dt;
  if (turn == 0.0) {
    PlacedPose end = start;
    end.position += dt * start.rotated(velocity);
    return end;
  }
  // the chord of an arc: as long as the arc times sin(a)/a, turned by a, with a half the turn
  const double half = 0.5 * turn;
  const double cosine = std::cos(half);
  const double sine = std::sin(half);
  const double shortening = std::abs(half) < 1e-4 ? 1.0 - half * half / 6.0 : sine / half;
  const Eigen::Vector2d chord(cosine * velocity.x() - sine * velocity.y(), sine * velocity.x() + cosine * velocity.y());
  return PlacedPose::at(start.position + dt * shortening * start.rotated(chord),
                        planar::wrapAngle(start.heading + turn));
}

void Kinematics2d::move(Space& space, Duration dt) {
  startTick(space);
  const double step = toSeconds(dt) / subclock_;
  for (int i = 0; i < subclock_; ++i) {
    for (const BodyIndex index : bodies_.order()) {
      moveBody(index, step);
    }
  }
  finishTick(space, toSeconds(dt));
}

void Kinematics2d::startTick(const Space& space) {
  bodies_.findLateDevices(space);
  for (const BodyIndex index : bodies_.order()) {
    Body& body = bodies_[index];
    if (body.role == Role::kMirror && body.is_movable) {
      bodies_.place(space, index);
    }
    body.pose_at_start = body.pose;
    body.has_moved = false;
  }
}

void Kinematics2d::moveBody(BodyIndex index, double dt) {
  const Body& body = bodies_[index];
  if (body.role == Role::kMirror || (body.wheels == nullptr && body.velocity == nullptr)) {
    return;
  }
  const PlanarModel& model = *body.model;
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // at heading 0
  double turn_rate = 0.0;
  if (body.wheels != nullptr) {
    const EntityModel::Wheels& geometry = *body.entity->wheels;
    velocity = 0.5 * (body.wheels->left + body.wheels->right) * geometry.radius * model.ahead;
    turn_rate = (body.wheels->right - body.wheels->left) * geometry.radius / geometry.separation * model.turn;
  } else {
    const Eigen::Vector3d& linear = body.velocity->linear;
    velocity = linear.x() * model.ahead + linear.y() * model.left + linear.z() * model.up;
    turn_rate = body.velocity->yaw_rate * model.turn;
  }
  if (turn_rate == 0.0 && velocity.isZero(0.0)) {
    return;
  }
  const PlacedPose target = integrate(body.pose, velocity, turn_rate, dt);
  if (tryPose(index, target) || turn_rate == 0.0) {
    return;
  }
  // blocked: a robot that can still turn finds its way out
  PlacedPose turned = target;
  turned.position = body.pose.position;
  tryPose(index, turned);
}

bool Kinematics2d::tryPose(BodyIndex index, const PlacedPose& pose) {
  const BodyIndex gripped = bodies_[index].gripped;
  if (!isFree(index, pose, gripped)) {
    return false;
  }
  if (gripped != kNoBody) {
    const PlanarPose& place = bodies_.details(gripped).place_in_gripper;
    const PlacedPose carried =
        PlacedPose::at(pose.position + pose.rotated(place.position), planar::wrapAngle(pose.heading + place.heading));
    if (!isFree(gripped, carried, index)) {
      return false;
    }
    bodies_.setPose(gripped, carried);
  }
  bodies_.setPose(index, pose);
  return true;
}

bool Kinematics2d::isFree(BodyIndex index, const PlacedPose& pose, BodyIndex partner) {
  const Body& body = bodies_[index];
  bool free = true;
  bodies_.visitNear(pose.position, body.model->radius, [&](BodyIndex other_index) {
    if (other_index == index || other_index == partner) {
      return true;
    }
    const Body& other = bodies_[other_index];
    if (!modelsOverlap(*body.model, pose, body.along, other, relative_shapes_)) {
      return true;
    }
    // a mirror was put upon us: moving away from it must stay possible
    const bool goes_away =
        (pose.position - other.pose.position).squaredNorm() > (body.pose.position - other.pose.position).squaredNorm();
    if (other.role == Role::kMirror && other.is_movable && goes_away &&
        modelsOverlap(*body.model, body.pose, body.along, other, relative_shapes_)) {
      return true;
    }
    free = false;
    return false;
  });
  return free;
}

bool modelsOverlap(const PlanarModel& model, const PlacedPose& pose, double along, const Body& other,
                   std::vector<PlanarShape>& scratch) {
  if (!model.band.meets(other.model->band, along, other.along)) {
    return false;
  }
  // in the other's frame only one of the two models has to be placed
  const Eigen::Vector2d way = pose.position - other.pose.position;
  const double cosine = other.pose.cosine;
  const double sine = other.pose.sine;
  planar::placeShapes(model, {cosine * way.x() + sine * way.y(), cosine * way.y() - sine * way.x()},
                      pose.cosine * cosine + pose.sine * sine, pose.sine * cosine - pose.cosine * sine, scratch);
  for (std::size_t i = 0; i < model.shapes.size(); ++i) {
    const PlanarShape& mine = scratch[i];
    for (const PlanarShape& its : other.model->shapes) {
      if (mine.band.meets(its.band, along, other.along) && planar::overlap(mine, its)) {
        return true;
      }
    }
  }
  return false;
}

void Kinematics2d::finishTick(Space& space, double dt) {
  const planar::Plane& plane = bodies_.plane();
  for (const BodyIndex index : bodies_.order()) {
    Body& body = bodies_[index];
    if (body.role == Role::kMirror || !body.is_movable) {
      continue;
    }
    const auto i = static_cast<std::size_t>(body.row);
    Twist& twist = space.entities.twist[i];
    if (!body.has_moved) {
      twist = Twist{};
      continue;
    }
    space.entities.pose[i].position = plane.toGlobal(body.pose.position, body.along);
    if (body.pose.heading != body.pose_at_start.heading) {
      space.entities.pose[i].orientation = plane.orientation(body.pose.heading, bodies_.details(index).base);
    }
    twist.linear = plane.toGlobal((body.pose.position - body.pose_at_start.position) / dt, 0.0);
    twist.angular = plane.normal() * (planar::wrapAngle(body.pose.heading - body.pose_at_start.heading) / dt);
  }
}

}  // namespace swarmanoid::kinematics2d
