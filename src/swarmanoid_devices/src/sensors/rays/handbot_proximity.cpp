// The proximity sensors in a handbot's palms.
#include "swarmanoid_interface/devices/handbot_proximity.hpp"

#include <array>

#include "common/parameters.hpp"
#include "hand_rays.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {
namespace {

struct PalmsInstance : BasicSensorInstance<HandbotProximity> {
  std::array<Mount, 2> palms;

  void archive(StateArchive& /*state*/) {}
};

class HandbotProximitySensor final : public SensorOf<HandbotProximity, PalmsInstance> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = HandbotProximity::kType;
    description.implementation = "polynomial";
    description.is_default = true;
    description.summary = "A short ray out of each palm; a cubic polynomial of the distance.";
    description.parameters = {number("range", "m", numberText(Proximity::kUsualRange), {0.001, 1.0},
                                     "Distance at which the response has fallen to 0.")};
    return description;
  }

  void configure(const Configuration& parameters) override { range_ = parameters.number("range"); }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      const PalmsInstance& instance = instances_[k];
      instance.readings->left = read(space, instance.row, instance.palms[0]);
      instance.readings->right = read(space, instance.row, instance.palms[1]);
    }
  }

 protected:
  void prepareInstance(const Space& space, PalmsInstance& instance) override {
    const EntityModel& model = *space.entities.model[instance.row];
    instance.palms = {model.mount("left_suction"), model.mount("right_suction")};
  }

  /// Draws the rays up to their hits, in the shade of the readings.
  void drawOne(const Space& space, const PalmsInstance& instance, DeviceDrawing& drawing) const override {
    const HandbotProximity& readings = delivered(instance);
    for (std::size_t hand = 0; hand < instance.palms.size(); ++hand) {
      const Eigen::Isometry3d palm = placeInWorld(space, instance.row, instance.palms[hand]);
      const auto [from, to] = rayFrom(palm);
      const Color shade = DeviceDrawing::shade(static_cast<double>(hand == 0 ? readings.left : readings.right));
      drawing.line(from, from + look(space, instance.row, palm) * (to - from), shade);
    }
  }

 private:
  Segment rayFrom(const Eigen::Isometry3d& palm) const {
    return {palm.translation(), palm * Eigen::Vector3d(range_, 0.0, 0.0)};
  }

  /// Fraction of the range at which the ray of a palm hits something; 1: no hit.
  double look(const Space& space, Row robot, const Eigen::Isometry3d& palm) const {
    RayBundle rays = bundleAround(robot, palm, range_);
    if (!space.mayHit(rays)) {
      return 1.0;
    }
    const Segment ray = rayFrom(palm);
    RayHit hit;
    rays.segments = Span<const Segment>(&ray, 1);
    space.raycast(rays, Span<RayHit>(&hit, 1));
    return hit.fraction;
  }
  float read(const Space& space, Row robot, const Mount& palm) const {
    return Proximity::response(look(space, robot, placeInWorld(space, robot, palm)));
  }

  double range_ = Proximity::kUsualRange;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::HandbotProximitySensor)
