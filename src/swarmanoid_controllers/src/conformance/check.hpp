/// One check of the conformance test: its requirements, and its stages in order.
///
/// The checks of a device are in a file in devices/ beside this one; the build finds it by itself (device_checks.hpp).
/// A check measures with the robot's own sensors, in its own frame: x ahead, y left.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace swarmanoid::conformance {

/// A stage of a check, which starts at a tick. The readings of a tick precede its commands, so the readings in `end`
/// include all the motion that `act` has commanded, up to the delay of the robot.
struct Stage {
  std::string what;                 ///< for the message at a time-out
  double seconds = 0.0;             ///< duration; with `until` the maximum
  std::function<void()> begin;      ///< called once, before the first `act`
  std::function<void()> act;        ///< called in each tick
  std::function<bool()> until;      ///< the stage ends when this returns true; if null, after `seconds`
  std::function<void(double)> end;  ///< called once, with the duration of the stage [s]
};

struct Check {
  std::string name;
  std::vector<std::string> devices;  ///< sensors and actuators that the check requires and covers
  std::string obstacle;              ///< reason why the check is impossible in these surroundings, or ""
  std::vector<std::string> after;    ///< checks that must have passed; without them this one is meaningless
  std::vector<Stage> stages;
  std::vector<std::string> follows = {};    ///< checks that come before this one, with any outcome
  std::vector<std::string> trusts = {};     ///< like `follows`, but if one of them fails, this one is meaningless
  std::function<void()> tidy_up = nullptr;  ///< called once after a failure: ends lasting effects
  bool is_only_shown = false;               ///< the check covers no device: an observer judges it
  bool is_at_start = false;                 ///< the check runs before the robot leaves its start pose
  std::function<void()> always = nullptr;   ///< called in each tick, during all checks and after them
};

}  // namespace swarmanoid::conformance
