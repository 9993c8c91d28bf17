// Bodies of robots from their URDF. They move with their frames, so they are sent only once.
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <map>

#include "marker.hpp"
#include "swarmanoid_experiment_files/robots/read_urdf.hpp"
#include "swarmanoid_recording/messages/transforms.hpp"
#include "swarmanoid_recording/messages/world_state.hpp"

namespace swarmanoid {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/// @return false if no marker has this shape
bool setShape(const urdf::Geometry& geometry, Marker& marker) {
  switch (geometry.type) {
    case urdf::Geometry::BOX: {
      const auto& box = static_cast<const urdf::Box&>(geometry);
      marker.type = Marker::CUBE;
      marker.scale.x = box.dim.x;
      marker.scale.y = box.dim.y;
      marker.scale.z = box.dim.z;
      return true;
    }
    case urdf::Geometry::CYLINDER: {
      const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
      marker.type = Marker::CYLINDER;
      marker.scale.x = 2.0 * cylinder.radius;
      marker.scale.y = 2.0 * cylinder.radius;
      marker.scale.z = cylinder.length;
      return true;
    }
    case urdf::Geometry::SPHERE: {
      const auto& sphere = static_cast<const urdf::Sphere&>(geometry);
      marker.type = Marker::SPHERE;
      marker.scale.x = marker.scale.y = marker.scale.z = 2.0 * sphere.radius;
      return true;
    }
    case urdf::Geometry::MESH: {
      const auto& mesh = static_cast<const urdf::Mesh&>(geometry);
      marker.type = Marker::MESH_RESOURCE;
      marker.mesh_resource = mesh.filename;
      marker.mesh_use_embedded_materials = 1;
      marker.scale.x = mesh.scale.x;
      marker.scale.y = mesh.scale.y;
      marker.scale.z = mesh.scale.z;
      return true;
    }
    default:
      return false;
  }
}

/// A marker and the link of its frame; "": the body frame.
struct Part {
  Marker marker;
  std::string link;
};

/// Returns one part for each visual element, without name and id. Links that joints turn have their own frames, the
/// others use the body frame.
std::vector<Part> bodyOf(const EntityModel& model) {
  std::vector<Part> body;
  const urdf::ModelInterfaceSharedPtr robot = urdf::parseURDF(model.urdf);
  for (const auto& [name, link] : robot->links_) {
    for (const urdf::VisualSharedPtr& visual : link->visual_array) {
      Marker marker = makeMarker({}, "robots", 0, Marker::CUBE, Eigen::Vector3d::Ones(), rgba(0.6F, 0.6F, 0.6F, 1.0F));
      if (visual->geometry == nullptr || !setShape(*visual->geometry, marker)) {
        continue;
      }
      if (visual->material != nullptr) {
        const urdf::Color& color = visual->material->color;
        marker.color = rgba(color.r, color.g, color.b, color.a);
      }
      const int joint = model.mount(name).joint;
      Mount place = chain(model.mount(name), toMount(visual->origin));
      if (joint >= 0) {
        place = chain(inverse(model.joints[static_cast<std::size_t>(joint)].frame), place);
      }
      marker.pose = toMessage(Pose{place.position, place.orientation});
      marker.frame_locked = 1;
      body.push_back({marker, joint < 0 ? "" : model.joints[static_cast<std::size_t>(joint)].link});
    }
  }
  return body;
}

}  // namespace

bool hasFewRobots(const Space& space) {
  std::size_t count = 0;
  for (const Row row : space.entities.order) {
    count += space.entities.model[row]->is_robot ? 1 : 0;
  }
  return count <= Transforms::kFewRobots;
}

void addRobotBodies(const Space& space, MarkerArray& markers) {
  if (!hasFewRobots(space)) {
    return;
  }
  std::map<std::string, std::vector<Part>> bodies;
  int id = 0;
  for (const Row row : space.entities.order) {
    const EntityModel& model = *space.entities.model[row];
    if (!model.is_robot || model.urdf.empty()) {
      continue;
    }
    const auto [body, is_new] = bodies.try_emplace(model.type);
    if (is_new) {
      body->second = bodyOf(model);
    }
    for (const Part& part : body->second) {
      // no stamp: the marker follows the frame's latest pose
      const std::string& name = space.entities.name[row];
      markers.markers.push_back(part.marker);
      markers.markers.back().header.frame_id = part.link.empty() ? frameOf(name) : frameOf(name, part.link);
      markers.markers.back().id = id++;
    }
  }
}

}  // namespace swarmanoid
