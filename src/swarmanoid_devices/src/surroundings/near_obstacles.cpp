#include "near_obstacles.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace swarmanoid::devices {
namespace {

/// Whether an upright bounding cylinder is a tight fit: robots are about as long as wide.
bool isRound(const EntityModel& model) {
  return model.is_robot || (model.silhouettes.size() == 1 && model.silhouettes.front().is_whole);
}

Eigen::AlignedBox3d boxAroundShapes(const EntityModel& model, const Pose& pose) {
  Eigen::AlignedBox3d box;
  const Eigen::Matrix3d turn = pose.orientation.toRotationMatrix();
  for (const CollisionShape& shape : model.shapes) {
    const Eigen::Vector3d centre = pose.position + turn * shape.position;
    const bool is_sphere = shape.kind == CollisionShape::Kind::kSphere;
    const Eigen::Matrix3d axes = (turn * shape.orientation.toRotationMatrix()).cwiseAbs();
    const Eigen::Vector3d extent =
        is_sphere ? Eigen::Vector3d::Constant(shape.half_extent.x()) : Eigen::Vector3d(axes * shape.half_extent);
    box.extend(centre - extent).extend(centre + extent);
  }
  return box;
}

/// The box around an entity, in W. Engines whose plane is perpendicular to an axis of W cast rays against prisms: the
/// outline of a solid in the plane, extruded over its extent across the plane. The box contains these prisms and the
/// solid itself.
Eigen::AlignedBox3d boxAround(const EntityModel& model, const Pose& pose) {
  if (model.joints_keep_outline && pose.isUpright() && isRound(model)) {
    const double reach = model.horizontal_radius;
    return {pose.position + Eigen::Vector3d(-reach, -reach, model.lowest),
            pose.position + Eigen::Vector3d(reach, reach, model.highest)};
  }
  if (model.joints.empty()) {
    return boxAroundShapes(model, pose);
  }
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(model.moving_reach);
  return {pose.position - reach, pose.position + reach};
}

}  // namespace

NearObstacles::Obstacle NearObstacles::obstacleOf(const Space& space, Row row, const Eigen::Vector3d& eye) {
  const Eigen::Vector3d margin = eye.cwiseAbs() * 1e-12 + Eigen::Vector3d::Constant(kSightRounding);
  const Eigen::AlignedBox3d box = boxAround(*space.entities.model[row], space.entities.pose[row]);
  return {row, {box.min() - eye - margin, box.max() - eye + margin}};
}

NearObstacles::Bundle NearObstacles::bundleTo(const Eigen::Vector3d& way, double radius, double lowest,
                                              double highest) {
  // a zero component is replaced by one that is much smaller than the margin of the boxes
  constexpr double kLeast = 1e-12;  // m
  const auto inverse = [](double step) { return 1.0 / (std::abs(step) < kLeast ? kLeast : step); };
  return {{inverse(way.x()), inverse(way.y())}, radius, lowest, highest};
}

void NearObstacles::begin(const Space& space, Row self, const Eigen::Vector3d& eye, const std::vector<Row>& near,
                          double low, double high) {
  space_ = &space;
  self_ = self;
  eye_ = eye;
  low_ = low - eye.z();
  high_ = high - eye.z();
  obstacles_.clear();
  for (const Row row : near) {
    if (row != self && !space.entities.model[row]->shapes.empty()) {
      obstacles_.push_back(obstacleOf(space, row, eye));
    }
  }
}

NearObstacles::Bundle NearObstacles::bundleOf(const LedPoints& points, const LedSet& asked) const {
  Eigen::AlignedBox3d box;
  visitLeds(asked, [&](std::size_t k) { box.extend(points[k]); });
  return bundleTo(box.center() - eye_, 0.5 * box.diagonal().norm(), box.min().z() - eye_.z(), box.max().z() - eye_.z());
}

