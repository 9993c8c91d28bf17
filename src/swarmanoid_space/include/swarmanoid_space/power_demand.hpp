/// The power that a robot draws, by the law of docs/reference/battery.md. For a robot without a battery, the power that
/// it would draw from one.
#pragma once

#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

/// Power of the electronics and of the devices that a robot's controller lists [W].
/// @param battery of the robot, or one that it could have @param controller null: none
double standbyPower(const BatteryModel& battery, const ControllerDescription* controller);

/// Power of everything that is on in this tick: standby, LEDs, and the commanded wheels and rotors [W]. Thread-safe.
/// @param battery as above @param standby the result of standbyPower [W]
double powerDemand(const Space& space, Row row, const BatteryModel& battery, double standby);

/// Whether a flying robot rests on the ground or is held by its attachments. Its rotors then carry no weight.
bool isCarried(const Space& space, Row row);

}  // namespace swarmanoid
