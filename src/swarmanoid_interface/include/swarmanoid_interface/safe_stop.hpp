/// The commands of a robot's actuators when no controller decides any more: its controller threw, its sensors are lost,
/// or its process ends. One function for each actuator, in a table beside the devices; hosts of controllers on robots
/// use it, and drivers that have had no command for too long.
///
/// Each function starts from the last command and is asked again every period, so that a stop may take its time:
///
///     footbot_wheels     zero
///     footbot_turret     speed zero, held; a passive turret stays passive
///     eyebot_velocity    zero for `hover` seconds, then down with `descend_speed` for `descend_time`, then zero; an
///                        eyebot whose sensors say that it hangs by its magnet stays where it is
///     eyebot_laser       off
///     handbot_rope       winding speed zero; `shot` as it is, so that a robot that hangs by it does not fall
///     footbot_gripper, eyebot_magnet, handbot_arms, handbot_hands, footbot_leds, eyebot_leds
///                        as they are: what is held is not dropped
///
/// An actuator that has no entry gets its initial value, which means "do nothing". To give a device of your own another
/// safe stop, write it down beside the device and register it in the device's library:
///
///     bool stopSafely(MyDevice& command, const SafeStopMoment&) { command.speed = 0.0; return true; }
///     REGISTER_SAFE_STOP(MyDevice)
#pragma once

#include <string>

#include "swarmanoid_interface/robot.hpp"

namespace swarmanoid {

/// How an eyebot comes down.
struct SafeStopSettings {
  double hover = 2.0;          ///< [s]
  double descend_speed = 0.3;  ///< [m/s]
  double descend_time = 8.0;   ///< [s]
};

struct SafeStopMoment {
  double since = 0.0;  ///< the stop began [s]
  SafeStopSettings settings;
  const Robot& robot;  ///< with the sensors that the configuration lists, as last heard of
};

/// @param command of the device's type, as it was last @return whether the stop is over: the command stays now
using SafeStop = bool (*)(void* command, const SafeStopMoment& moment);

/// @return null if the device has none
SafeStop findSafeStop(const std::string& device);
/// While libraries load; the first of a device stays.
void registerSafeStop(const std::string& device, SafeStop stop);

template <class Device>
struct SafeStopRegistration {
  SafeStopRegistration() {
    registerSafeStop(Device::kType, [](void* command, const SafeStopMoment& moment) {
      return stopSafely(*static_cast<Device*>(command), moment);
    });
  }
};

}  // namespace swarmanoid

/// In one source file of the library that has the device.
#define REGISTER_SAFE_STOP(Device) \
  static const ::swarmanoid::SafeStopRegistration<Device> SWARMANOID_CONCATENATE(safe_stop_registration_, __COUNTER__);
