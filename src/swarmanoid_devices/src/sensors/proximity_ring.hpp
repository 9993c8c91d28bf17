/// What all rings of infrared proximity sensors have in common: one short ray a sensor; the response falls from 1 at
/// contact to 0 at the range, as a cubic polynomial of the distance where an implementation states no other law.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "mechanisms.hpp"
#include "parameters.hpp"
#include "swarmanoid_interface/devices/proximity.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {

/// The positions of the sensors on a model, in its body frame. @tparam count of them, or Eigen::Dynamic
template <int count>
struct RingGeometry {
  static constexpr int kMost = count == Eigen::Dynamic ? static_cast<int>(Proximity::kMostSensors) : count;
  using Points = Eigen::Matrix<double, 3, count, 0, 3, kMost>;  // never on the heap

  Points from;
  Points direction;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0.0;  // of the sensors around the centre, m

  std::size_t size() const { return static_cast<std::size_t>(from.cols()); }
};

/// @throws ConfigError if the model has none, or more than there may be
template <int count>
RingGeometry<count> ringOf(const EntityModel& model, const char* device) {
  const auto linkOf = [](Eigen::Index i) { return "proximity_" + std::to_string(i); };
  Eigen::Index found = 0;
  while (model.mounts.count(linkOf(found)) > 0) {
    ++found;
  }
  const bool is_right = count == Eigen::Dynamic ? found > 0 && found <= RingGeometry<count>::kMost : found >= count;
  if (!is_right) {
    refuseWithout(device, model,
                  count == Eigen::Dynamic
                      ? "links proximity_0, ... (1 to " + std::to_string(Proximity::kMostSensors) + ")"
                      : std::to_string(count) + " links proximity_0, ...");
  }
  RingGeometry<count> ring;
  if constexpr (count == Eigen::Dynamic) {
    ring.from.resize(3, found);
    ring.direction.resize(3, found);
  }
  for (Eigen::Index i = 0; i < ring.from.cols(); ++i) {
    const Mount& mount = model.mount(linkOf(i));
    ring.from.col(i) = mount.position;
    ring.direction.col(i) = mount.orientation * Eigen::Vector3d::UnitX();
  }
  ring.centre = ring.from.rowwise().mean();
  ring.radius = (ring.from.colwise() - ring.centre).colwise().norm().maxCoeff();
  return ring;
}

template <class Device, int count>
struct ProximityInstance : BasicSensorInstance<Device> {
  std::shared_ptr<const RingGeometry<count>> ring;
  bool is_clear = true;  // whether all readings are 0
};

/// `Ring` derives from this, and has `static float& valueOf(Instance&, std::size_t)`, where the reading of a sensor is.
/// Another law than the polynomial is a `static float response(double fraction)` of its own, as the one here.
template <class Ring, class Device, int count, class Instance = ProximityInstance<Device, count>>
class ProximityRingSensor : public SensorOf<Device, Instance> {
 public:
  /// @param fraction of the range at which something is: 0 at contact, 1 at the range or beyond
  /// @return from 0 to 1; 0 at the range, which is read too where nothing is near
  static float response(double fraction) { return Proximity::response(fraction); }

  void configure(const Configuration& parameters) override {
    range_ = parameters.number("range", Proximity::kUsualRange);
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      senseOne(space, this->instances_[k]);
    }
  }

 protected:
  /// @param implementation its name; the polynomial is used where an experiment names none
  static PluginDescription describeRing(const std::string& summary, const std::string& implementation = "polynomial") {
    PluginDescription description;
    description.label = Device::kType;
    description.implementation = implementation;
    description.is_default = implementation == "polynomial";
    description.summary = summary;
    description.parameters = {number("range", "m", numberText(Proximity::kUsualRange), {0.001, 1.0},
                                     "Distance at which the response has fallen to 0.")};
    return description;
  }

  void prepareInstance(const Space& space, Instance& instance) override {
    const EntityModel* model = space.entities.model[instance.row].get();
    if (model != last_model_) {
      last_ring_ = std::make_shared<RingGeometry<count>>(ringOf<count>(*model, Device::kType));
      last_model_ = model;
    }
    instance.ring = last_ring_;
  }

 private:
  void senseOne(const Space& space, Instance& instance) const {
    const RingGeometry<count>& ring = *instance.ring;
    const std::size_t size = ring.size();
    const Pose& pose = space.entities.pose[instance.row];
    RayBundle rays;
    rays.centre = pose.toWorld(ring.centre);
    rays.radius = ring.radius + range_;
    rays.ignored = instance.row;
    if (!space.mayHit(rays)) {
      for (std::size_t i = 0; !instance.is_clear && i < size; ++i) {
        Ring::valueOf(instance, i) = 0.0F;
      }
      instance.is_clear = true;
      return;
    }
    instance.is_clear = false;
    const Eigen::Matrix3d rotation = pose.orientation.toRotationMatrix();
    std::array<Segment, RingGeometry<count>::kMost> segments;
    std::array<RayHit, RingGeometry<count>::kMost> hits;
    const typename RingGeometry<count>::Points from = (rotation * ring.from).colwise() + pose.position;
    const typename RingGeometry<count>::Points to = from + (range_ * rotation) * ring.direction;
    for (std::size_t i = 0; i < size; ++i) {
      segments[i] = {from.col(static_cast<Eigen::Index>(i)), to.col(static_cast<Eigen::Index>(i))};
    }
    rays.segments = Span<const Segment>(segments.data(), size);
    space.raycast(rays, Span<RayHit>(hits.data(), size));
    for (std::size_t i = 0; i < size; ++i) {
      Ring::valueOf(instance, i) = Ring::response(hits[i].fraction);
    }
  }

  double range_ = Proximity::kUsualRange;
  const EntityModel* last_model_ = nullptr;
  std::shared_ptr<const RingGeometry<count>> last_ring_;
};

}  // namespace swarmanoid::devices
