/// What shines on the light sensors of a robot: the lit LEDs of other robots, and lamps, unless another entity, the
/// ground or the robot that carries the LED (hiddenLeds) is in between. All rings of light sensors share it.
///
/// To add another kind of source is to add another loop to `illuminate`.
#pragma once

#include <Eigen/Core>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// One light sensor of one robot, at this tick.
struct IlluminatedSensor {
  Eigen::Vector3d position;   ///< in W [m]
  Eigen::Vector3d direction;  ///< in which it looks, in W, of length 1
  double sum = 0.0;           ///< of the shares of light (Light::share)
};

/// The light sensors of one robot, at this tick.
struct IlluminatedRing {
  Row self = kNoRow;       ///< whose own LEDs do not count, and which hides nothing
  Eigen::Vector3d centre;  ///< of a sphere that holds all sensors, in W [m]
  double radius = 0.0;     ///< of that sphere [m]
  double range = 0.0;      ///< beyond which a source gives no light [m]
  Span<IlluminatedSensor> sensors;
};

/// Whether nothing shines around a ring, so that its sensors need not be placed: in a large world most robots are in
/// the dark. @param reach radius and range of the ring [m] Thread-safe.
bool isDark(const Space& space, Row self, const Eigen::Vector3d& centre, double reach);

/// Adds to each sensor's sum what shines on it, in the order of entity numbers and LEDs. Thread-safe.
void illuminate(const Space& space, const IlluminatedRing& ring);

}  // namespace swarmanoid::devices
