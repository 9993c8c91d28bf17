#include "dynamics2d/contact_shape.hpp"

#include <algorithm>

#include "planar/plane.hpp"

namespace swarmanoid::dynamics2d {
namespace {

constexpr double kFlat = 1e-6;  // m

/// Distance of a corner from the line between its neighbours.
double heightOver(const Eigen::Vector2d& before, const Eigen::Vector2d& corner, const Eigen::Vector2d& after) {
  const Eigen::Vector2d line = after - before;
  return planar::cross(line, before - corner) / std::max(line.norm(), kFlat);
}

/// Removes the flattest corner repeatedly, until none is flat.
void simplify(std::vector<Eigen::Vector2d>& corners) {
  while (corners.size() > 3) {
    std::size_t flattest = 0;
    double least = kFlat;
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i < count; ++i) {
      const double height = heightOver(corners[(i + count - 1) % count], corners[i], corners[(i + 1) % count]);
      if (height < least) {
        flattest = i;
        least = height;
      }
    }
    if (least >= kFlat) {
      return;
    }
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(flattest));
  }
}

void finishPolygon(ContactShape& shape) {
  shape.centre.setZero();
  for (int i = 0; i < shape.count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Eigen::Vector2d side = shape.corners[static_cast<std::size_t>((i + 1) % shape.count)] - shape.corners[at];
    shape.normals[at] = Eigen::Vector2d(side.y(), -side.x()).normalized();
    shape.centre += shape.corners[at] / shape.count;
  }
  shape.radius = 0.0;
  // b2PolygonShape::Set welds corners, reorders them and asserts; these are convex and in order already
  shape.polygon.m_count = shape.count;
  shape.polygon.m_radius = 0.0F;
  const auto toFloat = [](const Eigen::Vector2d& v) {
    return b2Vec2(static_cast<float>(v.x()), static_cast<float>(v.y()));
  };
  shape.polygon.m_centroid = toFloat(shape.centre);
  for (std::size_t i = 0; i < static_cast<std::size_t>(shape.count); ++i) {
    shape.radius = std::max(shape.radius, (shape.corners[i] - shape.centre).norm());
    shape.polygon.m_vertices[i] = toFloat(shape.corners[i]);
    shape.polygon.m_normals[i] = toFloat(shape.normals[i]);
  }
}

void addPolygons(const std::vector<Eigen::Vector2d>& corners, ContactShape shape, std::vector<ContactShape>& shapes) {
  constexpr std::size_t kMost = ContactShape::kMostCorners;
  // a fan of pieces around corner 0; neighbours share an edge
  for (std::size_t first = 1; first + 1 < corners.size(); first += kMost - 2) {
    const std::size_t count = std::min(kMost - 1, corners.size() - first);
    shape.corners[0] = corners[0];
    std::copy_n(corners.begin() + static_cast<std::ptrdiff_t>(first), count, shape.corners.begin() + 1);
    shape.count = static_cast<int>(count) + 1;
    finishPolygon(shape);
    shapes.push_back(shape);
  }
}

}  // namespace

void makeContactShapes(const planar::PlanarModel& model, const Eigen::Vector2d& arm,
                       std::vector<ContactShape>& shapes) {
  thread_local std::vector<Eigen::Vector2d> corners;
  shapes.clear();
  for (std::size_t i = 0; i < model.shapes.size(); ++i) {
    const planar::PlanarShape& from = model.shapes[i];
    ContactShape shape;
    shape.number = i;
    shape.band = from.band;
    shape.is_circle = from.isCircle();
    if (shape.is_circle) {
      shape.centre = from.centre - arm;
      shape.radius = from.radius;
      shapes.push_back(shape);
      continue;
    }
    corners.assign(from.vertices.begin(), from.vertices.end());
    for (Eigen::Vector2d& corner : corners) {
      corner -= arm;
    }
    simplify(corners);
    addPolygons(corners, shape, shapes);
  }
}

}  // namespace swarmanoid::dynamics2d
