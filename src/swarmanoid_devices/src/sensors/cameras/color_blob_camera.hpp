/// Base class of simulated colour-blob cameras. They differ in position, direction and shape of the field of view
/// (field_of_view.hpp). A camera that sees all around consists of its struct and
///
///     class MyCameraSensor : public ColorBlobCameraSensor<MyCamera, RingView> {
///      public:
///       static PluginDescription describe() { ... }
///     };
///     REGISTER_CAMERA(swarmanoid::devices::MyCameraSensor)
///
/// with REGISTER_CAMERA of unreliable_camera.hpp. A camera with a lens takes a few lines more (lens_camera.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "common/keep_nearest.hpp"
#include "common/overflow_notes.hpp"
#include "common/parameters.hpp"
#include "surroundings/color_blob_finder.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {

template <class Camera>
struct CameraInstance : BasicSensorInstance<Camera> {
  std::vector<ColorBlob> buffer;
  Mount mount;
  OverflowNote overflow;

  void archive(StateArchive& state) {
    archiveSpan(state, *this->readings, buffer);
    state(overflow);
  }
};

/// @tparam View a FieldOfView
template <class Camera, class View>
class ColorBlobCameraSensor : public SensorOf<Camera, CameraInstance<Camera>> {
 public:
  using Instance = CameraInstance<Camera>;

  void configure(const Configuration& parameters) override {
    range_ = parameters.number("range", 1.0);
    noise_distance_ = parameters.number("noise_distance", 0.0);
    noise_bearing_ = parameters.angle("noise_bearing", 0.0);
    max_blobs_ = static_cast<std::size_t>(parameters.integer("max_blobs", std::int64_t{128}));
    sees_floor_ = parameters.boolean("sees_floor", false);
    field_ = makeView(parameters);
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      senseOne(space, this->instances_[k]);
    }
  }

  void report(const Space& space, const ReportAccess& access) override {
    for (Instance& instance : this->instances_) {
      noteOverflow(space, access, instance.row, Camera::kType, max_blobs_, "blobs", instance.readings->overflowed,
                   instance.overflow);
    }
  }

 protected:
  static PluginDescription describeCamera(const std::string& range, const std::string& sees_floor) {
    PluginDescription description;
    description.label = Camera::kType;
    description.implementation = "color_blobs";
    description.is_default = true;
    description.parameters = {
        number("range", "m", range, {0.0, 100.0}, "Maximum horizontal distance, before noise."),
        number("noise_distance", "", "0", {0.0, 1.0}, "Standard deviation of the factor on each distance."),
        angle("noise_bearing", "0", {0.0, 90.0}, "Standard deviation added to each bearing."),
        integer("max_blobs", "128", {1.0, 10000.0}, "Blobs reported at the most in one tick, the nearest."),
        boolean("sees_floor", sees_floor, "Whether floor patches are seen.")};
    return description;
  }

  virtual View makeView(const Configuration& /*parameters*/) const { return View(); }
  /// The link that carries the camera.
  virtual const char* link() const { return "camera"; }
  /// Orientation of the camera in the robot's frame; x is the optical axis.
  virtual Eigen::Quaterniond orientationOf(const Space& /*space*/, const Instance& instance) const {
    return instance.mount.orientation;
  }
  /// Applies the camera's filter to the sightings.
  virtual void filter(const Space& /*space*/, Instance& /*instance*/, const BlobView& /*view*/,
                      std::vector<Sighting>& /*found*/) const {}

  std::size_t mostElements() const override { return max_blobs_; }

  void prepareInstance(const Space& space, Instance& instance) override {
    instance.buffer.resize(max_blobs_);
    instance.mount = space.entities.model[instance.row]->mount(link());
  }

  /// Draws the field of view, and for each reported blob a line in its colour to its position.
  void drawOne(const Space& space, const Instance& instance, DeviceDrawing& drawing) const override {
    const Eye eye = viewOf(space, instance).eye;
    field_.draw(eye, range_, drawing);
    for (const ColorBlob& blob : this->delivered(instance).blobs) {
      // without a distance, the line ends at the range
      const double way = std::isfinite(blob.distance) ? blob.distance : range_ * std::cos(blob.elevation);
      const double angle = std::atan2(eye.forward.y(), eye.forward.x()) + blob.bearing;
      const Eigen::Vector3d end =
          eye.position + way * Eigen::Vector3d(std::cos(angle), std::sin(angle), std::tan(blob.elevation));
      drawing.line(eye.position, end, blob.color);
      drawing.point(end, blob.color);
    }
  }

 private:
  BlobView viewOf(const Space& space, const Instance& instance) const {
    const Pose& pose = space.entities.pose[instance.row];
    BlobView view;
    view.self = instance.row;
    view.eye.position = pose.toWorld(instance.mount.position);
    const Eigen::Vector3d ahead = pose.orientation * Eigen::Vector3d::UnitX();
    if (!ahead.head<2>().isZero(0.0)) {  // unless the robot's x axis is vertical
      view.eye.forward = ahead.head<2>().normalized();
    }
    view.eye.orientation = pose.orientation * orientationOf(space, instance);
    view.eye.height = view.eye.position.z() - space.lowestGround();
    view.range = range_;
    view.field = &field_;
    view.sees_floor = sees_floor_;
    return view;
  }

  void senseOne(const Space& space, Instance& instance) const {
    thread_local std::vector<Sighting> found;  // kept between calls so that a steady state allocates nothing
    const BlobView view = viewOf(space, instance);
    found.reserve(max_blobs_);
    lookAround(space, view, found);
    instance.random.startTick(space.tick);
    filter(space, instance, view, found);
    instance.readings->overflowed =
        keepNearest(found, max_blobs_, [](const Sighting& sighting) { return sighting.distance; });
    toBlobs(found, view.eye, field_.knowsDistance(), {instance.buffer.data(), found.size()});
    instance.readings->blobs = Span<const ColorBlob>(instance.buffer.data(), found.size());
    if (noise_distance_ > 0.0 || noise_bearing_ > 0.0) {
      disturb(instance);
    }
  }

  void disturb(Instance& instance) const {
    for (std::size_t i = 0; i < instance.readings->blobs.size(); ++i) {
      ColorBlob& blob = instance.buffer[i];
      const double distance = blob.distance * instance.random.gaussian(1.0, noise_distance_);
      if (field_.knowsDistance()) {
        blob.distance = static_cast<float>(std::max(0.0, distance));
      }
      blob.bearing = toBearing(blob.bearing + instance.random.gaussian(0.0, noise_bearing_));
    }
  }

  double range_ = 1.0;
  double noise_distance_ = 0.0;
  double noise_bearing_ = 0.0;
  std::size_t max_blobs_ = 128;
  bool sees_floor_ = false;
  View field_;
};

}  // namespace swarmanoid::devices
