#include "dynamics3d/collision/solids.hpp"

#include "dynamics3d/collision/balls.hpp"

namespace swarmanoid::dynamics3d {
namespace {

constexpr double kGroundClearance = 5e-3;  // m: height of the ends of shapes above the surface under the balls

void addSolid(Body& body, const Solid& solid, const Eigen::Vector3d& position, const Eigen::Quaterniond& turn) {
  body.solids.push_back(solid);
  if (body.rigid == nullptr) {
    return;  // setPose sets its pose
  }
  const bool is_on_link = solid.joint >= 0 && !body.links.empty();
  const auto joint = static_cast<std::size_t>(is_on_link ? solid.joint : 0);
  const Eigen::Vector3d& centre = is_on_link ? body.model->joints[joint].part.centre_of_mass : body.own.centre_of_mass;
  dGeomSetBody(solid.geom, is_on_link ? body.links[joint].rigid : body.rigid);
  setGeomOffset(solid.geom, position - centre, turn);
}

/// Cuts off the parts that would drag over the ground: of upright shapes the lower end; other shapes (a lying wheel,
/// the ball of a caster) shrink on all sides.
CollisionShape clearOfGround(CollisionShape shape) {
  const double reach = shape.reachAlong(Eigen::Vector3d::UnitZ());
  const double low = shape.position.z() - reach;
  const double missing = kGroundClearance - low;
  if (low >= kOnGround) {
    return shape;
  }
  if (missing >= reach) {  // smaller than the clearance: lifted as a whole
    shape.position.z() += missing;
    return shape;
  }
  const bool is_upright = std::abs((shape.orientation * Eigen::Vector3d::UnitZ()).z()) > 1.0 - 1e-9;
  if (shape.kind != CollisionShape::Kind::kSphere && is_upright) {
    shape.half_extent.z() -= missing / 2.0;
    shape.position.z() += missing / 2.0;
  } else {
    shape.half_extent *= 1.0 - missing / reach;
  }
  return shape;
}

}  // namespace

dGeomID makeGeom(const CollisionShape& shape, double growth) {
  const Eigen::Vector3d half = shape.half_extent.array() + growth;
  switch (shape.kind) {
    case CollisionShape::Kind::kBox:
      return dCreateBox(nullptr, 2.0 * half.x(), 2.0 * half.y(), 2.0 * half.z());
    case CollisionShape::Kind::kCylinder:
      return dCreateCylinder(nullptr, half.x(), 2.0 * half.z());
    case CollisionShape::Kind::kSphere:
      break;
  }
  return dCreateSphere(nullptr, half.x());
}

void addSolids(Body& body) {
  const bool is_driven = body.is_dynamic && body.model->wheels;
  for (const CollisionShape& shape : body.model->shapes) {
    const CollisionShape used = is_driven ? clearOfGround(shape) : shape;
    addSolid(body, {makeGeom(used, kMargin / 2.0), Solid::Kind::kPlain, 0, shape.joint, {}}, used.position,
             used.orientation);
  }
  if (is_driven) {
    for (const Ball& ball : ballsOf(*body.model)) {
      const Solid::Kind kind = ball.is_support ? Solid::Kind::kSupport : Solid::Kind::kWheel;
      addSolid(body, {makeGeom(ball.shape, kMargin / 2.0), kind, ball.side, -1, {}}, ball.shape.position,
               ball.shape.orientation);
    }
  }
}

std::vector<CollisionShape> shapesOnGround(const EntityModel& model) {
  if (!model.wheels) {
    return model.shapes;
  }
  std::vector<CollisionShape> shapes;
  for (const CollisionShape& shape : model.shapes) {
    shapes.push_back(clearOfGround(shape));
  }
  for (const Ball& ball : ballsOf(model)) {
    shapes.push_back(ball.shape);
  }
  return shapes;
}

}  // namespace swarmanoid::dynamics3d
