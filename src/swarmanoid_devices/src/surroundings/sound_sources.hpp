/// Sound sources around a robot: the loudspeakers of other robots, and arena objects with the property kSoundLevel. All
/// microphones share it.
///
/// To add another kind of source, add a case to `soundOf`.
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

/// Threads  one SoundSources per thread, kept between calls: its buffers grow to the size needed, and stay.
class SoundSources {
 public:
  /// Forgets cached models, which may have been deleted.
  void clear() { transmitters_.clear(); }

  /// Finds the sources within a range of a point, by entity number. A loudspeaker sounds from the tick after its
  /// command on (it is read from the actuation); a property applies at once.
  /// @param self its own loudspeaker does not count @param centre in W [m] @param range [m]
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
