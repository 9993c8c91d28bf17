#include "planar/planar_model.hpp"

#include <algorithm>
#include <cmath>

namespace swarmanoid::planar {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Counter-clockwise convex hull (monotone chain).
std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points) {
  constexpr double kSame = 1e-9;  // m
  std::sort(points.begin(), points.end(), [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  std::vector<Eigen::Vector2d> hull;
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
      hull.pop_back();  // where the other side starts
    }
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// Points whose hull is the solid: a box's corners, or a ring of points around each face of a cylinder.
std::vector<Eigen::Vector3d> outline(const CollisionShape& shape) {
  std::vector<Eigen::Vector3d> points;
  const Eigen::Vector3d& h = shape.half_extent;
  if (shape.kind == CollisionShape::Kind::kBox) {
    for (int corner = 0; corner < 8; ++corner) {
      points.emplace_back((corner & 1) != 0 ? h.x() : -h.x(), (corner & 2) != 0 ? h.y() : -h.y(),
                          (corner & 4) != 0 ? h.z() : -h.z());
    }
    return points;
  }
  constexpr int kSides = 16;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2.0 * M_PI * i / kSides;
    for (const double z : {-h.z(), h.z()}) {
      points.emplace_back(h.x() * std::cos(angle), h.x() * std::sin(angle), z);
    }
  }
  return points;
}

PlanarShape projectShape(const CollisionShape& shape, const Plane& plane, const Eigen::Quaterniond& base) {
  const Eigen::Vector3d centre = base * shape.position;
  const Eigen::Quaterniond turn = base * shape.orientation;
  const double uprightness = std::abs(plane.along(turn * Eigen::Vector3d::UnitZ()));
  constexpr double kUpright = 1.0 - 1e-9;
  PlanarShape result;
  result.centre = plane.toLocal(centre);
  const bool is_sphere = shape.kind == CollisionShape::Kind::kSphere;
  if (is_sphere || (shape.kind == CollisionShape::Kind::kCylinder && uprightness >= kUpright)) {
    const double half_height = is_sphere ? shape.half_extent.x() : shape.half_extent.z();
    result.radius = shape.half_extent.x();
    result.band = {plane.along(centre) - half_height, plane.along(centre) + half_height};
    return result;
  }
  std::vector<Eigen::Vector2d> points;
  result.band = {plane.along(centre), plane.along(centre)};
  for (const Eigen::Vector3d& point : outline(shape)) {
    const Eigen::Vector3d placed = centre + turn * point;
    points.push_back(plane.toLocal(placed));
    result.band.low = std::min(result.band.low, plane.along(placed));
    result.band.high = std::max(result.band.high, plane.along(placed));
  }
  result.vertices = convexHull(std::move(points));
  for (const Eigen::Vector2d& vertex : result.vertices) {
    result.radius = std::max(result.radius, (vertex - result.centre).norm());
  }
  return result;
}

}  // namespace

std::shared_ptr<const PlanarModel> projectModel(const EntityModel& model, const Plane& plane,
                                                const Eigen::Quaterniond& base) {
  auto result = std::make_shared<PlanarModel>();
  for (const CollisionShape& shape : model.shapes) {
    result->shapes.push_back(projectShape(shape, plane, base));
    const PlanarShape& projected = result->shapes.back();
    double reach = projected.centre.norm() + projected.radius;
    if (!projected.isCircle()) {
      reach = 0.0;
      for (const Eigen::Vector2d& vertex : projected.vertices) {
        reach = std::max(reach, vertex.norm());
      }
    }
    result->radius = std::max(result->radius, reach);
    const bool is_first = result->shapes.size() == 1;
    result->band.low = is_first ? projected.band.low : std::min(result->band.low, projected.band.low);
    result->band.high = is_first ? projected.band.high : std::max(result->band.high, projected.band.high);
  }
  return result;
}

void placeShapes(const PlanarModel& model, const Eigen::Vector2d& position, double cosine, double sine,
                 std::vector<PlanarShape>& placed) {
  const auto place = [&](const Eigen::Vector2d& p) {
    return Eigen::Vector2d(position.x() + cosine * p.x() - sine * p.y(), position.y() + sine * p.x() + cosine * p.y());
  };
  placed.resize(std::max(placed.size(), model.shapes.size()));
  for (std::size_t i = 0; i < model.shapes.size(); ++i) {
    const PlanarShape& shape = model.shapes[i];
    placed[i].centre = place(shape.centre);
    placed[i].radius = shape.radius;
    placed[i].band = shape.band;
    placed[i].vertices.resize(shape.vertices.size());
    for (std::size_t k = 0; k < shape.vertices.size(); ++k) {
      placed[i].vertices[k] = place(shape.vertices[k]);
    }
  }
}

}  // namespace swarmanoid::planar
