/// One check of the conformance test: its requirements, and its stages in order.
///
/// The checks of a device are a file in devices/ beside this one, which the build finds by itself (device_checks.hpp).
/// A check measures with the robot's own sensors, in its own frame: x ahead, y left.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace swarmanoid::conformance {

/// A stage of a check, from one tick on. The readings of a tick come before the commands of that tick; so the readings
/// in `end` include all the motion that `act` has commanded, up to the delay of the robot.
struct Stage {
  std::string what;                 ///< for the message when its time is out
  double seconds = 0.0;             ///< duration; with `until` the maximum
  std::function<void()> begin;      ///< called once, before the first `act`
  std::function<void()> act;        ///< called in each tick
  std::function<bool()> until;      ///< the stage is over when this returns true; without it, after `seconds`
  std::function<void(double)> end;  ///< called once, with the duration of the stage [s]
};

struct Check {
  std::string name;
  std::vector<std::string> devices;  ///< sensors and actuators that the check needs, and covers
  std::string obstacle;              ///< the reason why it cannot be done in these surroundings; "": it can
  std::vector<std::string> after;    ///< checks that must succeed before; otherwise this one has no meaning
  std::vector<Stage> stages;
  std::vector<std::string> follows = {};    ///< checks that come before, if they are done, whatever their outcome
  std::vector<std::string> trusts = {};     ///< likewise; if one of them fails, this one has no meaning
  std::function<void()> tidy_up = nullptr;  ///< called once after a failure: ends what must not last
  bool is_only_shown = false;               ///< the check covers nothing: an observer judges it
  bool is_at_start = false;                 ///< it is done before the robot moves away from where it was put
  std::function<void()> always = nullptr;   ///< called in each tick, whichever check is at work and after all of them
};

}  // namespace swarmanoid::conformance
