/// Names and ranges of properties that arena objects and devices of the suite share (EntityModel::Property). Any object
/// may have them, also those of other packages. Shining entities have kIntensity (entity_model.hpp).
#pragma once

#include "swarmanoid_interface/devices/sound.hpp"
#include "swarmanoid_interface/range.hpp"

namespace swarmanoid {

/// A sound source has both; the sound comes from its origin. At a level of 0 it is silent.
constexpr const char* kSoundLevel = "sound_level";          ///< sound pressure level at 1 m [dB re 20 uPa]
constexpr const char* kSoundFrequency = "sound_frequency";  ///< [Hz]
constexpr Range kSoundLevelRange = Sound::kLevels;
constexpr Range kSoundFrequencyRange = Sound::kFrequencies;

/// A radio tag has both; it is at the object's origin. Devices truncate them to whole numbers.
constexpr const char* kTag = "tag";           ///< its id
constexpr const char* kTagData = "tag_data";  ///< its contents; devices write it too
constexpr Range kTagRange{1.0, 4294967295.0};
constexpr Range kTagDataRange{0.0, 4294967295.0};

}  // namespace swarmanoid
