/// What shines on the light sensors of a robot: the lit LEDs of other robots, and lamps, unless another entity, the
/// ground or the robot that carries the LED (LedShades) is in between. All rings of light sensors share it.
///
/// Which entities shine at all in a tick, LitEntities knows.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "lit_entities.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// One light sensor of one robot, at this tick.
struct IlluminatedSensor {
  Eigen::Vector3d position;   ///< in W [m]
  Eigen::Vector3d direction;  ///< in which it looks, in W, of length 1
};

/// The light sensors of one robot, at this tick.
struct IlluminatedRing {
  Row self = kNoRow;       ///< whose own LEDs do not count, and which hides nothing
  Eigen::Vector3d centre;  ///< of a sphere that holds all sensors, in W [m]
  double radius = 0.0;     ///< of that sphere [m]
  LightReach reach;        ///< beyond which sources give no light
  Span<const IlluminatedSensor> sensors;
};

/// The light of one LED or lamp that falls on one sensor.
struct LightOnSensor {
  std::size_t sensor;      ///< of the ring
  double brightness;       ///< of the source (Light::share)
  Eigen::Vector3d offset;  ///< from the sensor to it, in W [m]
};

/// All light that those entities shed on a ring: source by source in their order, sensor by sensor, LED by LED.
/// @param lit LitEntities::collect of the ring's sphere
/// @return valid until the next call by the same thread, so that a steady state allocates nothing. Thread-safe.
const std::vector<LightOnSensor>& lightOn(const Space& space, const IlluminatedRing& ring, const std::vector<Row>& lit);

}  // namespace swarmanoid::devices
