/// Light on the light sensors of a robot: lit LEDs of other robots, and lamps, unless another entity, the ground or the
/// robot that carries the LED (LedShades) is in between. All rings of light sensors share it.
///
/// LitEntities lists the entities that shine in a tick.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "lit_entities.hpp"
#include "swarmanoid_space/rays/led_shades.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// Weights of a source's colour channels in the response of sensors. White sources count with the mean of the weights.
struct SpectralResponse {
  double red = 1.0;
  double green = 1.0;
  double blue = 1.0;

  /// With all weights 1, equal to Light::brightness bit for bit.
  double brightness(Color color) const {
    constexpr double kWhite = 3.0 * 255.0;
    return (red * color.red + green * color.green + blue * color.blue) / kWhite;
  }
};

/// One light sensor of one robot, at this tick.
struct IlluminatedSensor {
  Eigen::Vector3d position;   ///< in W [m]
  Eigen::Vector3d direction;  ///< viewing direction in W, of length 1
};

/// The light sensors of one robot, at this tick.
struct IlluminatedRing {
  Row self = kNoRow;       ///< its own LEDs do not count, and it hides nothing
  Eigen::Vector3d centre;  ///< of a sphere that contains all sensors, in W [m]
  double radius = 0.0;     ///< of that sphere [m]
  double lowest = 0.0;     ///< lowest height of a sensor, in W [m]
  double highest = 0.0;    ///< highest height of a sensor, in W [m]
  LightReach reach;        ///< range beyond which sources give no light
  SpectralResponse response;
  Span<const IlluminatedSensor> sensors;
};

/// The light of one LED or lamp that falls on one sensor.
struct LightOnSensor {
  std::size_t sensor;      ///< of the ring
  double brightness;       ///< of the source (Light::share)
  Eigen::Vector3d offset;  ///< from the sensor to the source, in W [m]
};

/// All light that falls on a ring, by column, so that the shares can be computed in a vectorised loop.
class LightOnRing {
 public:
  std::size_t size() const { return count_; }
  LightOnSensor operator[](std::size_t light) const {
    return {sensor_[light], brightness_[light], {x_[light], y_[light], z_[light]}};
  }
  /// Adds the share (Light::share) of each light to the sum of its sensor, in order. @param sums by sensor; added to
  void addTo(double* sums) const;

  void clear() { count_ = 0; }
  /// Allocates space for so many more lights.
  void reserve(std::size_t more);
  /// @pre reserved @param ahead distance of the light along the sensor's direction [m], above 0
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

/// Threads  one LightSearch per thread, kept between calls: its buffers grow to the size needed, and stay.
class LightSearch {
 public:
  /// All light of entities on a ring, sorted by source, then sensor, then LED.
  /// @param lit LitEntities::collect for the ring's sphere @return valid until the next call
  const LightOnRing& find(const Space& space, const IlluminatedRing& ring, const std::vector<Row>& lit);

 private:
  struct Lights;

  void addLights(const Space& space, const IlluminatedRing& ring, Row row);
  /// Fills seen_. @return number of pairs of a sensor and a light that it sees
  std::size_t findFacing(const Space& space, const IlluminatedRing& ring, Lights& lights);
  LedSet facingLights(const Space& space, const IlluminatedSensor& sensor, const Lights& lights,
                      const LedShades::SameForAll& same);
  bool mayStandBetween(const Space& space, const IlluminatedRing& ring, const Lights& lights, const RayBundle& rays);
  void leaveOutOccluded(const Space& space, const IlluminatedRing& ring, const Lights& lights, RayBundle rays);

  LedShades shades_;
  std::vector<LedSet> seen_;  // lights of one source, by sensor
  LightOnRing found_;
  // scratch
  std::vector<PositionalIndex::Place> near_;
  std::vector<Segment> segments_;
  std::vector<RayHit> hits_;
};

}  // namespace swarmanoid::devices
