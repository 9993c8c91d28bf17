/// What sounds around a robot: the loudspeakers of other robots, and arena objects with the property kSoundLevel. All
/// microphones share it.
///
/// To add another kind of source is to add another case to `soundOf`.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "swarmanoid_interface/devices/loudspeaker.hpp"
#include "swarmanoid_space/space.hpp"
#include "transmitters.hpp"

namespace swarmanoid::devices {

/// A source that is not silent.
struct SoundSource {
  EntityNumber number = kNoEntity;
  Row row = kNoRow;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< in W [m]
  double power = 0.0;                                  ///< at 1 m (Sound::power)
  double frequency = 0.0;                              ///< [Hz]
};

/// Threads  each needs SoundSources of its own, and keeps them: their room grows to what was needed, and stays.
class SoundSources {
 public:
  /// Models may have gone since: forgets what it knows of them.
  void clear() { transmitters_.clear(); }

  /// Finds what sounds within a range of a point, by entity number. A loudspeaker that is commanded sounds from the
  /// next tick on, as its robot's actuation says; a property, as it is now.
  /// @param self whose own loudspeaker does not count @param centre in W [m] @param range [m]
  /// @return valid until the next call
  const std::vector<SoundSource>& find(const Space& space, const Bank<Loudspeaker>& loudspeakers, Row self,
                                       const Eigen::Vector3d& centre, double range);

 private:
  bool soundOf(const Space& space, const Bank<Loudspeaker>& loudspeakers, Row row, SoundSource& source);

  Transmitters transmitters_;
  std::vector<Row> near_;
  std::vector<SoundSource> sources_;
};

}  // namespace swarmanoid::devices
