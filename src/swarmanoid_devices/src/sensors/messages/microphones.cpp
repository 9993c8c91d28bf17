// The microphones of any robot whose description has them.
#include "swarmanoid_interface/devices/microphones.hpp"

#include "common/span_readings.hpp"
#include "microphone_array.hpp"

namespace swarmanoid::devices {
namespace {

using RoomyMicrophoneInstance = SpanReadings<MicrophoneInstance<Microphones, Eigen::Dynamic>, Microphone>;

class MicrophonesSensor final
    : public MicrophoneArray<MicrophonesSensor, Microphones, Eigen::Dynamic, RoomyMicrophoneInstance> {
  using Base = MicrophoneArray<MicrophonesSensor, Microphones, Eigen::Dynamic, RoomyMicrophoneInstance>;

 public:
  static PluginDescription describe() {
    return describeArray("Microphones where the robot has them; sound falls by the inverse square law.");
  }

  static float& levelOf(Instance& instance, std::size_t i) { return instance.buffer[i].level; }

 protected:
  std::size_t mostElements() const override { return Microphones::kMost; }

  void prepareInstance(const Space& space, Instance& instance) override {
    Base::prepareInstance(space, instance);
    instance.readings->sensors = instance.makeRoom(instance.ring->size());
    for (std::size_t i = 0; i < instance.ring->size(); ++i) {
      const Eigen::Vector3d place = instance.ring->from.col(static_cast<Eigen::Index>(i));
      instance.buffer[i].x = static_cast<float>(place.x());
      instance.buffer[i].y = static_cast<float>(place.y());
    }
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_SENSOR(swarmanoid::devices::MicrophonesSensor)
