/// Actuator and sensor: the vacuum suction cups of a handbot's hands, which grip objects and hold on to walls (thesis
/// 1, figure 1.2).
#pragma once

#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// Suction on: a hand holds the surface that its cups touch. Off: it releases the surface.
struct HandbotHands {
  static constexpr const char* kType = "handbot_hands";
  static constexpr const char* kRobot = "handbot";

  bool left = false;
  bool right = false;
};

template <class Visitor>
void fields(Visitor& visit, HandbotHands& hands) {
  visit(hands.left, {"left", "", "suction on: holds an object that the cups touch; off: releases it"});
  visit(hands.right, {"right", "", "the same of the right hand"});
}
/// The command stays, so that a held object is not dropped.
inline bool stopSafely(HandbotHands& /*hands*/, const SafeStopMoment& /*moment*/) { return true; }
REGISTER_DEVICE_OF_SUITE(HandbotHands, kActuator,
                         "The suction cups of the hands, which grip objects and hold on to walls.")

/// The readings of each hand's docking sensor, as of the end of the last tick.
struct HandbotHandsState {
  static constexpr const char* kType = "handbot_hands_state";
  static constexpr const char* kRobot = "handbot";

  struct Hand {
    bool holding = false;
    double force = 0.0;  ///< between the hand and the held object, without the noise of single engine steps [N]
  };
  Hand left;
  Hand right;
};

template <class Visitor>
void fields(Visitor& visit, HandbotHandsState::Hand& hand) {
  visit(hand.holding, {"holding", "", "whether the hand holds something"});
  visit(hand.force, {"force", "N", "between hand and held object, smoothed", {0.0, kInfinity}});
}
template <class Visitor>
void fields(Visitor& visit, HandbotHandsState& hands) {
  visit(hands.left, {"left"});
  visit(hands.right, {"right"});
}
REGISTER_DEVICE_OF_SUITE(HandbotHandsState, kSensor, "The docking sensors of the hands.")

}  // namespace swarmanoid
