/// The interface that sensors with tables have in addition to Sensor, for tools that make such tables from the ideal
/// law: the stimulus, the poses of the sensors, and their readings.
///
/// Threads  one, before the sensor is in use
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "swarmanoid_experiment_files/samples/sample_table.hpp"
#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {

/// The stimulus at the distances and angles of a table.
enum class Stimulus {
  kObstacle,  ///< a surface straight ahead; the angle is between the sensor's axis and the surface's normal
  kLight,     ///< a white lamp; the angle is between the sensor's axis and the lamp
  kFloor      ///< a white floor; the angle is between the sensor's axis and straight down
};

class SampledSensor {
 public:
  virtual ~SampledSensor() = default;

  /// The stimulus of this sensor's tables.
  virtual Stimulus stimulus() const = 0;
  /// Replaces Sensor::configure: the sensor uses the law and the parameters of the device's default implementation.
  /// @throws ConfigError
  virtual void configureIdeal(const Configuration& parameters) = 0;
  /// Whether those parameters mean errors (sensor.hpp), which affect controllers. `reading` is without errors.
  virtual bool hasErrors() const = 0;
  /// Maximum range of that law [m]. @pre the sensor is configured
  virtual double reach() const = 0;

  /// The axis of one of a robot's sensors, in the robot's frame.
  struct Line {
    Eigen::Vector3d from;       ///< [m]
    Eigen::Vector3d direction;  ///< of length 1
  };
  // Sensors of the robot that was added first. @pre there is one, and the index is below sensorCount()
  virtual std::size_t sensorCount() const = 0;
  virtual Line line(std::size_t sensor) const = 0;
  virtual double reading(std::size_t sensor) const = 0;
};

}  // namespace swarmanoid
