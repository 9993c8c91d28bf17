/// A simulated colour-blob camera; FootbotCamera and EyebotCamera differ in their mounting and their field of view.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "color_blob_finder.hpp"
#include "overflow_notes.hpp"
#include "parameters.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {

template <class Camera>
struct CameraInstance : BasicSensorInstance<Camera> {
  std::vector<ColorBlob> buffer;
  Mount mount;
  OverflowNote overflow;
};

template <class Camera>
class ColorBlobCameraSensor : public SensorOf<Camera, CameraInstance<Camera>> {
 public:
  using Instance = CameraInstance<Camera>;

  void configure(const Configuration& parameters) override {
    range_ = parameters.number("range", 1.0);
    noise_distance_ = parameters.number("noise_distance", 0.0);
    noise_bearing_ = parameters.angle("noise_bearing", 0.0);
    max_blobs_ = static_cast<std::size_t>(parameters.integer("max_blobs", std::int64_t{128}));
    sees_floor_ = parameters.boolean("sees_floor", false);
    configureView(parameters);
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      senseOne(space, this->instances_[k]);
    }
  }

  void report(Space& space) override {
    for (Instance& instance : this->instances_) {
      noteOverflow(space, instance.row, Camera::kType, max_blobs_, "blobs", instance.readings->overflowed,
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
        number("range", "m", range, {0.0, 100.0}, "Horizontal distance beyond which nothing is seen, before noise."),
        number("noise_distance", "", "0", {0.0, 1.0}, "Standard deviation of the factor on each distance."),
        angle("noise_bearing", "0", {0.0, 90.0}, "Standard deviation added to each bearing."),
        integer("max_blobs", "128", {1.0, 10000.0}, "Blobs reported at the most in one tick, the nearest."),
        boolean("sees_floor", sees_floor, "Whether floor patches are seen.")};
    return description;
  }

  virtual void configureView(const Configuration&) {}
  virtual double slope() const { return 0.0; }

  std::size_t mostElements() const override { return max_blobs_; }

  void prepareInstance(const Space& space, Instance& instance) override {
    instance.buffer.resize(max_blobs_);
    instance.mount = space.entities.model[instance.row]->mount("camera");
  }

 private:
  void senseOne(const Space& space, Instance& instance) const {
    const Pose& pose = space.entities.pose[instance.row];
    BlobView view;
    view.self = instance.row;
    view.position = pose.toWorld(instance.mount.position);
    const Eigen::Vector3d ahead = pose.orientation * Eigen::Vector3d::UnitX();
    view.heading = std::atan2(ahead.y(), ahead.x());
    view.range = range_;
    view.slope = slope();
    view.sees_floor = sees_floor_;
    const FoundBlobs found = findBlobs(space, view, instance.buffer.data(), max_blobs_);
    instance.readings->overflowed = found.overflowed;
    instance.readings->blobs = Span<const ColorBlob>(instance.buffer.data(), found.count);
    if (noise_distance_ > 0.0 || noise_bearing_ > 0.0) {
      disturb(space, instance);
    }
  }

  void disturb(const Space& space, Instance& instance) const {
    instance.random.startTick(space.tick);
    for (std::size_t i = 0; i < instance.readings->blobs.size(); ++i) {
      ColorBlob& blob = instance.buffer[i];
      blob.distance = static_cast<float>(std::max(0.0, blob.distance * instance.random.gaussian(1.0, noise_distance_)));
      blob.bearing = toBearing(blob.bearing + instance.random.gaussian(0.0, noise_bearing_));
    }
  }

  double range_ = 1.0;
  double noise_distance_ = 0.0;
  double noise_bearing_ = 0.0;
  std::size_t max_blobs_ = 128;
  bool sees_floor_ = false;
};

}  // namespace swarmanoid::devices
