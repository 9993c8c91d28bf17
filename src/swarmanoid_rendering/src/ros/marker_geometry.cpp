#include "marker_geometry.hpp"

namespace swarmanoid {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using visualization_msgs::Marker;

Vector3d toVector(const geometry_msgs::Point& point) { return {point.x, point.y, point.z}; }

Tint toTint(const std_msgs::ColorRGBA& color) { return {color.r, color.g, color.b, color.a}; }

Isometry3d toIsometry(const geometry_msgs::Pose& pose) {
  const Eigen::Quaterniond turn(pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z);
  return Eigen::Translation3d(toVector(pose.position)) * turn.normalized();
}

/// A marker with its pose in W.
struct Placed {
  const Marker& marker;
  Isometry3d pose;
  Vector3d scale;

  Vector3d point(std::size_t index) const { return pose * toVector(marker.points[index]); }
  Isometry3d poseAt(std::size_t index) const { return pose * Eigen::Translation3d(toVector(marker.points[index])); }
  Tint tint(std::size_t index) const {
    return toTint(marker.colors.size() == marker.points.size() ? marker.colors[index] : marker.color);
  }
  std::size_t count() const { return marker.points.size(); }
};

/// @param step 2 if each line has its own two points, 1 if it begins at the end of the previous one
void addLines(const Placed& placed, std::size_t step, Geometry& geometry) {
  for (std::size_t from = 0; from + 1 < placed.count(); from += step) {
    if (placed.point(from) != placed.point(from + 1)) {
      geometry.addRod(placed.point(from), placed.point(from + 1), 0.5 * placed.scale.x(), placed.tint(from));
    }
  }
}

void addTriangles(const Placed& placed, Geometry& geometry) {
  const auto corner = [&](std::size_t index) {
    return placed.pose * toVector(placed.marker.points[index]).cwiseProduct(placed.scale);
  };
  for (std::size_t first = 0; first + 2 < placed.count(); first += 3) {
    geometry.addTriangle({corner(first), corner(first + 1), corner(first + 2)}, placed.tint(first));
  }
}

void addMesh(const Placed& placed, MeshFiles& meshes, Geometry& geometry) {
  for (const MeshFiles::Triangle& triangle : meshes.read(placed.marker.mesh_resource)) {
    std::array<Vector3d, 3> at;
    for (std::size_t corner = 0; corner < at.size(); ++corner) {
      at[corner] = placed.pose * triangle.corners[corner].cwiseProduct(placed.scale);
    }
    const bool has_own = placed.marker.mesh_use_embedded_materials != 0 && triangle.tint.has_value();
    geometry.addTriangle(at, has_own ? *triangle.tint : toTint(placed.marker.color));
  }
}

}  // namespace

void addMarker(const Marker& marker, const Isometry3d& frame, MeshFiles& meshes, Geometry& geometry) {
  if (marker.action != Marker::ADD) {
    return;
  }
  const Placed placed{marker, frame * toIsometry(marker.pose), {marker.scale.x, marker.scale.y, marker.scale.z}};
  const Tint tint = toTint(marker.color);
  switch (marker.type) {
    case Marker::CUBE:
      return geometry.addBox(placed.pose, placed.scale, tint);
    case Marker::SPHERE:
      return geometry.addEllipsoid(placed.pose, placed.scale, tint);
    case Marker::CYLINDER:
      return geometry.addCylinder(placed.pose, placed.scale, tint);
    case Marker::LINE_LIST:
      return addLines(placed, 2, geometry);
    case Marker::LINE_STRIP:
      return addLines(placed, 1, geometry);
    case Marker::TRIANGLE_LIST:
      return addTriangles(placed, geometry);
    case Marker::MESH_RESOURCE:
      return addMesh(placed, meshes, geometry);
    default:
      break;
  }
  for (std::size_t index = 0; index < placed.count(); ++index) {
    switch (marker.type) {
      case Marker::CUBE_LIST:
        geometry.addBox(placed.poseAt(index), placed.scale, placed.tint(index));
        break;
      case Marker::SPHERE_LIST:
        geometry.addEllipsoid(placed.poseAt(index), placed.scale, placed.tint(index));
        break;
      case Marker::POINTS:
        geometry.addBall(placed.point(index), 0.5 * placed.scale.x(), placed.tint(index));
        break;
      default:
        break;
    }
  }
}

}  // namespace swarmanoid
