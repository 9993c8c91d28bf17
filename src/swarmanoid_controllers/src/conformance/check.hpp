/// One check of the conformance test: what it needs, and what is done one after the other.
///
/// To add one for a device of your own: write a function that makes it, like those beside this file, and add it to the
/// list in checks.cpp. A check measures with the robot's own sensors, in its own frame: x ahead, y left.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace swarmanoid::conformance {

/// A part of a check, from one tick on. The readings of a tick come before the commands of that tick; so what `end`
/// sees has had all the motion that `act` asked for, up to the delay of the robot.
struct Stage {
  std::string what;                 ///< for the message when its time is out
  double seconds = 0.0;             ///< how long; with `until` at the most
  std::function<void()> begin;      ///< once, before the first `act`
  std::function<void()> act;        ///< in each tick
  std::function<bool()> until;      ///< it is over when this is true; if there is none, after `seconds`
  std::function<void(double)> end;  ///< once, with the seconds that it took
};

struct Check {
  std::string name;
  std::vector<std::string> devices;  ///< sensors and actuators that it needs, and covers
  std::string obstacle;              ///< why it cannot be done in these surroundings; "": it can
  std::vector<std::string> after;    ///< checks without whose success it says nothing
  std::vector<Stage> stages;
  std::function<void()> tidy_up = nullptr;  ///< once, when it has failed: what must not last
  bool is_only_shown = false;               ///< it covers nothing: others have to judge
};

}  // namespace swarmanoid::conformance
