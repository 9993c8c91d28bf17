/// Actuator: a loudspeaker on any robot. Microphones hear it, by the law of Sound.
#pragma once

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/devices/sound.hpp"

namespace swarmanoid {

/// A pure tone from the link `loudspeaker` of the robot's description, or, if it has none, from a point over its origin
/// at half its height. Microphones of other robots hear a command one tick later; the robot's own do not hear it.
struct Loudspeaker {
  static constexpr const char* kType = "loudspeaker";
  static constexpr const char* kLink = "loudspeaker";

  double level = 0.0;         ///< sound pressure level at 1 m [dB re 20 uPa], limited to Sound::kLevels; 0: silent
  double frequency = 1000.0;  ///< of the tone [Hz], limited to Sound::kFrequencies

  void sound(double level_at_1_m, double tone) {
    level = level_at_1_m;
    frequency = tone;
  }
  void fallSilent() { level = 0.0; }
};

template <class Visitor>
void fields(Visitor& visit, Loudspeaker& loudspeaker) {
  visit(loudspeaker.level, {"level", "dB", "sound pressure level at 1 m, re 20 uPa; 0: silent", Sound::kLevels});
  visit(loudspeaker.frequency, {"frequency", "Hz", "of the tone", Sound::kFrequencies});
}
REGISTER_DEVICE_OF_SUITE(Loudspeaker, kActuator, "A loudspeaker that sounds a tone.")

}  // namespace swarmanoid
