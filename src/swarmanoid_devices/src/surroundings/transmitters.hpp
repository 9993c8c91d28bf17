/// Positions of message transmitters on robots; the same position is used to send and to receive.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// Maximum distance of a transmitter from its robot's solids, with all joints at zero [m]. Receivers search robots by
/// their outlines in the positional index, in a sphere that is larger than their range by this distance; so do cameras
/// (for LEDs) and microphones. The outline of a robot with arms contains its solids in any position of the joints; a
/// transmitter on an arm can leave it by more than this distance only if it stands out of its own link.
constexpr double kMostOutside = 0.1;

struct Transmitter {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< with all joints at zero, in B [m]
  int joint = -1;                                      ///< its joint, an index in EntityModel::joints; -1: none
};

/// Returns the transmitter at a link, or, if the model has no such link, above the origin at half the height of the
/// solids.
/// @throws ConfigError if it is more than kMostOutside outside the solids
Transmitter transmitterOf(const EntityModel& model, const char* device, const char* link);

/// @return position of an entity's transmitter, in W [m]
Eigen::Vector3d positionOf(const Space& space, Row row, const Transmitter& transmitter);

/// The transmitters of the robots around a receiver, cached by model, so that a link is looked up by name once a model
/// and not for each robot.
class Transmitters {
 public:
  /// Forgets cached models, which may have been deleted.
  void clear() { known_.clear(); }
  /// @pre the entity's actuator has accepted the model
  const Transmitter& of(const EntityModel& model, const char* device, const char* link);

 private:
  struct Known {
    const EntityModel* model;
    Transmitter transmitter;
  };
  std::vector<Known> known_;  // few, since robots of one type share their model
};

}  // namespace swarmanoid::devices
