// The footbot's ring of infrared sensors.
#include "swarmanoid_interface/devices/footbot_proximity.hpp"

#include "proximity_ring.hpp"

namespace swarmanoid::devices {
namespace {

constexpr int kCount = FootbotProximity::kCount;

class FootbotProximitySensor : public ProximityRingSensor<FootbotProximitySensor, FootbotProximity, kCount> {
 public:
  static PluginDescription describe() {
    PluginDescription description =
        describeRing("24 infrared sensors around the body; a cubic polynomial of the distance.");
    description.implementation_aliases = {"generic_footbot_polynomial_proximity"};
    description.parameters.push_back(
        number("noise", "", "0", {0.0, 1.0}, "Half width of the uniform noise added to each reading."));
    return description;
  }

  void configure(const Configuration& parameters) override {
    ProximityRingSensor::configure(parameters);
    addErrorAlias("uniform", "value", "half_width", parameters.number("noise", 0.0));
  }

  static float& valueOf(ProximityInstance<FootbotProximity, kCount>& instance, std::size_t sensor) {
    return instance.readings->value[sensor];
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RING(swarmanoid::devices::FootbotProximitySensor)
