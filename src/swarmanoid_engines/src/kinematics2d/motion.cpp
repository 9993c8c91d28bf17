// Phase `move`: velocities to poses, and no pose that overlaps.
#include <algorithm>
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

void Kinematics2d::readMirrors(const Space& space) {
  mirrors_moved_ = 0.0;
  for (const BodyIndex index : bodies_.order()) {
    const Body& body = bodies_[index];
    if (body.role == Role::kMirror && body.is_movable) {
      const Eigen::Vector2d position = body.pose.position;
      const double radius = body.model->radius;
      bodies_.place(space, index);
      const double growth = std::max(0.0, body.model->radius - radius);
      mirrors_moved_ = std::max(mirrors_moved_, (body.pose.position - position).norm() + growth);
    }
  }
}

void Kinematics2d::move(Space& space, Duration dt) {
  const double step = toSeconds(dt) / subclock_;
  startTick(space, step);
  for (int i = 0; i < subclock_; ++i) {
    travelled_ += stride_;
    for (const BodyIndex index : bodies_.order()) {
      moveBody(index, step);
    }
  }
  finishTick(space, toSeconds(dt));
}

void Kinematics2d::startTick(const Space& space, double step) {
  bodies_.findLateDevices(space);
  double fastest_squared = 0.0;
  for (const BodyIndex index : bodies_.order()) {
    Body& body = bodies_[index];
    body.pose_at_start = body.pose;
    body.has_moved = false;
    if (body.role == Role::kMirror || (body.wheels == nullptr && body.flight == nullptr)) {
      continue;
    }
    readCommands(body);
    fastest_squared = std::max(fastest_squared, body.velocity.squaredNorm());
    if (body.gripped != kNoBody) {
      // what is gripped swings around its gripper
      const double arm = bodies_.details(body.gripped).place_in_gripper.position.norm();
      const double speed = body.velocity.norm() + arm * std::abs(body.turn_rate);
      fastest_squared = std::max(fastest_squared, speed * speed);
    }
  }
  stride_ = std::sqrt(fastest_squared) * step;
  travelled_ += mirrors_moved_;
  constexpr double kMostTravelled = 1e6;  // m: beyond, sums would be rounded too much
  if (is_somebody_new_ || !(travelled_ < kMostTravelled)) {
    for (const BodyIndex index : bodies_.order()) {
      bodies_[index].clearance = Clearance{};
    }
    travelled_ = 0.0;
    is_somebody_new_ = false;
  }
}

void Kinematics2d::readCommands(Body& body) {
  const PlanarModel& model = *body.model;
  if (body.wheels != nullptr) {
    const EntityModel::Wheels& geometry = *body.entity->wheels;
    body.velocity = 0.5 * (body.wheels->left + body.wheels->right) * geometry.radius * model.ahead;
    body.turn_rate = (body.wheels->right - body.wheels->left) * geometry.radius / geometry.separation * model.turn;
  } else {
    const Eigen::Vector3d& linear = body.flight->linear;
    body.velocity = linear.x() * model.ahead + linear.y() * model.left + linear.z() * model.up;
    body.turn_rate = body.flight->yaw_rate * model.turn;
  }
}

void Kinematics2d::moveBody(BodyIndex index, double dt) {
  const Body& body = bodies_[index];
  if (body.turn_rate == 0.0 && body.velocity.isZero(0.0)) {
    return;
  }
  const PlacedPose target = integrate(body.pose, body.velocity, body.turn_rate, dt);
  if (tryPose(index, target) || body.turn_rate == 0.0) {
    return;
  }
  // blocked: a robot that can still turn finds its way out
  PlacedPose turned = target;
  turned.position = body.pose.position;
  tryPose(index, turned);
}

bool Kinematics2d::tryPose(BodyIndex index, const PlacedPose& pose) {
  Body& body = bodies_[index];
  const BodyIndex gripped = body.gripped;
  if (gripped == kNoBody && travelled_ <= body.clearance.free_until) {
    bodies_.setPose(index, pose);
    return true;
  }
  Clearance clearance = body.clearance;
  if (!isFree(index, pose, gripped, clearance)) {
    return false;
  }
  if (gripped != kNoBody) {
    const PlanarPose& place = bodies_.details(gripped).place_in_gripper;
    const PlacedPose carried =
        PlacedPose::at(pose.position + pose.rotated(place.position), planar::wrapAngle(pose.heading + place.heading));
    Clearance unused;
    unused.look_ahead = 0.0;
    if (!isFree(gripped, carried, index, unused)) {
      return false;
    }
    bodies_.setPose(gripped, carried);
    clearance.free_until = -1.0;  // what is gripped was left out, and is near once it is let go
  }
  body.clearance = clearance;
  bodies_.setPose(index, pose);
  return true;
}

bool Kinematics2d::isFree(BodyIndex index, const PlacedPose& pose, BodyIndex partner, Clearance& clearance) {
  const Body& body = bodies_[index];
  const double radius = body.model->radius;
  double nearest = clearance.look_ahead;
  bool free = true;
  clearance.at_all_heights = true;
  bodies_.visitNear(pose.position, radius + nearest, [&](BodyIndex other_index) {
    if (other_index == index || other_index == partner) {
      return true;
    }
    const Body& other = bodies_[other_index];
    const bool keeps_height = other.role == Role::kMove || !other.is_movable;
    if (keeps_height && !body.model->band.meets(other.model->band, body.along, other.along)) {
      clearance.at_all_heights = false;
      return true;
    }
    const double gap = bodies_.distanceTo(other_index, pose.position) - radius;
    nearest = std::min(nearest, gap);
    if (gap > 0.0 || !modelsOverlap(*body.model, pose, body.along, other, relative_shapes_)) {
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
  // From now on both sides come nearer by what is travelled; some bodies have this step's stride still before them.
  constexpr double kMargin = 1e-6;  // m, for rounding
  clearance.free_until = travelled_ + 0.5 * (nearest - stride_ - kMargin);
  clearance.look_ahead = std::min(Clearance::kMostLookAhead, 2.0 * (std::max(0.0, nearest) + stride_));
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
