#include "swarmanoid_rendering/geometry.hpp"

#include <cmath>

namespace swarmanoid {
namespace {

using Eigen::Vector3d;

constexpr double kTurn = 2.0 * M_PI;
constexpr int kSides = 40;  // of a circle that is approximated by triangles

Vector3d onCircle(int side) {
  const double angle = kTurn * side / kSides;
  return {0.5 * std::cos(angle), 0.5 * std::sin(angle), 0.0};
}

}  // namespace

void Geometry::addTriangle(const std::array<Vector3d, 3>& at, const Tint& tint) {
  const auto first = static_cast<std::uint32_t>(corners.size());
  for (const Vector3d& corner : at) {
    corners.emplace_back(corner.cast<float>());
  }
  triangles.push_back({first, first + 1, first + 2});
  triangle_tints.push_back(tint);
}

void Geometry::addBall(const Vector3d& middle, double radius, const Tint& tint) {
  balls.emplace_back();
  balls.back() << middle.cast<float>(), static_cast<float>(radius);
  ball_tints.push_back(tint);
}

void Geometry::addRod(const Vector3d& from, const Vector3d& to, double radius, const Tint& tint) {
  for (const Vector3d& end : {from, to}) {
    rods.emplace_back();
    rods.back() << end.cast<float>(), static_cast<float>(radius);
  }
  rod_tints.push_back(tint);
}

void Geometry::addBox(const Eigen::Isometry3d& pose, const Vector3d& size, const Tint& tint) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-0.5, 0.5}) {
      std::array<Vector3d, 4> face;
      for (std::size_t corner = 0; corner < face.size(); ++corner) {
        Vector3d at;
        at[axis] = side;
        at[(axis + 1) % 3] = corner == 0 || corner == 3 ? -0.5 : 0.5;
        at[(axis + 2) % 3] = corner < 2 ? -0.5 : 0.5;
        face[corner] = pose * at.cwiseProduct(size);
      }
      addTriangle({face[0], face[1], face[2]}, tint);
      addTriangle({face[0], face[2], face[3]}, tint);
    }
  }
}

void Geometry::addCylinder(const Eigen::Isometry3d& pose, const Vector3d& size, const Tint& tint) {
  const auto place = [&](const Vector3d& circle, double height) {
    return pose * (circle + Vector3d(0.0, 0.0, height)).cwiseProduct(size);
  };
  for (int side = 0; side < kSides; ++side) {
    const Vector3d from = onCircle(side);
    const Vector3d to = onCircle(side + 1);
    addTriangle({place(from, -0.5), place(to, -0.5), place(to, 0.5)}, tint);
    addTriangle({place(from, -0.5), place(to, 0.5), place(from, 0.5)}, tint);
    for (const double end : {-0.5, 0.5}) {
      addTriangle({place(Vector3d::Zero(), end), place(from, end), place(to, end)}, tint);
    }
  }
}

void Geometry::addEllipsoid(const Eigen::Isometry3d& pose, const Vector3d& size, const Tint& tint) {
  if (size.maxCoeff() == size.minCoeff()) {
    addBall(pose.translation(), 0.5 * size.x(), tint);
    return;
  }
  constexpr int kRings = kSides / 2;
  const auto place = [&](int ring, int side) {
    const double angle = 0.5 * kTurn * ring / kRings;  // from the top
    const Vector3d at = std::sin(angle) * onCircle(side) + Vector3d(0.0, 0.0, 0.5 * std::cos(angle));
    return pose * at.cwiseProduct(size);
  };
  for (int ring = 0; ring < kRings; ++ring) {
    for (int side = 0; side < kSides; ++side) {
      addTriangle({place(ring, side), place(ring, side + 1), place(ring + 1, side)}, tint);
      addTriangle({place(ring, side + 1), place(ring + 1, side + 1), place(ring + 1, side)}, tint);
    }
  }
}

}  // namespace swarmanoid
