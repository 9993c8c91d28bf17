#include "dynamics2d/support.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "planar/plane.hpp"

namespace swarmanoid::dynamics2d {
namespace {

/// Below this speed an element counts as at rest: friction grows with the speed there [m/s].
constexpr double kRest = 1e-6;

struct Point {
  Eigen::Vector2d arm = Eigen::Vector2d::Zero();  // [m]
  double share = 0.0;
};
using Points = std::vector<Point>;

/// Points of a disc: twelve on each of three rings, or 24 on its rim.
void addDisc(const Eigen::Vector2d& centre, double radius, Pressure pressure, Points& points) {
  constexpr int kAround = 12;
  struct Ring {
    double radius;
    double share;
  };
  // Gauss quadrature along the radius: exact for friction that does not depend on the radius, or falls with it
  constexpr std::array<Ring, 3> kRings{
      {{0.1127016653792583, 0.0626120363218102}, {0.5, 0.4444444444444444}, {0.8872983346207417, 0.4929435192337454}}};
  const auto addRing = [&](const Ring& ring, double phase) {
    for (int i = 0; i < kAround; ++i) {
      const double angle = 2.0 * M_PI * (i + phase) / kAround;
      const Eigen::Vector2d arm = ring.radius * radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      points.push_back({centre + arm, ring.share / kAround});
    }
  };
  if (pressure == Pressure::kEdge) {
    addRing({1.0, 0.5}, 0.0);
    addRing({1.0, 0.5}, 0.5);
    return;
  }
  for (std::size_t i = 0; i < kRings.size(); ++i) {
    addRing(kRings[i], i % 2 == 0 ? 0.0 : 0.5);
  }
}

/// Quadrature points of a triangle, exact for polynomials of the second degree.
void addTriangle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, Points& points) {
  const double share = planar::cross(b - a, c - a) / 3.0;
  points.push_back({(4.0 * a + b + c) / 6.0, share});
  points.push_back({(a + 4.0 * b + c) / 6.0, share});
  points.push_back({(a + b + 4.0 * c) / 6.0, share});
}

void addPolygon(const std::vector<Eigen::Vector2d>& corners, Pressure pressure, Points& points) {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& corner : corners) {
    middle += corner / static_cast<double>(corners.size());
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d& a = corners[i];
    const Eigen::Vector2d& b = corners[(i + 1) % corners.size()];
    if (pressure == Pressure::kEdge) {
      points.push_back({a, 1.0});
    } else {
      const Eigen::Vector2d near_a = 0.5 * (middle + a);
      const Eigen::Vector2d near_b = 0.5 * (middle + b);
      const Eigen::Vector2d between = 0.5 * (a + b);
      addTriangle(middle, near_a, near_b, points);
      addTriangle(near_a, a, between, points);
      addTriangle(near_a, between, near_b, points);
      addTriangle(near_b, between, b, points);
    }
  }
}

std::vector<Eigen::Vector2d> pointsAround(const planar::PlanarShape& shape) {
  constexpr int kSides = 24;
  if (!shape.isCircle()) {
    return shape.vertices;
  }
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2.0 * M_PI * i / kSides;
    points.push_back(shape.centre + shape.radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return points;
}

void centre(Points& points) {
  double total = 0.0;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Point& point : points) {
    total += point.share;
    middle += point.share * point.arm;
  }
  for (Point& point : points) {
    point.arm -= middle / total;
    point.share /= total;
  }
}

void pack(const Points& points, Support& support) {
  support.points.assign((points.size() + 1) / 2, Support::Points{});
  for (std::size_t i = 0; i < points.size(); ++i) {
    Support::Points& two = support.points[i / 2];
    const auto side = static_cast<Eigen::Index>(i % 2);
    two.arm_x[side] = points[i].arm.x();
    two.arm_y[side] = points[i].arm.y();
    two.share[side] = points[i].share;
  }
}

/// Slip velocities of two points.
struct Slip {
  Eigen::Array2d x;
  Eigen::Array2d y;
  Eigen::Array2d square;  // of the speed; a little more than 0 at rest

