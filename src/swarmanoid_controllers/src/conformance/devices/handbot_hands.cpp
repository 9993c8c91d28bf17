// The left hand holds on to the board before it, the right one does not.
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "../checks.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"

namespace swarmanoid::conformance {
namespace {

/// Checks that the left hand holds the board when suction is on.
Check hands(Bench& bench) {
  Check check{HandbotHands::kType,
              {HandbotHands::kType, HandbotHandsState::kType, HandbotArms::kType},
              needsBoard(bench),
              {HandbotArms::kType},
              {}};
  constexpr double kPatience = 10.0;  // s
  const auto state = [&bench] { return bench.sensor<HandbotHandsState>(); };
  check.stages.push_back({"stretching the left arm until its hand holds", kPatience,
                          [&bench] {
                            *bench.actuator<HandbotHands>() = {true, false};
                            bench.actuator<HandbotArms>()->left = {0.1, 0.0, 0.0};
                          },
                          nullptr, [state] { return state()->left.holding; }, nullptr});
  check.stages.push_back(settle(bench, [&bench, state] {
    bench.expectTrue("the left hand holds, the right one does not", state()->left.holding && !state()->right.holding);
    bench.expectTrue("the right hand, which holds nothing, feels no force: " + withUnit(state()->right.force, "N"),
                     state()->right.force == 0.0);
  }));
  check.stages.push_back({"letting go", 2.0,
                          [&bench] {
                            *bench.actuator<HandbotHands>() = {false, false};
                          },
                          nullptr, [state] { return !state()->left.holding; }, nullptr});
  check.stages.push_back({"raising the arm", 1.0, [&bench] { bench.actuator<HandbotArms>()->left.shoulder = -0.3; },
                          nullptr, nullptr, nullptr});
  check.tidy_up = [&bench] {
    *bench.actuator<HandbotHands>() = {false, false};
    bench.actuator<HandbotArms>()->left.shoulder = -0.3;
  };
  return check;
}

std::vector<Check> handsChecks(Bench& bench) { return {hands(bench)}; }

const ChecksRegistration hands_checks({HandbotHands::kType, handsChecks});

}  // namespace
}  // namespace swarmanoid::conformance
