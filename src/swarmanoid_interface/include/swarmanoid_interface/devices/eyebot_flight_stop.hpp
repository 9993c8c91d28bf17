/// The safe stop of all devices that fly an eyebot: it hovers for a while, then descends; an eyebot that hangs by its
/// magnet stays where it is.
#pragma once

#include "swarmanoid_interface/devices/eyebot_magnet.hpp"
#include "swarmanoid_interface/safe_stop.hpp"

namespace swarmanoid {

enum class FlightStop {
  kHangs,  ///< for good
  kHovers,
  kDescends,
  kIsOver
};

inline FlightStop flightStop(const SafeStopMoment& moment) {
  const Robot& robot = moment.robot;
  if (robot.hasSensor(EyebotMagnetState::kType) && robot.sensor<EyebotMagnetState>().attached) {
    return FlightStop::kHangs;
  }
  const SafeStopSettings& settings = moment.settings;
  if (moment.since < settings.hover) {
    return FlightStop::kHovers;
  }
  return moment.since < settings.hover + settings.descend_time ? FlightStop::kDescends : FlightStop::kIsOver;
}

}  // namespace swarmanoid
