// The handbot's ring of infrared distance sensors.
#include "swarmanoid_interface/devices/handbot_distance.hpp"

#include "distance_ring.hpp"

namespace swarmanoid::devices {
namespace {

class HandbotDistanceSensor
    : public DistanceRingSensor<HandbotDistanceSensor, HandbotDistance, HandbotDistance::kCount> {
 public:
  static PluginDescription describe() {
    return describeRing("12 infrared sensors around the body; distance straight ahead.", HandbotDistance::kUsualRange);
  }

  static float& valueOf(Instance& instance, std::size_t sensor) { return instance.readings->value(sensor); }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RING(swarmanoid::devices::HandbotDistanceSensor)
