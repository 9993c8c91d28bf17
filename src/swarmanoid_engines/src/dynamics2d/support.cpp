#include "dynamics2d/support.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "planar/plane.hpp"

namespace swarmanoid::dynamics2d {
namespace {

/// Below this speed an element counts as at rest: friction grows with the speed there [m/s].
constexpr double kRest = 1e-6;

/// Of a disc: twelve points on each of three rings, or all of them on its rim.
void addDisc(const Eigen::Vector2d& centre, double radius, Pressure pressure, Support& support) {
  constexpr int kAround = 12;
  struct Ring {
    double radius;
    double share;
  };
  // of Gauss's rule along the radius: exact for friction that does not depend on the radius, or falls with it
  constexpr std::array<Ring, 3> kRings{
      {{0.1127016653792583, 0.0626120363218102}, {0.5, 0.4444444444444444}, {0.8872983346207417, 0.4929435192337454}}};
  const auto addRing = [&](const Ring& ring, double phase) {
    for (int i = 0; i < kAround; ++i) {
      const double angle = 2.0 * M_PI * (i + phase) / kAround;
      const Eigen::Vector2d arm = ring.radius * radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      support.points.push_back({centre + arm, ring.share / kAround});
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

/// The points at which a polynomial of the second degree has its mean over a triangle.
void addTriangle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, Support& support) {
  const double share = planar::cross(b - a, c - a) / 3.0;
  support.points.push_back({(4.0 * a + b + c) / 6.0, share});
  support.points.push_back({(a + 4.0 * b + c) / 6.0, share});
  support.points.push_back({(a + b + 4.0 * c) / 6.0, share});
}

void addPolygon(const std::vector<Eigen::Vector2d>& corners, Pressure pressure, Support& support) {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& corner : corners) {
    middle += corner / static_cast<double>(corners.size());
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d& a = corners[i];
    const Eigen::Vector2d& b = corners[(i + 1) % corners.size()];
    if (pressure == Pressure::kEdge) {
      support.points.push_back({a, 1.0});
    } else {
      const Eigen::Vector2d near_a = 0.5 * (middle + a);
      const Eigen::Vector2d near_b = 0.5 * (middle + b);
      const Eigen::Vector2d between = 0.5 * (a + b);
      addTriangle(middle, near_a, near_b, support);
      addTriangle(near_a, a, between, support);
      addTriangle(near_a, between, near_b, support);
      addTriangle(near_b, between, b, support);
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

void centre(Support& support) {
  double total = 0.0;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Support::Point& point : support.points) {
    total += point.share;
    middle += point.share * point.arm;
  }
  for (Support::Point& point : support.points) {
    point.arm -= middle / total;
    point.share /= total;
  }
}

/// The function whose minimum the velocity after friction is, with its derivatives.
struct Dissipation {
  double value = 0.0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d resistance = Eigen::Matrix3d::Zero();  ///< that gives the gradient, times the velocity
};

double dissipationAt(const Support& support, const PlanarTwist& twist) {
  double sum = 0.0;
  for (const Support::Point& point : support.points) {
    const double x = twist.x() - twist.z() * point.arm.y();
    const double y = twist.y() + twist.z() * point.arm.x();
    sum += point.share * std::sqrt(x * x + y * y + kRest * kRest);
  }
  return sum;
}

Dissipation differentiate(const Support& support, const PlanarTwist& twist) {
  Dissipation sum;
  Eigen::Matrix3d& hessian = sum.hessian;
  Eigen::Matrix3d& resistance = sum.resistance;
  for (const Support::Point& point : support.points) {
    const double arm_x = point.arm.x();
    const double arm_y = point.arm.y();
    const double x = twist.x() - twist.z() * arm_y;
    const double y = twist.y() + twist.z() * arm_x;
    const double square = x * x + y * y + kRest * kRest;
    const double speed = std::sqrt(square);
    const double part = point.share / speed;
    sum.value += part * square;
    sum.gradient += part * Eigen::Vector3d(x, y, arm_x * y - arm_y * x);
    const double xx = part * (1.0 - x * x / square);
    const double xy = -part * x * y / square;
    const double yy = part * (1.0 - y * y / square);
    hessian(0, 0) += xx;
    hessian(0, 1) += xy;
    hessian(1, 1) += yy;
    hessian(0, 2) += arm_x * xy - arm_y * xx;
    hessian(1, 2) += arm_x * yy - arm_y * xy;
    hessian(2, 2) += arm_y * arm_y * xx - 2.0 * arm_x * arm_y * xy + arm_x * arm_x * yy;
    resistance(0, 0) += part;
    resistance(0, 2) -= part * arm_y;
    resistance(1, 2) += part * arm_x;
    resistance(2, 2) += part * (arm_x * arm_x + arm_y * arm_y);
  }
  resistance(1, 1) = resistance(0, 0);
  for (Eigen::Matrix3d* matrix : {&hessian, &resistance}) {
    (*matrix)(1, 0) = (*matrix)(0, 1);
    (*matrix)(2, 0) = (*matrix)(0, 2);
    (*matrix)(2, 1) = (*matrix)(1, 2);
  }
  return sum;
}

/// Of a symmetric, positive definite matrix.
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
  support.points.clear();
  std::vector<const planar::PlanarShape*> lowest;
  for (const planar::PlanarShape& shape : model.shapes) {
    if (shape.band.low < model.band.low + kSameHeight) {
      lowest.push_back(&shape);
    }
  }
  if (lowest.size() == 1 && lowest.front()->isCircle()) {
    addDisc(lowest.front()->centre, lowest.front()->radius, pressure, support);
  } else {
    std::vector<Eigen::Vector2d> points;
    for (const planar::PlanarShape* shape : lowest) {
      const std::vector<Eigen::Vector2d> around = pointsAround(*shape);
      points.insert(points.end(), around.begin(), around.end());
    }
    std::vector<Eigen::Vector2d> outline;
    planar::findConvexHull(points, outline);
    addPolygon(outline, pressure, support);
  }
  centre(support);
  support.resistance_at_rest = differentiate(support, PlanarTwist::Zero()).resistance;
}

PlanarTwist velocityAfterFriction(const Support& support, const Eigen::Vector3d& inertia, const PlanarTwist& free,
                                  double most, const PlanarTwist& guess) {
  constexpr int kMostIterations = 60;
  constexpr double kExact = 1e-8;  // of the largest impulse
  const auto valueAt = [&](const PlanarTwist& twist) {
    return 0.5 * (twist - free).dot(inertia.cwiseProduct(twist - free)) + most * dissipationAt(support, twist);
  };
  const auto withResistance = [&](const Eigen::Matrix3d& resistance) -> PlanarTwist {
    Eigen::Matrix3d damped = most * resistance;
    damped.diagonal() += inertia;
    return solveSymmetric(damped, inertia.cwiseProduct(free));
  };
  PlanarTwist twist = guess;
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
    // Where an element comes to rest, Newton's step goes too far. Less of it is tried, and friction in proportion to
    // the velocity, which never goes too far: in the proportion that there is now, and in that of a body at rest.
    const std::array<PlanarTwist, 4> others{withResistance(support.resistance_at_rest), twist - 0.5 * change,
                                            twist - 0.125 * change, withResistance(friction.resistance)};
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
      break;  // as exact as numbers allow
    }
  }
  return twist;
}

}  // namespace swarmanoid::dynamics2d
