#include "planar/planar_model.hpp"

#include <algorithm>
#include <cmath>

namespace swarmanoid::planar {
void findConvexHull(std::vector<Eigen::Vector2d>& points, std::vector<Eigen::Vector2d>& hull) {  // monotone chain
  constexpr double kSame = 1e-9;                                                                 // m
  std::sort(points.begin(), points.end(), [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  hull.clear();
  for (int side = 0; side < 2; ++side) {
    const std::size_t start = hull.size();
    for (const Eigen::Vector2d& point : points) {
      while (hull.size() >= start + 2 &&
             cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= kSame * kSame) {
        hull.pop_back();
      }
      if (hull.size() == start || (point - hull.back()).norm() > kSame) {
        hull.push_back(point);
      }
    }
    if (hull.size() > start + 1) {
      hull.pop_back();  // first point of the other side
    }
    std::reverse(points.begin(), points.end());
  }
}

namespace {

/// Calls visit(point) for points whose hull is the solid: the corners of a box, or a ring around each face of a
/// cylinder.
template <class Visit>
void visitOutline(const CollisionShape& shape, Visit visit) {
  const Eigen::Vector3d& h = shape.half_extent;
  if (shape.kind == CollisionShape::Kind::kBox) {
    for (int corner = 0; corner < 8; ++corner) {
      visit(Eigen::Vector3d((corner & 1) != 0 ? h.x() : -h.x(), (corner & 2) != 0 ? h.y() : -h.y(),
                            (corner & 4) != 0 ? h.z() : -h.z()));
    }
    return;
  }
  constexpr int kSides = 16;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2.0 * M_PI * i / kSides;
    for (const double z : {-h.z(), h.z()}) {
      visit(Eigen::Vector3d(h.x() * std::cos(angle), h.x() * std::sin(angle), z));
    }
  }
}

void projectShape(const CollisionShape& shape, const Plane& plane, const Eigen::Quaterniond& base,
                  PlanarShape& result) {
  const Eigen::Vector3d centre = base * shape.position;
  const Eigen::Quaterniond turn = base * shape.orientation;
  result.centre = plane.toLocal(centre);
  result.vertices.clear();
  const bool is_sphere = shape.kind == CollisionShape::Kind::kSphere;
  if (is_sphere || (shape.kind == CollisionShape::Kind::kCylinder && plane.isUpright(turn))) {
    const double half_height = is_sphere ? shape.half_extent.x() : shape.half_extent.z();
    result.radius = shape.half_extent.x();
    result.band = {plane.along(centre) - half_height, plane.along(centre) + half_height};
    return;
  }
  thread_local std::vector<Eigen::Vector2d> points;
  points.clear();
  result.band = {plane.along(centre), plane.along(centre)};
  visitOutline(shape, [&](const Eigen::Vector3d& point) {
    const Eigen::Vector3d placed = centre + turn * point;
    points.push_back(plane.toLocal(placed));
    result.band.low = std::min(result.band.low, plane.along(placed));
    result.band.high = std::max(result.band.high, plane.along(placed));
  });
  findConvexHull(points, result.vertices);
  result.radius = 0.0;
  for (const Eigen::Vector2d& vertex : result.vertices) {
    result.radius = std::max(result.radius, (vertex - result.centre).norm());
  }
}

/// Radius of the largest circle around the shape's centre that lies in the shape.
double innerRadius(const PlanarShape& shape) {
  if (shape.isCircle()) {
    return shape.radius;
  }
  double least = shape.radius;
  const std::size_t count = shape.vertices.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2d edge = shape.vertices[(i + 1) % count] - shape.vertices[i];
    least = std::min(least, cross(edge, shape.centre - shape.vertices[i]) / edge.norm());
  }
  return least;
}

}  // namespace

void projectModel(const EntityModel& model, const Plane& plane, const Eigen::Quaterniond& base, PlanarModel& result,
                  Span<const JointState> joints) {
  result.ahead = plane.toLocal(base * Eigen::Vector3d::UnitX());
  result.left = plane.toLocal(base * Eigen::Vector3d::UnitY());
  result.up = plane.toLocal(base * Eigen::Vector3d::UnitZ());
  result.turn = plane.along(base * Eigen::Vector3d::UnitZ());
  result.radius = 0.0;
  result.inner_radius = 0.0;
  result.band = Band{};
  result.shapes.resize(model.shapes.size());
  for (std::size_t i = 0; i < model.shapes.size(); ++i) {
    PlanarShape& projected = result.shapes[i];
    const CollisionShape& shape = model.shapes[i];
    const bool is_turned = !joints.empty() && shape.joint >= 0;
    projectShape(is_turned ? placeOf(model, joints, shape) : shape, plane, base, projected);
    double reach = projected.centre.norm() + projected.radius;
    if (!projected.isCircle()) {
      reach = 0.0;
      for (const Eigen::Vector2d& vertex : projected.vertices) {
        reach = std::max(reach, vertex.norm());
      }
    }
    result.radius = std::max(result.radius, reach);
    result.inner_radius = std::max(result.inner_radius, innerRadius(projected));
    result.band.low = i == 0 ? projected.band.low : std::min(result.band.low, projected.band.low);
    result.band.high = i == 0 ? projected.band.high : std::max(result.band.high, projected.band.high);
  }
}

void placeShape(const PlanarShape& shape, const Eigen::Vector2d& position, double cosine, double sine,
                PlanarShape& placed) {
  const auto place = [&](const Eigen::Vector2d& p) {
    return Eigen::Vector2d(position.x() + cosine * p.x() - sine * p.y(), position.y() + sine * p.x() + cosine * p.y());
  };
  placed.centre = place(shape.centre);
  placed.radius = shape.radius;
  placed.band = shape.band;
  placed.vertices.resize(shape.vertices.size());
  std::transform(shape.vertices.begin(), shape.vertices.end(), placed.vertices.begin(), place);
}

void placeShapes(const PlanarModel& model, const Eigen::Vector2d& position, double cosine, double sine,
                 std::vector<PlanarShape>& placed) {
  placed.resize(std::max(placed.size(), model.shapes.size()));
  for (std::size_t i = 0; i < model.shapes.size(); ++i) {
    placeShape(model.shapes[i], position, cosine, sine, placed[i]);
  }
}

}  // namespace swarmanoid::planar