  Slip(const Support::Points& points, const PlanarTwist& twist)
      : x(twist.x() - twist.z() * points.arm_y),
        y(twist.y() + twist.z() * points.arm_x),
        square(x * x + y * y + kRest * kRest) {}
};

/// Power of friction per unit of its limit, with derivatives by the velocity.
struct Dissipation {
  double value = 0.0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
};

double dissipationAt(const Support& support, const PlanarTwist& twist) {
  Eigen::Array2d sum = Eigen::Array2d::Zero();
  for (const Support::Points& points : support.points) {
    sum += points.share * Slip(points, twist).square.sqrt();
  }
  return sum.sum();
}

Eigen::Matrix3d symmetric(const Eigen::Array2d& xx, const Eigen::Array2d& xy, const Eigen::Array2d& yy,
                          const Eigen::Array2d& xz, const Eigen::Array2d& yz, const Eigen::Array2d& zz) {
  return (Eigen::Matrix3d() << xx.sum(), xy.sum(), xz.sum(), xy.sum(), yy.sum(), yz.sum(), xz.sum(), yz.sum(), zz.sum())
      .finished();
}

Dissipation differentiate(const Support& support, const PlanarTwist& twist) {
  Eigen::Array2d value = Eigen::Array2d::Zero();
  Eigen::Array2d along_x = value, along_y = value, along_turn = value;
  Eigen::Array2d xx = value, xy = value, yy = value, xz = value, yz = value, zz = value;
  for (const Support::Points& points : support.points) {
    const Slip slip(points, twist);
    const Eigen::Array2d inverse = 1.0 / slip.square;
    const Eigen::Array2d friction = points.share * slip.square.sqrt();
    const Eigen::Array2d part = friction * inverse;  // per unit of speed
    value += friction;
    const Eigen::Array2d x = part * slip.x;
    const Eigen::Array2d y = part * slip.y;
    along_x += x;
    along_y += y;
    along_turn += points.arm_x * y - points.arm_y * x;
    const Eigen::Array2d point_xx = part - x * slip.x * inverse;
    const Eigen::Array2d point_xy = -(x * slip.y * inverse);
    const Eigen::Array2d point_yy = part - y * slip.y * inverse;
    const Eigen::Array2d point_xz = points.arm_x * point_xy - points.arm_y * point_xx;
    const Eigen::Array2d point_yz = points.arm_x * point_yy - points.arm_y * point_xy;
    xx += point_xx;
    xy += point_xy;
    yy += point_yy;
    xz += point_xz;
    yz += point_yz;
    zz += points.arm_x * point_yz - points.arm_y * point_xz;
  }
  return {value.sum(), {along_x.sum(), along_y.sum(), along_turn.sum()}, symmetric(xx, xy, yy, xz, yz, zz)};
}

/// The matrix whose product with the velocity is the gradient of the dissipation.
Eigen::Matrix3d resistanceAt(const Support& support, const PlanarTwist& twist) {
  Eigen::Array2d xx = Eigen::Array2d::Zero();
  Eigen::Array2d xz = xx, yz = xx, zz = xx;
  for (const Support::Points& points : support.points) {
    const Eigen::Array2d part = points.share / Slip(points, twist).square.sqrt();
    xx += part;
    xz -= part * points.arm_y;
    yz += part * points.arm_x;
    zz += part * (points.arm_x * points.arm_x + points.arm_y * points.arm_y);
  }
  return symmetric(xx, Eigen::Array2d::Zero(), xx, xz, yz, zz);
}

/// Solves a system with a symmetric, positive definite matrix.
PlanarTwist solveSymmetric(const Eigen::Matrix3d& m, const Eigen::Vector3d& right) {
  const double xx = m(1, 1) * m(2, 2) - m(1, 2) * m(1, 2);
  const double xy = m(0, 2) * m(1, 2) - m(0, 1) * m(2, 2);
  const double xz = m(0, 1) * m(1, 2) - m(0, 2) * m(1, 1);
  const double yy = m(0, 0) * m(2, 2) - m(0, 2) * m(0, 2);
  const double yz = m(0, 1) * m(0, 2) - m(0, 0) * m(1, 2);
  const double zz = m(0, 0) * m(1, 1) - m(0, 1) * m(0, 1);
  const double determinant = m(0, 0) * xx + m(0, 1) * xy + m(0, 2) * xz;
  return Eigen::Vector3d(xx * right.x() + xy * right.y() + xz * right.z(),
                         xy * right.x() + yy * right.y() + yz * right.z(),
                         xz * right.x() + yz * right.y() + zz * right.z()) /
         determinant;
}

}  // namespace

