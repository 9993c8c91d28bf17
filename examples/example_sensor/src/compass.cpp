// The simulated compass: direction of north in the robot's frame, with noise.
#include "example_sensor/compass.hpp"

#include <cmath>

#include "swarmanoid_space/sensor.hpp"

class CompassSensor final : public swarmanoid::SensorOf<Compass> {
 public:
  static swarmanoid::PluginDescription describe() {
    swarmanoid::Parameter noise;
    noise.name = "noise";
    noise.type = swarmanoid::Parameter::Type::kAngle;
    noise.unit = "deg";
    noise.value = "0";
    noise.range = {0.0, 180.0};
    noise.description = "Standard deviation of each reading.";
    swarmanoid::PluginDescription description;
    description.label = Compass::kType;
    description.implementation = "default";
    description.is_default = true;
    description.summary = "Where north is, the y axis of the arena.";
    description.parameters = {noise};
    return description;
  }

  void configure(const swarmanoid::Configuration& parameters) override { noise_ = parameters.angle("noise", 0.0); }

  void sense(const swarmanoid::Space& space, std::size_t first, std::size_t last) override {
    for (std::size_t k = first; k < last; ++k) {
      auto& instance = instances_[k];
      const auto& pose = space.entities.pose[instance.row];
      const Eigen::Vector3d north = pose.orientation.conjugate() * Eigen::Vector3d::UnitY();
      instance.random.startTick(space.tick);
      const double error = noise_ > 0.0 ? instance.random.gaussian(0.0, noise_) : 0.0;
      instance.readings->north = std::remainder(std::atan2(north.y(), north.x()) + error, 2.0 * M_PI);
    }
  }

 private:
  double noise_ = 0.0;  // [rad]
};

REGISTER_SENSOR(CompassSensor)
