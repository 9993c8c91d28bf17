#include "swarmanoid_rendering/world_view.hpp"

#include <tf2/buffer_core.h>

#include "marker_geometry.hpp"
#include "swarmanoid_recording/messages/markers.hpp"
#include "swarmanoid_recording/messages/transforms.hpp"
#include "swarmanoid_recording/messages/world_state.hpp"

namespace swarmanoid {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

class WorldView::Markers {
 public:
  explicit Markers(bool has_textures) : has_textures_(has_textures), transforms_(TransformLevel::kFull) {}

  void follow(const Space& space) { is_arena_due_ = changes_.look(space) || is_arena_due_; }

  void show(const Space& space, RayTracer& tracer) {
    if (is_arena_due_) {
      takeArena(space, tracer);
      is_arena_due_ = false;
    }
    if (!bodies_.empty()) {
      takeFrames(transforms_.moving(space), kMoves);
    }
    Geometry moving;
    for (const Marker& body : bodies_) {
      addMarker(body, placeOf(body.header.frame_id), meshes_, moving);
    }
    for (const Marker& marker : moving_.draw(space).markers) {
      if (marker.ns != "label_lines") {  // lines to texts, which are not drawn
        addMarker(marker, Eigen::Isometry3d::Identity(), meshes_, moving);
      }
    }
    tracer.set(RayTracer::Part::kMoving, std::move(moving));
  }

 private:
  static constexpr bool kStays = true;
  static constexpr bool kMoves = false;

  void takeArena(const Space& space, RayTracer& tracer) {
    frames_.clear();
    bodies_.clear();
    Geometry fixed;
    for (const Marker& marker : arenaMarkers(space).markers) {
      if (marker.ns == "floor_image" && !has_textures_) {
        continue;
      }
      if (marker.header.frame_id == kWorldFrame) {
        addMarker(marker, Eigen::Isometry3d::Identity(), meshes_, fixed);
      } else {
        bodies_.push_back(marker);
      }
    }
    tracer.set(RayTracer::Part::kFixed, std::move(fixed));
    if (!bodies_.empty()) {
      takeFrames(transforms_.fixed(space), kStays);
    }
  }

  void takeFrames(const tf2_msgs::TFMessage& message, bool stays) {
    for (const geometry_msgs::TransformStamped& transform : message.transforms) {
      frames_.setTransform(transform, "space", stays);
    }
  }

  /// @throws tf2::TransformException
  Eigen::Isometry3d placeOf(const std::string& frame) const {
    const geometry_msgs::Transform place = frames_.lookupTransform(kWorldFrame, frame, ros::Time(0)).transform;
    const Eigen::Quaterniond turn(place.rotation.w, place.rotation.x, place.rotation.y, place.rotation.z);
    return Eigen::Translation3d(place.translation.x, place.translation.y, place.translation.z) * turn;
  }

  bool has_textures_;
  OutsideChanges changes_;
  bool is_arena_due_ = false;
  Transforms transforms_;
  MovingMarkers moving_;
  std::vector<Marker> bodies_;  // links of robots, in the frames of the links
  tf2::BufferCore frames_;
  MeshFiles meshes_;
};

WorldView::WorldView(bool has_textures) : markers_(std::make_unique<Markers>(has_textures)) {}
WorldView::~WorldView() = default;

void WorldView::follow(const Space& space) { markers_->follow(space); }
void WorldView::show(const Space& space, RayTracer& tracer) { markers_->show(space, tracer); }

}  // namespace swarmanoid
