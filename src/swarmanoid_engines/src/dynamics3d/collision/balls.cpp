#include "dynamics3d/collision/balls.hpp"

#include <algorithm>
#include <cmath>

#include "planar/planar_model.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector2d;

constexpr double kSupportSpan = 0.7;  // of the wheels' separation
constexpr double kBallSize = 0.3;     // of a wheel's radius

double ballRadius(const EntityModel::Wheels& wheels) { return kBallSize * wheels.radius; }

/// Range of a ball along a line that is parallel to body x; empty if `low` is above `high` [m].
struct Stretch {
  double low = 0.0;
  double high = 0.0;
};

/// @return range in which a ball of that radius at that y lies within a shape with counter-clockwise vertices
Stretch within(const planar::PlanarShape& shape, double y, double radius) {
  if (shape.isCircle()) {
    const double room = shape.radius - radius;
    const double aside = y - shape.centre.y();
    const double half = room < std::abs(aside) ? -1.0 : std::sqrt(room * room - aside * aside);
    return {shape.centre.x() - half, shape.centre.x() + half};
  }
  Stretch stretch{-HUGE_VAL, HUGE_VAL};
  const std::size_t count = shape.vertices.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2d edge = (shape.vertices[(i + 1) % count] - shape.vertices[i]).normalized();
    const Vector2d inwards(-edge.y(), edge.x());
    const double rest = radius - inwards.y() * (y - shape.vertices[i].y());
    if (std::abs(inwards.x()) < 1e-12) {
      if (rest > 0.0) {
        return {1.0, -1.0};
      }
    } else if (const double limit = shape.vertices[i].x() + rest / inwards.x(); inwards.x() > 0.0) {
      stretch.low = std::max(stretch.low, limit);
    } else {
      stretch.high = std::min(stretch.high, limit);
    }
  }
  return stretch;
}

/// Places balls before and behind wheels.
class Supports {
 public:
  explicit Supports(const EntityModel& model) : wheels_(*model.wheels), radius_(ballRadius(wheels_)) {
    planar::projectModel(model, planar::Plane{}, Eigen::Quaterniond::Identity(), outline_);
    for (std::size_t i = model.shapes.size(); i-- > 0;) {
      if (model.shapes[i].joint >= 0) {
        outline_.shapes.erase(outline_.shapes.begin() + static_cast<std::ptrdiff_t>(i));  // may turn away
      }
    }
  }

  /// @param direction 1 ahead, -1 behind @return x of the ball's centre [m]
  double place(double y, double direction) const {
    const double wanted = wantedReach(direction);
    double reach = 0.0;
    for (const planar::PlanarShape& shape : outline_.shapes) {
      const Stretch along = within(shape, y, radius_);
      const Stretch out = direction > 0.0 ? along : Stretch{-along.high, -along.low};
      if (out.low <= std::min(wanted, out.high)) {
        reach = std::max(reach, std::min(wanted, out.high));
      }
    }
    return direction * reach;
  }

 private:
  /// Wanted distance from the axle, before the limit by the body's shapes.
  double wantedReach(double direction) const {
    double reach = kSupportReach * wheels_.radius;
    for (const planar::PlanarShape& shape : outline_.shapes) {
      if (shape.band.low < kOnGround) {
        reach = std::max(reach, direction * shape.centre.x());
      }
    }
    return reach;
  }

  const EntityModel::Wheels& wheels_;
  double radius_;
  planar::PlanarModel outline_;
};

}  // namespace

std::vector<Ball> ballsOf(const EntityModel& model) {
  const EntityModel::Wheels& wheels = *model.wheels;
  const double radius = ballRadius(wheels);
  const Supports supports(model);
  std::vector<Ball> balls;
  for (int side = 0; side < 2; ++side) {
    const double y = (side == 0 ? 0.5 : -0.5) * wheels.separation;
    for (const double direction : {0.0, 1.0, -1.0}) {
      Ball ball;
      ball.is_support = direction != 0.0;
      ball.side = side;
      ball.shape.kind = CollisionShape::Kind::kSphere;
      ball.shape.half_extent.setConstant(radius);
      ball.shape.position = {0.0, y, radius};
      if (ball.is_support) {
        const double aside = kSupportSpan * y;
        ball.shape.position = {supports.place(aside, direction), aside, radius};
      }
      balls.push_back(ball);
    }
  }
  return balls;
}

}  // namespace swarmanoid::dynamics3d