NearObstacles::Bundle NearObstacles::lineTo(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d way = point - eye_;
  return bundleTo(way, 0.0, way.z(), way.z());
}

bool NearObstacles::mayHide(const Obstacle& obstacle, const Bundle& bundle) {
  const Eigen::Vector3d& low = obstacle.box.min();
  const Eigen::Vector3d& high = obstacle.box.max();
  if (high.z() < std::min(0.0, bundle.lowest) || low.z() > std::max(0.0, bundle.highest)) {
    return false;
  }
  // the part of the way on which a line can be in the box: first by its height, then seen from above
  double from = 0.0;
  if (high.z() < 0.0) {
    from = high.z() / bundle.lowest;
  } else if (low.z() > 0.0) {
    from = low.z() / bundle.highest;
  }
  double to = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    const double first = (low[axis] - bundle.radius) * bundle.inverse_way[axis];
    const double second = (high[axis] + bundle.radius) * bundle.inverse_way[axis];
    from = std::max(from, std::min(first, second));
    to = std::min(to, std::max(first, second));
  }
  return from <= to;
}

bool NearObstacles::knowsAllBefore(const Bundle& bundle) const {
  return !space_->terrain && low_ <= std::min(0.0, bundle.lowest) && std::max(0.0, bundle.highest) <= high_;
}

LedSet NearObstacles::passing(const LedPoints& points, const LedSet& asked, const Bundle& bundle, Row owner) {
  on_the_way_.clear();
  for (const Obstacle& obstacle : obstacles_) {
    if (obstacle.row != owner && mayHide(obstacle, bundle)) {
      on_the_way_.push_back(&obstacle);
    }
  }
  LedSet passing;
  if (!on_the_way_.empty()) {
    visitLeds(asked, [&](std::size_t k) {
      const Bundle line = lineTo(points[k]);
      passing[k] = std::any_of(on_the_way_.begin(), on_the_way_.end(),
                               [&](const Obstacle* obstacle) { return mayHide(*obstacle, line); });
    });
  }
  return passing;
}

LedSet NearObstacles::cast(const LedPoints& points, const LedSet& asked, Row owner) const {
  std::array<Segment, LedSet{}.size()> segments;
  std::array<RayHit, LedSet{}.size()> hits;
  std::size_t count = 0;
  Eigen::AlignedBox3d box(eye_);
  visitLeds(asked, [&](std::size_t k) {
    segments[count++] = {eye_, points[k]};
    box.extend(points[k]);
  });
  RayBundle rays;
  rays.segments = Span<const Segment>(segments.data(), count);
  rays.centre = box.center();
  rays.radius = 0.5 * box.diagonal().norm() + kSightRounding;
  rays.ignored = self_;
  rays.also_ignored = owner;
  space_->raycast(rays, Span<RayHit>(hits.data(), count));
  LedSet hidden;
  std::size_t next = 0;
  visitLeds(asked, [&](std::size_t k) { hidden[k] = hits[next++].fraction < 1.0 - kOwnSurface; });
  return hidden;
}

LedSet NearObstacles::hidden(const LedPoints& points, const LedSet& asked, Row owner) {
  if (asked.none()) {
    return asked;
  }
  const Bundle bundle = bundleOf(points, asked);
  const LedSet unsure = knowsAllBefore(bundle) ? passing(points, asked, bundle, owner) : asked;
  return unsure.none() ? unsure : cast(points, unsure, owner);
}

bool NearObstacles::hides(const Eigen::Vector3d& point, Row owner) {
  const Bundle line = lineTo(point);
  const auto may_hide = [&](const Obstacle& obstacle) { return obstacle.row != owner && mayHide(obstacle, line); };
  if (knowsAllBefore(line) && std::none_of(obstacles_.begin(), obstacles_.end(), may_hide)) {
    return false;
  }
  return space_->castRay({eye_, point}, self_, owner).fraction < 1.0 - kOwnSurface;
}

}  // namespace swarmanoid::devices
