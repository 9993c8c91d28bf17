#include "planar/draw_bodies.hpp"

#include <cmath>

namespace swarmanoid::planar {
namespace {

/// Corners of a shape in its body's frame; a circle is drawn with sixteen.
std::vector<Eigen::Vector2d> outlineOf(const PlanarShape& shape) {
  if (!shape.isCircle()) {
    return shape.vertices;
  }
  constexpr int kSides = 16;
  std::vector<Eigen::Vector2d> outline;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2.0 * M_PI * i / kSides;
    outline.push_back(shape.centre + shape.radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return outline;
}

void drawShape(const Plane& plane, const Body& body, const PlanarShape& shape, EngineDrawing& drawing) {
  const std::vector<Eigen::Vector2d> outline = outlineOf(shape);
  const auto at = [&](std::size_t corner, double height) {
    const Eigen::Vector2d& point = outline[corner % outline.size()];
    return plane.toGlobal(body.pose.position + body.pose.rotated(point), body.along + height);
  };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    drawing.add(EngineDrawing::Kind::kShape, at(i, shape.band.low), at(i + 1, shape.band.low));
    drawing.add(EngineDrawing::Kind::kShape, at(i, shape.band.high), at(i + 1, shape.band.high));
    if (i % 4 == 0 || !shape.isCircle()) {
      drawing.add(EngineDrawing::Kind::kShape, at(i, shape.band.low), at(i, shape.band.high));
    }
  }
}

}  // namespace

void drawShapes(const Bodies& bodies, EngineDrawing& drawing) {
  for (const BodyIndex index : bodies.order()) {
    for (const PlanarShape& shape : bodies[index].model->shapes) {
      drawShape(bodies.plane(), bodies[index], shape, drawing);
    }
  }
}

void drawLine(const Bodies& bodies, BodyIndex at_height_of, EngineDrawing::Kind kind, const Eigen::Vector2d& from,
              const Eigen::Vector2d& to, EngineDrawing& drawing) {
  const Body& body = bodies[at_height_of];
  const double along = body.along + 0.5 * (body.model->band.low + body.model->band.high);
  drawing.add(kind, bodies.plane().toGlobal(from, along), bodies.plane().toGlobal(to, along));
}

}  // namespace swarmanoid::planar
