/// Actuator and sensor: the vacuum suction cups of a handbot's hands, which grip objects and hold on to walls (thesis
/// 1, figure 1.2).
#pragma once

namespace swarmanoid {

/// Suction on: a hand holds the surface that its cups touch. Off: it lets go.
struct HandbotHands {
  static constexpr const char* kType = "handbot_hands";

  bool left = false;
  bool right = false;

  bool isFinite() const { return true; }
};

/// What the docking sensor of each hand says, as of the end of the last tick.
struct HandbotHandsState {
  static constexpr const char* kType = "handbot_hands_state";

  struct Hand {
    bool holding = false;
    double force = 0.0;  ///< between hand and what it holds, without the noise of single engine steps [N]
  };
  Hand left;
  Hand right;
};

}  // namespace swarmanoid
