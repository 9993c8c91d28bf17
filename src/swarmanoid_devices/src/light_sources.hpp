/// What shines on the light sensors of a robot: the lit LEDs of other robots, and lamps, unless another entity, the
/// ground or the robot that carries the LED (LedShades) is in between. All rings of light sensors share it.
///
/// Which entities shine at all in a tick, LitEntities knows.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "lit_entities.hpp"
#include "swarmanoid_space/rays/led_shades.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// How strongly sensors respond to the channels of a source, where a source that is white counts with their mean.
struct SpectralResponse {
  double red = 1.0;
  double green = 1.0;
  double blue = 1.0;

  /// With equal weights of 1, Light::brightness to the bit.
  double brightness(Color color) const {
    constexpr double kWhite = 3.0 * 255.0;
    return (red * color.red + green * color.green + blue * color.blue) / kWhite;
  }
};

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
  double lowest = 0.0;     ///< of the sensors, in W [m]
  double highest = 0.0;    ///< likewise
  LightReach reach;        ///< beyond which sources give no light
  SpectralResponse response;
  Span<const IlluminatedSensor> sensors;
};

/// The light of one LED or lamp that falls on one sensor.
struct LightOnSensor {
  std::size_t sensor;      ///< of the ring
  double brightness;       ///< of the source (Light::share)
  Eigen::Vector3d offset;  ///< from the sensor to it, in W [m]
};

/// All light that falls on a ring, by column, so that the shares of several lights are computed at once.
class LightOnRing {
 public:
  std::size_t size() const { return count_; }
  LightOnSensor operator[](std::size_t light) const {
    return {sensor_[light], brightness_[light], {x_[light], y_[light], z_[light]}};
  }
  /// Adds up what each sensor gets of it, by Light::share, light by light. @param sums by sensor, which it is added to
  void addTo(double* sums) const;

  void clear() { count_ = 0; }
  /// Makes room for so many more.
  void reserve(std::size_t more);
  /// @pre there is room @param ahead how far the light is along the direction of the sensor [m], above 0
  void add(const LightOnSensor& light, double ahead) {
    sensor_[count_] = light.sensor;
    brightness_[count_] = light.brightness;
    x_[count_] = light.offset.x();
    y_[count_] = light.offset.y();
    z_[count_] = light.offset.z();
    ahead_[count_] = ahead;
    ++count_;
  }

 private:
  std::size_t count_ = 0;
  std::vector<std::size_t> sensor_;
  std::vector<double> brightness_;
  std::vector<double> x_;  // of the offset
  std::vector<double> y_;
  std::vector<double> z_;
  std::vector<double> ahead_;
  mutable std::vector<double> shares_;  // scratch of addTo
};

/// Threads  each needs a LightSearch of its own, and keeps it: its room grows to what was needed, and stays.
class LightSearch {
 public:
  /// All light that entities shed on a ring: source by source in their order, sensor by sensor, LED by LED.
  /// @param lit LitEntities::collect of the ring's sphere @return valid until the next call
  const LightOnRing& find(const Space& space, const IlluminatedRing& ring, const std::vector<Row>& lit);

 private:
  struct Lights;

  void addLights(const Space& space, const IlluminatedRing& ring, Row row);
  /// Fills seen_. @return how many lights are seen, each by each sensor
  std::size_t findFacing(const Space& space, const IlluminatedRing& ring, Lights& lights);
  LedSet facingLights(const Space& space, const IlluminatedSensor& sensor, const Lights& lights,
                      const LedShades::SameForAll& same);
  bool mayStandBetween(const Space& space, const IlluminatedRing& ring, const Lights& lights, const RayBundle& rays);
  void leaveOutOccluded(const Space& space, const IlluminatedRing& ring, const Lights& lights, RayBundle rays);

  LedShades shades_;
  std::vector<LedSet> seen_;  // of one source, by sensor
  LightOnRing found_;
  // scratch
  std::vector<PositionalIndex::Place> near_;
  std::vector<Segment> segments_;
  std::vector<RayHit> hits_;
};

}  // namespace swarmanoid::devices
