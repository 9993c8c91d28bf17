/// The batteries of robots. Their stores and charging power are properties of the robot (BatteryProperty), so that
/// rules and services may change them; all other state is here.
///
/// Phase  written in `power`, and between ticks.
#pragma once

#include "swarmanoid_interface/span.hpp"
#include "swarmanoid_space/models/battery_model.hpp"
#include "swarmanoid_space/state/state_visitor.hpp"

namespace swarmanoid {

struct BatteryState {
  double standby = 0.0;   ///< of the electronics and the devices of its controller [W]
  double power = 0.0;     ///< power drawn by the robot in the last tick [W]
  double input = 0.0;     ///< power by which it was charged in the last tick [W]
  double used = 0.0;      ///< of the charge and the capacitor, since the robot was added [J]
  double received = 0.0;  ///< from the property `supply` [J]
  bool is_empty = false;  ///< the robot is off and not commanded until its charge suffices
};

inline void visitCell(StateVisitor& visitor, const char* name, const CellOwner& /*owner*/,
                      Span<const BatteryState> states) {
  for (const BatteryState& state : states) {
    visitor.number({name, "power"}, state.power);
    visitor.number({name, "input"}, state.input);
    visitor.number({name, "used"}, state.used);
    visitor.number({name, "received"}, state.received);
    visitor.number({name, "empty"}, state.is_empty ? 1.0 : 0.0);
  }
}

/// Updates `is_empty`: true once nothing is left, false once the charge suffices.
/// @param stores the properties of the robot
inline void judgeEmptiness(const BatteryModel& model, Span<const double> stores, BatteryState& state) {
  if (stores[kBatteryCharge] <= 0.0 && stores[kBatteryCapacitor] <= 0.0) {
    state.is_empty = true;
  } else if (stores[kBatteryCharge] >= model.enough * model.capacity) {
    state.is_empty = false;
  }
}

/// Whether only the super-capacitor supplies the robot; its wheels are then off.
inline bool isOnCapacitor(Span<const double> stores, const BatteryState& state) {
  return !state.is_empty && stores[kBatteryCharge] <= 0.0;
}

}  // namespace swarmanoid
