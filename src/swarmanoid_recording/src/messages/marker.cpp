#include "marker.hpp"

#include "swarmanoid_recording/messages/world_state.hpp"

namespace swarmanoid {

using visualization_msgs::Marker;

std_msgs::ColorRGBA rgba(float red, float green, float blue, float alpha) {
  std_msgs::ColorRGBA color;
  color.r = red;
  color.g = green;
  color.b = blue;
  color.a = alpha;
  return color;
}

std_msgs::ColorRGBA opaque(Color color) {
  return rgba(static_cast<float>(color.red) / 255.0F, static_cast<float>(color.green) / 255.0F,
              static_cast<float>(color.blue) / 255.0F, 1.0F);
}

Marker makeMarker(const std_msgs::Header& header, const std::string& space_name, int id, int type,
                  const Eigen::Vector3d& scale, const std_msgs::ColorRGBA& color) {
  Marker marker;
  marker.header = header;
  marker.ns = space_name;
  marker.id = id;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = scale.x();
  marker.scale.y = scale.y();
  marker.scale.z = scale.z();
  marker.color = color;
  return marker;
}

void deleteIfEmpty(Marker& list) {
  list.action = list.points.empty() ? static_cast<int>(Marker::DELETE) : static_cast<int>(Marker::ADD);
}

Marker shapeMarker(const std_msgs::Header& header, const std::string& space_name, int id, const CollisionShape& shape,
                   const Pose& pose, const std_msgs::ColorRGBA& color) {
  int type = Marker::CUBE;
  if (shape.kind == CollisionShape::Kind::kCylinder) {
    type = Marker::CYLINDER;
  } else if (shape.kind == CollisionShape::Kind::kSphere) {
    type = Marker::SPHERE;
  }
  Marker marker = makeMarker(header, space_name, id, type, 2.0 * shape.half_extent, color);
  Pose place;
  place.position = pose.toWorld(shape.position);
  place.orientation = pose.orientation * shape.orientation;
  marker.pose = toMessage(place);
  return marker;
}

}  // namespace swarmanoid
