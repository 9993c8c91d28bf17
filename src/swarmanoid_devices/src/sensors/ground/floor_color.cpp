// The floor colour sensor of any robot.
#include "swarmanoid_interface/devices/floor_color.hpp"

#include "common/parameters.hpp"
#include "surroundings/way_to_ground.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {
namespace {

struct FloorColorInstance : BasicSensorInstance<FloorColor> {
  Eigen::Vector3d spot = Eigen::Vector3d(0.0, 0.0, FloorColor::kHeight);  // in the body frame, m
  Eigen::Vector3d direction = -Eigen::Vector3d::UnitZ();                  // in the body frame, of length 1

  void archive(StateArchive& /*state*/) {}
};

class FloorColorSensor final : public SensorOf<FloorColor, FloorColorInstance> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = FloorColor::kType;
    description.implementation = "rgb";
    description.is_default = true;
    description.summary = "The colour of the topmost layer: paint, patch, image or bare floor.";
    description.parameters = {number("range", "m", numberText(FloorColor::kUsualRange), {0.001, 1.0},
                                     "Distance beyond which there is no ground.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    range_ = parameters.number("range", FloorColor::kUsualRange);
  }

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      senseOne(space, instances_[k]);
    }
  }

 protected:
  void prepareInstance(const Space& space, FloorColorInstance& instance) override {
    const auto& mounts = space.entities.model[instance.row]->mounts;
    const auto link = mounts.find(FloorColor::kLink);
    if (link != mounts.end()) {
      instance.spot = link->second.position;
      instance.direction = link->second.orientation * Eigen::Vector3d::UnitX();
    }
  }

 private:
  void senseOne(const Space& space, FloorColorInstance& instance) const {
    const Pose& pose = space.entities.pose[instance.row];
    const Eigen::Vector3d spot = pose.toWorld(instance.spot);
    const Eigen::Vector3d direction = pose.orientation * instance.direction;
    const double way = wayToGround(space, spot, direction, range_);
    instance.readings->color =
        way == kInfinity ? colors::kBlack : space.floor.colorAt(spot + way * direction, space.tick);
  }

  double range_ = FloorColor::kUsualRange;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::FloorColorSensor)
