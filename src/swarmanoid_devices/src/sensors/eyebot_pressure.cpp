// The eyebot's barometer, zeroed at the robot's starting height.
#include "swarmanoid_interface/devices/eyebot_pressure.hpp"

#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid::devices {
namespace {

struct PressureInstance : BasicSensorInstance<EyebotPressure> {
  double start_height = 0.0;  // [m]

  void archive(StateArchive& state) { state(start_height); }
};

class EyebotPressureSensor final : public SensorOf<EyebotPressure, PressureInstance> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = EyebotPressure::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "The standard atmosphere, at rest.";
    return description;
  }

  void configure(const Configuration& /*parameters*/) override {}

  void sense(const Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      PressureInstance& instance = instances_[k];
      const double height = space.entities.pose[instance.row].position.z() - instance.start_height;
      instance.readings->difference = EyebotPressure::differenceAt(height);
    }
  }

 protected:
  void prepareInstance(const Space& space, PressureInstance& instance) override {
    instance.start_height = space.entities.pose[instance.row].position.z();
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::EyebotPressureSensor)
