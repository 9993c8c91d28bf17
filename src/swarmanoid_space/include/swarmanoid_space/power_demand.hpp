/// The power that a robot draws, by the law of docs/reference/battery.md. For a robot without a battery it is what it
/// would draw from one.
#pragma once

#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

/// Of the electronics and the devices that a robot's controller lists [W].
/// @param battery that the robot has, or could have @param controller null: it has none
double standbyPower(const BatteryModel& battery, const ControllerDescription* controller);

/// Of all that is on in this tick: standby, LEDs, wheels and rotors as they are commanded [W]. Thread-safe.
/// @param battery as above @param standby as standbyPower has it [W]
double powerDemand(const Space& space, Row row, const BatteryModel& battery, double standby);

/// Whether a robot that flies rests: on the ground, or held by what it holds on to. Then rotors have nothing to carry.
bool isCarried(const Space& space, Row row);

}  // namespace swarmanoid
