#include "dynamics3d/solids.hpp"

namespace swarmanoid::dynamics3d {
namespace {

// Where a treel's balls are: a footbot that pushes as hard as it can must not rear, and yet they lie under its body.
constexpr double kSupportReach = 1.75;     // of a wheel's radius, ahead and behind
constexpr double kSupportSpan = 0.7;       // of the wheels' separation
constexpr double kBallSize = 0.3;          // of a wheel's radius
constexpr double kGroundClearance = 5e-3;  // m: how far shapes end above what the balls stand on
constexpr double kOnGround = 2e-3;         // m: shapes that come nearer to it are cut short

void addSolid(Body& body, const Solid& solid, const Eigen::Vector3d& position, const Eigen::Quaterniond& turn) {
  body.solids.push_back(solid);
  if (body.rigid == nullptr) {
    return;  // setPose puts it where it is
  }
  const bool is_on_link = solid.joint >= 0 && !body.links.empty();
  const auto joint = static_cast<std::size_t>(is_on_link ? solid.joint : 0);
  const Eigen::Vector3d& centre = is_on_link ? body.model->joints[joint].part.centre_of_mass : body.own.centre_of_mass;
  dGeomSetBody(solid.geom, is_on_link ? body.links[joint].rigid : body.rigid);
  setGeomOffset(solid.geom, position - centre, turn);
}

/// Cuts off what would drag over the ground.
CollisionShape clearOfGround(CollisionShape shape) {
  const bool is_upright = std::abs((shape.orientation * Eigen::Vector3d::UnitZ()).z()) > 1.0 - 1e-9;
  const double low = shape.position.z() - shape.half_extent.z();
  const double missing = kGroundClearance - low;
  if (shape.kind != CollisionShape::Kind::kSphere && is_upright && low < kOnGround && missing < shape.half_extent.z()) {
    shape.half_extent.z() -= missing / 2.0;
    shape.position.z() += missing / 2.0;
  }
  return shape;
}

/// One of a treel's balls. @param side 0 left, 1 right; @param place ahead of the axle, in wheels' radii
CollisionShape ballOf(const EntityModel::Wheels& wheels, int side, double place) {
  const double radius = kBallSize * wheels.radius;
  const double y = (side == 0 ? 0.5 : -0.5) * wheels.separation;
  CollisionShape ball;
  ball.kind = CollisionShape::Kind::kSphere;
  ball.half_extent.setConstant(radius);
  ball.position = {place * wheels.radius, place == 0.0 ? y : kSupportSpan * y, radius};
  return ball;
}

constexpr double kBallPlaces[] = {0.0, kSupportReach, -kSupportReach};

void addBalls(Body& body) {
  for (int side = 0; side < 2; ++side) {
    for (const double place : kBallPlaces) {
      const CollisionShape ball = ballOf(*body.model->wheels, side, place);
      Solid solid;
      solid.geom = makeGeom(ball, kMargin / 2.0);
      solid.kind = place == 0.0 ? Solid::Kind::kWheel : Solid::Kind::kSupport;
      solid.side = side;
      addSolid(body, solid, ball.position, ball.orientation);
    }
  }
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
    addBalls(body);
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
  for (int side = 0; side < 2; ++side) {
    for (const double place : kBallPlaces) {
      shapes.push_back(ballOf(*model.wheels, side, place));
    }
  }
  return shapes;
}

}  // namespace swarmanoid::dynamics3d
