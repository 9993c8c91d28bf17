#include "planar/bodies.hpp"

#include <algorithm>
#include <cmath>

#include "common/grips.hpp"
#include "swarmanoid_space/models/shared_by_model.hpp"

namespace swarmanoid::planar {
namespace {
constexpr double kLargeRadius = 0.4;  // m: wider bodies would widen every query of the grid

bool areSame(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) { return a.coeffs() == b.coeffs(); }
}  // namespace

std::shared_ptr<const PlanarModel> Bodies::project(const std::shared_ptr<const EntityModel>& entity,
                                                   const Eigen::Quaterniond& base) const {
  struct Key {
    Eigen::Vector3d normal;
    Eigen::Quaterniond base;

    bool operator==(const Key& other) const { return normal == other.normal && areSame(base, other.base); }
  };
  static SharedByModel<Key, PlanarModel> shared;
  return shared.get(entity, {plane_.normal(), base}, [&] {
    PlanarModel model;
    projectModel(*entity, plane_, base, model);
    return model;
  });
}

const PlanarModel* Bodies::projectionOfLast(const EntityModel& model, const Eigen::Quaterniond& base) const {
  const BodyDetails* last = order_.empty() ? nullptr : &details(order_.back());
  return last != nullptr && last->entity.get() == &model && !last->own && areSame(last->base, base)
             ? last->shared_model.get()
             : nullptr;
}

void Bodies::findMechanisms(const Space& space, BodyIndex index) {
  Body& body = (*this)[index];
  body.is_wheeled = body.entity->wheels && space.wheels[body.row].is_driven;
  body.flies = space.flight[body.row].is_driven;
  body.gripper = commandedGripper(space, body.row);
  findTurret(space, index);
}

BodyIndex Bodies::add(const Space& space, Row row, Role role) {
  if (order_.empty()) {
    grid_.configure(plane_.toLocal(space.corner), plane_.toLocal(space.size));
    walls_.configure(plane_.toLocal(space.corner), plane_.toLocal(space.size));
  }
  auto index = static_cast<BodyIndex>(bodies_.size());
  if (holes_.empty()) {
    bodies_.emplace_back();
    details_.emplace_back();
    circles_.emplace_back();
  } else {
    index = holes_.back();
    holes_.pop_back();
  }
  BodyDetails& record = details(index);
  record = BodyDetails{};
  record.entity = space.entities.model[row];
  record.base = plane_.baseOf(space.entities.pose[row].orientation);
  record.shared_model = project(record.entity, record.base);

  Body& body = (*this)[index];
  body = Body{};
  body.row = row;
  body.number = space.entities.number[row];
  body.role = role;
  body.model = record.shared_model.get();
  body.entity = record.entity.get();
  body.is_movable = record.entity->is_movable;
  body.is_large = body.model->radius > kLargeRadius;
  findMechanisms(space, index);

  index_of_row_.fit(row, kNoBody) = index;
  // the mirror of an older entity may be added later: the order is by number, not by arrival
  order_.insert(std::upper_bound(order_.begin(), order_.end(), index,
                                 [&](BodyIndex a, BodyIndex b) { return (*this)[a].number < (*this)[b].number; }),
                index);
  circles_[static_cast<std::size_t>(index)].radius = body.model->radius;
  if (body.is_large) {
    if (body.is_movable) {
      large_.push_back(index);
    }
  } else {
    largest_radius_ = std::max(largest_radius_, body.model->radius);
    grid_.add(index, plane_.toLocal(space.entities.pose[row].position));
  }
  place(space, index);
  return index;
}

bool Bodies::place(const Space& space, BodyIndex index) {
  Body& body = (*this)[index];
  BodyDetails& record = details(index);
  const Pose& pose = space.entities.pose[body.row];
  body.along = plane_.along(pose.position);
  const Eigen::Quaterniond base = plane_.baseOf(pose.orientation);
  const bool has_changed = !areSame(base, record.base) || haveJointsTurned(space, index);
  if (has_changed) {
    // not shared: the base of a rocking mirror changes every tick
    record.base = base;
    const Span<const JointState> joints = space.joints[body.row];
    std::copy(joints.begin(), joints.end(), ownProjection(index).joints.begin());
    takeProjection(index);
  }
  if (Turret* turret = findTurret(index)) {
    turret->state = space.joints[body.row][turret->joint];
  }
  setPose(index, PlacedPose::at(plane_.toLocal(pose.position), plane_.headingOf(pose.orientation)));
  body.has_moved = false;
  body.is_seen_elsewhere = body.role == Role::kMirror && space.mover[body.row] != nullptr;
  return has_changed;
}

void Bodies::setPose(BodyIndex index, const PlacedPose& pose) {
  Body& body = (*this)[index];
  body.pose = pose;
  body.has_moved = true;
  circles_[static_cast<std::size_t>(index)].centre = pose.position;
  if (body.is_large) {
    if (!body.is_movable) {
      walls_.set(index, boundsOf(body));
    }
  } else {
    grid_.move(index, pose.position);
  }
}

Eigen::AlignedBox2d Bodies::boundsOf(const Body& body) {
  const PlacedPose& pose = body.pose;
  const PlanarModel& model = *body.model;
  Eigen::AlignedBox2d bounds;
  placeShapes(model, pose.position, pose.cosine, pose.sine, placed_shapes_);
  for (std::size_t i = 0; i < model.shapes.size(); ++i) {
    const PlanarShape& shape = placed_shapes_[i];
    const Eigen::Vector2d extent = Eigen::Vector2d::Constant(shape.isCircle() ? shape.radius : 0.0);
    bounds.extend(shape.centre - extent).extend(shape.centre + extent);
    for (const Eigen::Vector2d& vertex : shape.vertices) {
      bounds.extend(vertex);
    }
  }
  return bounds;
}

void Bodies::remove(BodyIndex index) {
  Body& body = (*this)[index];
  if (const Turret* turret = findTurret(index)) {
    turrets_.erase(turrets_.begin() + (turret - turrets_.data()));
  }
  index_of_row_[body.row] = kNoBody;
  order_.erase(std::find(order_.begin(), order_.end(), index));
  if (body.is_large && body.is_movable) {
    large_.erase(std::find(large_.begin(), large_.end(), index));
  } else if (body.is_large) {
    walls_.remove(index);
  } else {
    grid_.remove(index);
  }
  body = Body{};
  details(index) = BodyDetails{};
  holes_.push_back(index);
}

void Bodies::clear() {
  bodies_.clear();
  details_.clear();
  circles_.clear();
  holes_.clear();
  order_.clear();
  index_of_row_.clear();
  large_.clear();
  walls_.clear();
  grid_.clear();
  turrets_.clear();
  largest_radius_ = 0.0;
}

}  // namespace swarmanoid::planar
