// The infrared distance sensors of the eyebot: around it, upwards and downwards.
#include "swarmanoid_interface/devices/eyebot_distance.hpp"

#include "distance_ring.hpp"

namespace swarmanoid::devices {
namespace {

class EyebotDistanceSensor : public DistanceRingSensor<EyebotDistanceSensor, EyebotDistance, EyebotDistance::kCount> {
 public:
  static PluginDescription describe() {
    return describeRing("16 infrared sensors around the body, one upwards, one downwards; distance straight ahead.",
                        EyebotDistance::kUsualRange);
  }

  static float& valueOf(Instance& instance, std::size_t sensor) { return instance.readings->value(sensor); }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RING(swarmanoid::devices::EyebotDistanceSensor)
