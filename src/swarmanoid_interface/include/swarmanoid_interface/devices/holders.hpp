/// Actuator and sensor: the holders of any robot, the parts that hold other entities: a gripper, suction, magnets,
/// ropes on winches. They are in the order of the robot's description.
#pragma once

#include <array>
#include <cstddef>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/span.hpp"

namespace swarmanoid {

/// Commands beyond the number of holders of the robot are ignored.
struct Holders {
  static constexpr const char* kType = "holders";
  static constexpr std::size_t kMost = 8;
  static constexpr double kUsualFastest = 0.2;  ///< of winding, in and out [m/s]

  /// While `holds` is true the holder grips an object within its reach and keeps it; a rope is shot. When it is false
  /// the holder releases the object. A holder that was torn off, or a rope that reached no surface to attach to, grips
  /// again only after `holds` was false.
  struct Holder {
    bool holds = false;
    double winding_speed = 0.0;  ///< of a rope [m/s]; positive shortens it, if the motor is strong enough
  };

  std::array<Holder, kMost> holders{};
};

template <class Visitor>
void fields(Visitor& visit, Holders::Holder& holder) {
  visit(holder.holds, {"holds", "", "true: grips an object within reach, a rope is shot; false: releases it"});
  visit(holder.winding_speed,
        {"winding_speed", "m/s", "positive shortens a rope; cut to max_speed either way; ignored for other holders"});
}
template <class Visitor>
void fields(Visitor& visit, Holders& holders) {
  visit(holders.holders, {"holders"});
}
/// Holders keep their grip, so that no robot falls and no object is dropped; winches stop.
inline bool stopSafely(Holders& holders, const SafeStopMoment& /*moment*/) {
  for (Holders::Holder& holder : holders.holders) {
    holder.winding_speed = 0.0;
  }
  return true;
}
REGISTER_DEVICE_OF_SUITE(Holders, kActuator, "Gripper, suction, magnets and ropes, as many as the robot has.")

/// The state at the end of the last tick. The span is valid until the next tick.
struct HolderStates {
  static constexpr const char* kType = "holder_states";
  static constexpr std::size_t kMost = Holders::kMost;

  struct Holder {
    bool is_holding = false;
    double length = 0.0;  ///< of the unwound rope when taut; 0 when it holds nothing, and for other holders [m]
    double force = 0.0;   ///< on the held object, without the noise of single engine steps; 0 for grippers [N]
  };

  Span<const Holder> holders;
};

template <class Visitor>
void fields(Visitor& visit, HolderStates::Holder& holder) {
  visit(holder.is_holding, {"is_holding", "", "whether it holds something"});
  visit(holder.length, {"length", "m", "of the unwound rope; 0 without a held object", {0.0, kInfinity}});
  visit(holder.force, {"force", "N", "on the held object, smoothed; 0 for grippers", {0.0, kInfinity}});
}
template <class Visitor>
void fields(Visitor& visit, HolderStates& states) {
  visit(states.holders, {"holders"});
}
REGISTER_DEVICE_OF_SUITE(HolderStates, kSensor, "Contact, rope length and force of the robot's holders.")

}  // namespace swarmanoid
