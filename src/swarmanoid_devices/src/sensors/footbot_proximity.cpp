// Infrared proximity ring: one short ray a sensor; the response falls from 1 at contact to 0 at the range, as a cubic
// polynomial of the distance.
#include "swarmanoid_interface/devices/footbot_proximity.hpp"

#include <algorithm>
#include <array>

#include "parameters.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {
namespace {

constexpr std::size_t kCount = FootbotProximity::kCount;

/// The positions of the sensors on a model, in its body frame.
struct RingGeometry {
  Eigen::Matrix<double, 3, kCount> from;
  Eigen::Matrix<double, 3, kCount> direction;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0.0;  // of the sensors around the centre, m
};

RingGeometry ringOf(const EntityModel& model) {
  RingGeometry ring;
  for (std::size_t i = 0; i < kCount; ++i) {
    const Mount& mount = model.mount("proximity_" + std::to_string(i));
    ring.from.col(static_cast<Eigen::Index>(i)) = mount.position;
    ring.direction.col(static_cast<Eigen::Index>(i)) = mount.orientation * Eigen::Vector3d::UnitX();
  }
  ring.centre = ring.from.rowwise().mean();
  ring.radius = (ring.from.colwise() - ring.centre).colwise().norm().maxCoeff();
  return ring;
}

struct ProximityInstance : BasicSensorInstance<FootbotProximity> {
  std::shared_ptr<const RingGeometry> ring;
  bool is_clear = true;  // whether all readings are 0
};

class FootbotProximitySensor final : public SensorOf<FootbotProximity, ProximityInstance> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = FootbotProximity::kType;
    description.implementation = "polynomial";
    description.is_default = true;
    description.implementation_aliases = {"generic_footbot_polynomial_proximity"};
    description.summary = "24 infrared sensors around the body; a cubic polynomial of the distance.";
    description.robots = {"footbot"};
    description.parameters = {
        number("range", "m", "0.1", {0.001, 1.0}, "Distance at which the response has fallen to 0."),
        number("noise", "", "0", {0.0, 1.0}, "Half width of the uniform noise added to each reading.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    range_ = parameters.number("range", 0.1);
    noise_ = parameters.number("noise", 0.0);
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      senseOne(space, instances_[k]);
      if (noise_ > 0.0) {
        disturb(space, instances_[k]);
      }
    }
  }

 protected:
  void prepareInstance(const Space& space, ProximityInstance& instance) override {
    const EntityModel* model = space.entities.model[static_cast<std::size_t>(instance.row)].get();
    if (model != last_model_) {
      last_model_ = model;
      last_ring_ = std::make_shared<RingGeometry>(ringOf(*model));
    }
    instance.ring = last_ring_;
  }

 private:
  void senseOne(const Space& space, ProximityInstance& instance) const {
    const RingGeometry& ring = *instance.ring;
    const Pose& pose = space.entities.pose[static_cast<std::size_t>(instance.row)];
    RayBundle rays;
    rays.centre = pose.toWorld(ring.centre);
    rays.radius = ring.radius + range_;
    rays.ignored = instance.row;
    if (!space.mayHit(rays)) {
      if (!instance.is_clear) {
        instance.readings->value.fill(0.0F);
        instance.is_clear = true;
      }
      return;
    }
    instance.is_clear = false;
    const Eigen::Matrix3d rotation = pose.orientation.toRotationMatrix();
    std::array<Segment, kCount> segments;
    std::array<RayHit, kCount> hits;
    const Eigen::Matrix<double, 3, kCount> from = (rotation * ring.from).colwise() + pose.position;
    const Eigen::Matrix<double, 3, kCount> to = from + (range_ * rotation) * ring.direction;
    for (std::size_t i = 0; i < kCount; ++i) {
      segments[i] = {from.col(static_cast<Eigen::Index>(i)), to.col(static_cast<Eigen::Index>(i))};
    }
    rays.segments = Span<const Segment>(segments.data(), kCount);
    space.raycast(rays, Span<RayHit>(hits.data(), kCount));
    for (std::size_t i = 0; i < kCount; ++i) {
      const double closeness = 1.0 - hits[i].fraction;
      instance.readings->value[i] = static_cast<float>(closeness * closeness * closeness);
    }
  }

  void disturb(const Space& space, ProximityInstance& instance) const {
    instance.random.startTick(space.tick);
    instance.is_clear = false;
    for (float& value : instance.readings->value) {
      value = static_cast<float>(std::clamp(value + instance.random.uniform(-noise_, noise_), 0.0, 1.0));
    }
  }

  double range_ = 0.1;
  double noise_ = 0.0;
  const EntityModel* last_model_ = nullptr;
  std::shared_ptr<const RingGeometry> last_ring_;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::FootbotProximitySensor)
