/// What sensors that read from tables have beside Sensor, for whoever makes such tables of the ideal law: what to put
/// before a sensor, where the sensor is, what it reads.
///
/// Threads  one, before the sensor is in use
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_space/samples/sample_table.hpp"

namespace swarmanoid {

/// What is at the distances and angles of a table.
enum class Stimulus {
  kObstacle,  ///< a surface straight ahead; the angle is the one between where the sensor looks and the surface's
              ///< normal
  kLight,     ///< a white lamp; the angle is the one between where the sensor looks and the lamp
  kFloor      ///< a white floor; the angle is the one between where the sensor looks and straight down
};

class SampledSensor {
 public:
  virtual ~SampledSensor() = default;

  /// What a table of this sensor is of.
  virtual Stimulus stimulus() const = 0;
  /// Instead of Sensor::configure: it reads by the law of the device's default implementation, and has the parameters
  /// of that. @throws ConfigError
  virtual void configureIdeal(const Configuration& parameters) = 0;
  /// Whether those parameters mean errors (sensor.hpp), with which controllers read. `reading` is without them.
  virtual bool hasErrors() const = 0;
  /// As far as that law feels anything [m]. @pre it is configured
  virtual double reach() const = 0;

  /// One of the sensors of a robot, in its frame.
  struct Line {
    Eigen::Vector3d from;       ///< [m]
    Eigen::Vector3d direction;  ///< of length 1
  };
  // Of the robot that was added first. @pre there is one, with so many sensors
  virtual std::size_t sensorCount() const = 0;
  virtual Line line(std::size_t sensor) const = 0;
  virtual double reading(std::size_t sensor) const = 0;
};

}  // namespace swarmanoid