void makeSupport(const planar::PlanarModel& model, Pressure pressure, Support& support) {
  constexpr double kSameHeight = 1e-3;  // m
  Points points;
  std::vector<const planar::PlanarShape*> lowest;
  for (const planar::PlanarShape& shape : model.shapes) {
    if (shape.band.low < model.band.low + kSameHeight) {
      lowest.push_back(&shape);
    }
  }
  if (lowest.size() == 1 && lowest.front()->isCircle()) {
    addDisc(lowest.front()->centre, lowest.front()->radius, pressure, points);
  } else {
    std::vector<Eigen::Vector2d> all;
    for (const planar::PlanarShape* shape : lowest) {
      const std::vector<Eigen::Vector2d> around = pointsAround(*shape);
      all.insert(all.end(), around.begin(), around.end());
    }
    std::vector<Eigen::Vector2d> outline;
    planar::findConvexHull(all, outline);
    addPolygon(outline, pressure, points);
  }
  centre(points);
  pack(points, support);
  support.resistance_at_rest = resistanceAt(support, PlanarTwist::Zero());
}

PlanarTwist velocityAfterFriction(const Support& support, const Eigen::Vector3d& inertia, const PlanarTwist& free,
                                  double most, const std::array<PlanarTwist, 2>& guesses) {
  constexpr int kMostIterations = 60;
  constexpr double kExact = 1e-6;  // of the largest impulse
  const auto valueAt = [&](const PlanarTwist& twist) {
    return 0.5 * (twist - free).dot(inertia.cwiseProduct(twist - free)) + most * dissipationAt(support, twist);
  };
  const auto withResistance = [&](const Eigen::Matrix3d& resistance) -> PlanarTwist {
    Eigen::Matrix3d damped = most * resistance;
    damped.diagonal() += inertia;
    return solveSymmetric(damped, inertia.cwiseProduct(free));
  };
  PlanarTwist twist = valueAt(guesses[0]) < valueAt(guesses[1]) ? guesses[0] : guesses[1];
  for (int i = 0; i < kMostIterations; ++i) {
    const Dissipation friction = differentiate(support, twist);
    const Eigen::Vector3d gradient = inertia.cwiseProduct(twist - free) + most * friction.gradient;
    if (gradient.cwiseAbs().maxCoeff() <= kExact * most) {
      break;
    }
    Eigen::Matrix3d curvature = most * friction.hessian;
    curvature.diagonal() += inertia;
    const PlanarTwist change = solveSymmetric(curvature, gradient);
    const double value = 0.5 * (twist - free).dot(inertia.cwiseProduct(twist - free)) + most * friction.value;
    const PlanarTwist newton = twist - change;
    const double newton_value = valueAt(newton);
    if (newton_value < value) {
      twist = newton;
      continue;
    }
    // Where an element comes to rest, Newton's step goes too far. Instead, the loop tries parts of it, and friction in
    // proportion to the velocity, which never goes too far: with the current factor, and with that of a body at rest.
    const std::array<PlanarTwist, 4> others{withResistance(support.resistance_at_rest), twist - 0.5 * change,
                                            twist - 0.125 * change, withResistance(resistanceAt(support, twist))};
    double least = value;
    const PlanarTwist before = twist;
    for (const PlanarTwist& other : others) {
      const double other_value = valueAt(other);
      if (other_value < least) {
        twist = other;
        least = other_value;
      }
    }
    if (twist == before) {
      break;  // as exact as rounding allows
    }
  }
  return twist;
}

}  // namespace swarmanoid::dynamics2d
