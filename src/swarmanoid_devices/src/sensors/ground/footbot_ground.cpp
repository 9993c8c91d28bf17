// The footbot's ground sensors, around the body and between the wheels.
#include "swarmanoid_interface/devices/footbot_ground.hpp"

#include "printed_floor.hpp"

namespace swarmanoid::devices {
namespace {

class FootbotGroundSensor : public GroundSpotsSensor<FootbotGroundSensor, FootbotGround, FootbotGround::kCount> {
 public:
  static PluginDescription describe() {
    return describeSpots("8 infrared spots around the body; the mean of the channels of the floor's colour.");
  }

  static float& valueOf(Instance& instance, std::size_t spot) { return instance.readings->value[spot]; }
};

class FootbotBaseGroundSensor
    : public GroundSpotsSensor<FootbotBaseGroundSensor, FootbotBaseGround, FootbotBaseGround::kCount> {
 public:
  static constexpr const char* kLinks = "base_ground";

  static PluginDescription describe() {
    return describeSpots("4 infrared spots between the wheels; the mean of the channels of the floor's colour.");
  }

  static float& valueOf(Instance& instance, std::size_t spot) { return instance.readings->value[spot]; }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_GROUND_SENSOR(swarmanoid::devices::FootbotGroundSensor)
REGISTER_GROUND_SENSOR(swarmanoid::devices::FootbotBaseGroundSensor)
