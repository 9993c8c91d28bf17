/// The commands of a robot's actuators when no controller decides any more: its controller threw, its sensors are lost,
/// or its process ends. Hosts of controllers on robots use it, the simulator, and drivers that have had no command for
/// too long.
///
/// An actuator stops as the function `stopSafely` beside its struct says, else it gets its initial value, which means
/// "do nothing" (device_type.hpp). The function starts from the last command and is called again every period, so that
/// a stop may take its time: an eyebot hovers, then comes down. What is held is not dropped.
#pragma once

#include "swarmanoid_interface/robot.hpp"

namespace swarmanoid {

/// How an eyebot comes down.
struct SafeStopSettings {
  double hover = 2.0;          ///< [s]
  double descend_speed = 0.3;  ///< [m/s]
  double descend_time = 8.0;   ///< [s]
};

/// What a device's stop goes by.
struct SafeStopMoment {
  double since = 0.0;  ///< the stop began [s]
  SafeStopSettings settings;
  const Robot& robot;  ///< with the sensors that the configuration lists, as last heard of
};

}  // namespace swarmanoid
