// Debug drawing of the engine.
#include <array>
#include <cmath>

#include "dynamics3d/collision/balls.hpp"
#include "dynamics3d/dynamics3d.hpp"
#include "dynamics3d/mechanisms/rope.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;
using DrawingKind = EngineDrawing::Kind;

/// A closed line around `centre`, through centre + a and centre + b.
void drawRing(const Pose& pose, const Vector3d& centre, const Vector3d& a, const Vector3d& b, EngineDrawing& drawing) {
  constexpr int kSides = 16;
  const auto at = [&](int i) -> Vector3d {
    const double angle = 2.0 * M_PI * i / kSides;
    return pose.toWorld(centre + std::cos(angle) * a + std::sin(angle) * b);
  };
  for (int i = 0; i < kSides; ++i) {
    drawing.add(DrawingKind::kShape, at(i), at(i + 1));
  }
}

void drawBox(const Pose& pose, const Vector3d& half, EngineDrawing& drawing) {
  const auto corner = [&](int i) -> Vector3d {
    const Vector3d signs((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0, (i & 4) != 0 ? 1.0 : -1.0);
    return pose.toWorld(half.cwiseProduct(signs));
  };
  for (int i = 0; i < 8; ++i) {
    for (const int axis : {1, 2, 4}) {
      if ((i & axis) == 0) {
        drawing.add(DrawingKind::kShape, corner(i), corner(i | axis));
      }
    }
  }
}

void drawShape(const CollisionShape& shape, const Pose& body, EngineDrawing& drawing) {
  Pose pose;
  pose.position = body.toWorld(shape.position);
  pose.orientation = body.orientation * shape.orientation;
  const Vector3d& half = shape.half_extent;
  const Vector3d x = half.x() * Vector3d::UnitX();
  const Vector3d y = half.x() * Vector3d::UnitY();
  if (shape.kind == CollisionShape::Kind::kBox) {
    drawBox(pose, half, drawing);
  } else if (shape.kind == CollisionShape::Kind::kSphere) {
    const Vector3d z = half.x() * Vector3d::UnitZ();
    for (const auto& [a, b] : {std::pair(x, y), std::pair(y, z), std::pair(z, x)}) {
      drawRing(pose, Vector3d::Zero(), a, b, drawing);
    }
  } else {
    const Vector3d z = half.z() * Vector3d::UnitZ();
    drawRing(pose, z, x, y, drawing);
    drawRing(pose, -z, x, y, drawing);
    for (const Vector3d& side : {x, y, Vector3d(-x), Vector3d(-y)}) {
      drawing.add(DrawingKind::kShape, pose.toWorld(side - z), pose.toWorld(side + z));
    }
  }
}

}  // namespace

void Dynamics3d::drawAttachments(EngineDrawing& drawing) const {
  for (const Body* body : order_) {
    if (body->holding == nullptr) {
      continue;
    }
    for (std::size_t i = 0; i < body->holding->ropes.size(); ++i) {
      const Rope& rope = body->holding->ropes[i];
      if (rope.held != nullptr) {
        const Vector3d launcher = launcherOf(*body, i);
        const Vector3d pull = EngineDrawing::kMetresPerNewton * rope.tension * rope.towards;
        drawing.add(DrawingKind::kJoint, launcher, rope.held->pose.toWorld(rope.anchor));
        drawing.add(DrawingKind::kForce, launcher, launcher + pull);
      }
    }
    for (const Grip& hold : body->holding->grips) {
      if (hold.joint != nullptr) {
        const Vector3d holder = toVector(dBodyGetPosition(hold.holder));
        drawing.add(DrawingKind::kJoint, body->pose.position, holder);
        drawing.add(DrawingKind::kForce, holder,
                    holder + EngineDrawing::kMetresPerNewton * (body->pose.orientation * hold.force));
      }
    }
  }
}

void Dynamics3d::draw(EngineDrawing& drawing) const {
  constexpr double kNormal = 0.05;  // m
  for (const Body* body : order_) {
    for (const CollisionShape& shape : body->seen().shapes) {
      drawShape(shape, body->pose, drawing);
    }
    if (body->is_dynamic && body->model->wheels) {
      for (const Ball& ball : ballsOf(*body->model)) {
        drawShape(ball.shape, body->pose, drawing);
      }
    }
    if (body->grip.joint != nullptr) {
      const Vector3d tip = body->pose.toWorld(gripperTip(*body));
      drawing.add(DrawingKind::kJoint, body->pose.position, tip);
      drawing.add(DrawingKind::kJoint, tip, body->grip.gripped->pose.position);
      drawing.add(DrawingKind::kForce, tip,
                  tip + EngineDrawing::kMetresPerNewton * (body->pose.orientation * body->grip.force));
    }
  }
  drawAttachments(drawing);
  for (const Touch& touch : touches_.all()) {
    const Vector3d point = toVector(touch.geometry.pos);
    drawing.add(DrawingKind::kContact, point, point + kNormal * toVector(touch.geometry.normal));
  }
}

}  // namespace swarmanoid::dynamics3d
