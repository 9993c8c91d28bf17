#include "kinematics2d/bodies.hpp"

#include <algorithm>
#include <cmath>

namespace swarmanoid::kinematics2d {
namespace {
constexpr double kLargeRadius = 0.4;  // m: what is wider would make every look into the grid wide
}

PlacedPose PlacedPose::at(const Eigen::Vector2d& position, double heading) {
  return {position, heading, std::cos(heading), std::sin(heading)};
}

std::shared_ptr<const PlanarModel> Bodies::project(const std::shared_ptr<const EntityModel>& model,
                                                   const Eigen::Quaterniond& base) {
  for (const Projection& projection : projections_) {
    if (projection.entity.lock() == model && projection.base.coeffs() == base.coeffs()) {
      return projection.model;
    }
  }
  projections_.erase(std::remove_if(projections_.begin(), projections_.end(),
                                    [](const Projection& projection) { return projection.entity.expired(); }),
                     projections_.end());
  projections_.push_back({model, base, planar::projectModel(*model, plane_, base)});
  return projections_.back().model;
}

BodyIndex Bodies::add(const Space& space, Row row, Role role) {
  if (order_.empty()) {
    grid_.configure(plane_.toLocal(space.size));
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
  const auto i = static_cast<std::size_t>(row);
  BodyDetails& its = details(index);
  its = BodyDetails{};
  its.entity = space.entities.model[i];
  its.base = plane_.baseOf(space.entities.pose[i].orientation);
  its.model = project(its.entity, its.base);

  Body& body = (*this)[index];
  body = Body{};
  body.row = row;
  body.number = space.entities.number[i];
  body.role = role;
  body.model = its.model.get();
  body.is_movable = its.entity->is_movable;
  body.is_large = its.model->radius > kLargeRadius && !its.entity->is_movable;
  body.wheels = space.actuation.find<FootbotWheels>(row);
  body.velocity = space.actuation.find<EyebotVelocity>(row);
  body.gripper = space.actuation.find<FootbotGripper>(row);

  index_of_row_.resize(std::max(index_of_row_.size(), i + 1), kNoBody);
  index_of_row_[i] = index;
  // a mirror of an old entity may come late: the order is by number, not by arrival
  order_.insert(std::upper_bound(order_.begin(), order_.end(), index,
                                 [&](BodyIndex a, BodyIndex b) { return (*this)[a].number < (*this)[b].number; }),
                index);
  if (body.is_large) {
    large_.push_back(index);
  } else {
    largest_radius_ = std::max(largest_radius_, body.model->radius);
    circles_[static_cast<std::size_t>(index)].radius = body.model->radius;
    grid_.add(index, plane_.toLocal(space.entities.pose[i].position));
  }
  place(space, index);
  return index;
}

void Bodies::place(const Space& space, BodyIndex index) {
  Body& body = (*this)[index];
  BodyDetails& its = details(index);
  const Pose& pose = space.entities.pose[static_cast<std::size_t>(body.row)];
  body.along = plane_.along(pose.position);
  const Eigen::Quaterniond base = plane_.baseOf(pose.orientation);
  if (base.coeffs() != its.base.coeffs()) {
    its.base = base;
    its.model = project(its.entity, base);
    body.model = its.model.get();
    circles_[static_cast<std::size_t>(index)].radius = body.model->radius;
    largest_radius_ = std::max(largest_radius_, body.is_large ? 0.0 : body.model->radius);
  }
  setPose(index, PlacedPose::at(plane_.toLocal(pose.position), plane_.headingOf(pose.orientation)));
  body.has_moved = false;
  if (body.is_large) {
    refreshBounds(index);
  }
}

void Bodies::setPose(BodyIndex index, const PlacedPose& pose) {
  Body& body = (*this)[index];
  body.pose = pose;
  body.has_moved = true;
  if (!body.is_large) {
    circles_[static_cast<std::size_t>(index)].centre = pose.position;
    grid_.move(index, pose.position);
  }
}

void Bodies::refreshBounds(BodyIndex index) {
  const PlacedPose& pose = (*this)[index].pose;
  std::vector<PlanarShape> placed;
  planar::placeShapes(*(*this)[index].model, pose.position, pose.cosine, pose.sine, placed);
  Eigen::AlignedBox2d& bounds = details(index).bounds;
  bounds.setEmpty();
  for (const PlanarShape& shape : placed) {
    const Eigen::Vector2d extent = Eigen::Vector2d::Constant(shape.isCircle() ? shape.radius : 0.0);
    bounds.extend(shape.centre - extent).extend(shape.centre + extent);
    for (const Eigen::Vector2d& vertex : shape.vertices) {
      bounds.extend(vertex);
    }
  }
}

void Bodies::remove(BodyIndex index) {
  Body& body = (*this)[index];
  index_of_row_[static_cast<std::size_t>(body.row)] = kNoBody;
  order_.erase(std::find(order_.begin(), order_.end(), index));
  if (body.is_large) {
    large_.erase(std::find(large_.begin(), large_.end(), index));
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
  projections_.clear();
  grid_.clear();
  largest_radius_ = 0.0;
}

}  // namespace swarmanoid::kinematics2d
