/// Where the transmitters of messages sit on robots: one and the same place sends and receives.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// How far a transmitter may stand out of its robot's solids with all joints at zero [m]: receivers look for robots by
/// their outlines in the positional index, in a sphere that is larger than their range by this; so do cameras for LEDs,
/// and microphones. The outline of a robot
/// with arms holds its solids whatever the joints do; a transmitter that an arm turns may leave it by more than this
/// only if it stands out of its own link.
constexpr double kMostOutside = 0.1;

struct Transmitter {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< with all joints at zero, in B [m]
  int joint = -1;                                      ///< that turns it, as an index of EntityModel::joints; -1: none
};

/// Returns that of a link; of a model without such a link the one over the origin, in the middle of the solids' height.
/// @throws ConfigError if it stands out of the solids by more than kMostOutside
Transmitter transmitterOf(const EntityModel& model, const char* device, const char* link);

/// @return where an entity's transmitter is, in W [m]
Eigen::Vector3d positionOf(const Space& space, Row row, const Transmitter& transmitter);

/// The transmitters of those whom a receiver looks at, model by model, so that a link is looked up by its name once and
/// not for each robot.
class Transmitters {
 public:
  /// Models may have gone since: forgets what it knows.
  void clear() { known_.clear(); }
  /// @pre the entity's actuator has accepted the model
  const Transmitter& of(const EntityModel& model, const char* device, const char* link);

 private:
  struct Known {
    const EntityModel* model;
    Transmitter transmitter;
  };
  std::vector<Known> known_;  // few: robots of one type share their model
};

}  // namespace swarmanoid::devices
