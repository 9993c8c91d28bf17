// The rope attaches, becomes shorter and pulls when wound in, and detaches.
#include <memory>

#include "../checks.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_proximity.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"
#include "swarmanoid_interface/devices/handbot_vacuum.hpp"

namespace swarmanoid::conformance {
namespace {

Check rope(Bench& bench) {
  Check check{HandbotRope::kType, {HandbotRope::kType, HandbotRopeState::kType}, needsCeiling(bench), {}, {}};
  check.follows = {HandbotHands::kType, HandbotProximity::kType, HandbotVacuum::kType};  // they start on the ground
  constexpr double kPatience = 10.0;                                                     // s
  const auto state = [&bench] { return bench.sensor<HandbotRopeState>(); };
  const auto before = std::make_shared<double>(0.0);
  const auto took = std::make_shared<double>(0.0);
  check.stages.push_back({"shooting the rope to the ceiling", kPatience,
                          [&bench] { bench.actuator<HandbotRope>()->shot = true; }, nullptr,
                          [state] { return state()->attached; }, nullptr});
  for (const double speed : {0.05, -0.05}) {
    check.stages.push_back({"winding", 2.0, [state, before] { *before = state()->length; },
                            [&bench, speed] { bench.actuator<HandbotRope>()->winding_speed = speed; }, nullptr,
                            [took](double seconds) { *took = seconds; }});
    check.stages.push_back(settle(bench, [&bench, state, before, took, speed] {
      bench.expectAbout(speed > 0.0 ? "wound in, the rope is shorter by" : "wound out, the rope is shorter by",
                        *before - state()->length, speed * *took, 0.02, "m");
      if (speed > 0.0) {
        bench.expectTrue("it pulls: " + withUnit(state()->tension, "N"), state()->tension > 1.0);
      }
    }));
  }
  check.stages.push_back({"letting go", 2.0, [&bench] { bench.actuator<HandbotRope>()->shot = false; }, nullptr,
                          [state] { return !state()->attached; }, nullptr});
  check.tidy_up = [&bench] { bench.actuator<HandbotRope>()->shot = false; };
  return check;
}

std::vector<Check> ropeChecks(Bench& bench) { return {rope(bench)}; }

void restRope(const Bench& bench) { bench.actuator<HandbotRope>()->winding_speed = 0.0; }

const ChecksRegistration rope_checks({HandbotRope::kType, ropeChecks, nullptr, restRope});

}  // namespace
}  // namespace swarmanoid::conformance
