#include "sound_sources.hpp"

#include <algorithm>

#include "swarmanoid_space/models/properties.hpp"

namespace swarmanoid::devices {

const std::vector<SoundSource>& SoundSources::find(const Space& space, const Bank<Loudspeaker>& loudspeakers, Row self,
                                                   const Eigen::Vector3d& centre, double range) {
  near_.clear();
  sources_.clear();
  space.index.collect(centre, range + kMostOutside, near_);
  for (const Row row : near_) {
    SoundSource source;
    if (row != self && soundOf(space, loudspeakers, row, source) &&
        (source.position - centre).squaredNorm() <= range * range) {
      sources_.push_back(source);
    }
  }
  std::sort(sources_.begin(), sources_.end(),
            [](const SoundSource& a, const SoundSource& b) { return a.number < b.number; });
  return sources_;
}

/// @return false if the entity is silent
bool SoundSources::soundOf(const Space& space, const Bank<Loudspeaker>& loudspeakers, Row row, SoundSource& source) {
  double level = 0.0;
  if (const Loudspeaker* loudspeaker = loudspeakers.find(row)) {
    if (loudspeaker->level <= 0.0) {
      return false;
    }
    level = loudspeaker->level;
    source.frequency = loudspeaker->frequency;
    const EntityModel& model = *space.entities.model[row];
    source.position = positionOf(space, row, transmitters_.of(model, Loudspeaker::kType, Loudspeaker::kLink));
  } else {
    level = space.property(row, kSoundLevel).value_or(0.0);
    if (level <= 0.0) {
      return false;
    }
    source.frequency = space.property(row, kSoundFrequency).value_or(0.0);
    source.position = space.entities.pose[row].position;
  }
  source.number = space.entities.number[row];
  source.row = row;
  source.power = Sound::power(level);
  return true;
}

}  // namespace swarmanoid::devices
