/// Safe stop: the commands of a robot's actuators once no controller commands them, because the controller threw, the
/// sensors are lost, or the process ends. Hosts of controllers on robots, the simulator, and drivers that have received
/// no command for too long use it.
///
/// The function `stopSafely` for the struct of an actuator defines its stop; without one the actuator gets its initial
/// value, which means "do nothing" (device_type.hpp). The function starts from the last command and is called again
/// every period, so that a stop can have phases: an eyebot hovers, then descends. Held objects are not dropped.
#pragma once

#include "swarmanoid_interface/robot.hpp"

namespace swarmanoid {

/// The phases of an eyebot's descent.
struct SafeStopSettings {
  double hover = 2.0;          ///< [s]
  double descend_speed = 0.3;  ///< [m/s]
  double descend_time = 8.0;   ///< [s]
};

/// The inputs of a device's safe stop.
struct SafeStopMoment {
  double since = 0.0;  ///< time since the stop began [s]
  SafeStopSettings settings;
  const Robot& robot;  ///< the robot with the sensors that its configuration lists, with their last received readings
};

}  // namespace swarmanoid
