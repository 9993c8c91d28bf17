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
  double sum = 0.0;           ///< of the shares of light (Light::share)
};

/// The light sensors of one robot, at this tick.
struct IlluminatedRing {
  Row self = kNoRow;       ///< whose own LEDs do not count, and which hides nothing
  Eigen::Vector3d centre;  ///< of a sphere that holds all sensors, in W [m]
  double radius = 0.0;     ///< of that sphere [m]
  LightReach reach;        ///< beyond which sources give no light
  Span<IlluminatedSensor> sensors;
};

/// What becomes of the light of a source on a sensor, where it is not the sum of shares.
class LightLaw {
 public:
  virtual ~LightLaw() = default;
  /// @param brightness of the source (Light::share) @param offset from the sensor to it, in W [m]
  virtual void add(std::size_t sensor, double brightness, const Eigen::Vector3d& offset) = 0;
};

/// Hands on what shines to a function of the arguments of LightLaw::add.
template <class Visit>
class VisitedLight final : public LightLaw {
 public:
  explicit VisitedLight(Visit visit) : visit_(visit) {}
  void add(std::size_t sensor, double brightness, const Eigen::Vector3d& offset) override {
    visit_(sensor, brightness, offset);
  }

 private:
  Visit visit_;
};

/// Adds to each sensor's sum what those entities shine on it, in their order, LED by LED. Thread-safe.
/// @param lit LitEntities::collect of the ring's sphere
void illuminate(const Space& space, const IlluminatedRing& ring, const std::vector<Row>& lit);
/// The same by another law, which gets the lights instead of the sums.
void illuminate(const Space& space, const IlluminatedRing& ring, const std::vector<Row>& lit, LightLaw& law);

}  // namespace swarmanoid::devices
