// Palm sensors and suction cups of the left hand react to the board; those of the right hand do not.
#include <algorithm>
#include <array>
#include <string>

#include "../checks.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_proximity.hpp"
#include "swarmanoid_interface/devices/handbot_vacuum.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr double kMovingTime = 2.0;  // s
constexpr double kLevel = 0.05;      // rad, of the shoulder: the hand touches the board
constexpr double kRaised = -1.3;     // rad, of the shoulder: the palm faces over the board

/// Moves the left arm while the right one is raised. @param shoulder [rad]
Stage stretch(Bench& bench, double shoulder) {
  return {"moving the left arm",
          kMovingTime,
          [&bench, shoulder] {
            bench.actuator<HandbotArms>()->left = {shoulder, 0.0, 0.0};
            bench.actuator<HandbotArms>()->right = {kRaised, 0.0, 0.0};
          },
          nullptr,
          nullptr,
          nullptr};
}

std::vector<Check> palmChecks(Bench& bench) {
  if (!bench.isListed(HandbotProximity::kType)) {
    return {};
  }
  constexpr float kNothing = 0.05F;
  constexpr float kNear = 0.5F;  // nearer than a fifth of the range
  Check check{HandbotProximity::kType,
              {HandbotProximity::kType, HandbotArms::kType},
              needsBoard(bench),
              {HandbotArms::kType},
              {}};
  const auto feels = [&bench](bool left) {
    return settle(bench, [&bench, left] {
      const HandbotProximity& palms = *bench.sensor<HandbotProximity>();
      const auto level = static_cast<double>(palms.left);
      bench.expectTrue(left ? "before the board the left palm feels it: " + withUnit(level, "")
                            : "with the arm raised the left palm feels nothing: " + withUnit(level, ""),
                       left ? palms.left > kNear : palms.left < kNothing);
      bench.expectTrue("the right palm feels nothing: " + withUnit(static_cast<double>(palms.right), ""),
                       palms.right < kNothing);
    });
  };
  check.stages = {stretch(bench, kRaised), feels(false), stretch(bench, kLevel), feels(true), stretch(bench, kRaised)};
  return {check};
}

void judgeCups(Bench& bench, bool holds) {
  constexpr float kClosed = 0.5F;
  constexpr float kOpen = 0.05F;
  const HandbotVacuum& vacuum = *bench.sensor<HandbotVacuum>();
  const auto most = [](const auto& cups) { return *std::max_element(cups.begin(), cups.end()); };
  const auto text = [&](const auto& cups) { return withUnit(static_cast<double>(most(cups)), ""); };
  if (holds) {
    bench.expectTrue(
        "cup 0 of the left hand is closed by the board: " + withUnit(static_cast<double>(vacuum.left[0]), ""),
        vacuum.left[0] > kClosed);
  } else {
    bench.expectTrue("without suction the left hand has no vacuum: " + text(vacuum.left), most(vacuum.left) < kOpen);
  }
  bench.expectTrue("the right hand has no vacuum: " + text(vacuum.right), most(vacuum.right) < kOpen);
}

/// Both hands have suction: only the cups show that one of them is in the air.
std::vector<Check> cupChecks(Bench& bench) {
  if (!bench.isListed(HandbotVacuum::kType)) {
    return {};
  }
  constexpr double kPatience = 10.0;  // s
  Check check{HandbotVacuum::kType,
              {HandbotVacuum::kType, HandbotHands::kType, HandbotHandsState::kType, HandbotArms::kType},
              needsBoard(bench),
              {HandbotHands::kType},
              {}};
  const auto suck = [&bench](bool is_on) {
    return [&bench, is_on] { *bench.actuator<HandbotHands>() = {is_on, is_on}; };
  };
  Stage hold = stretch(bench, kLevel);
  hold.what = "stretching the left arm until its hand holds";
  hold.seconds = kPatience;
  hold.act = suck(true);
  hold.until = [&bench] { return bench.sensor<HandbotHandsState>()->left.holding; };
  check.stages = {settle(bench, [&bench] { judgeCups(bench, false); }), hold,
                  settle(bench, [&bench] { judgeCups(bench, true); }), stretch(bench, kRaised)};
  check.stages.back().act = suck(false);
  check.stages.push_back(settle(bench, [&bench] { judgeCups(bench, false); }));
  check.tidy_up = [&bench] {
    *bench.actuator<HandbotHands>() = {false, false};
    bench.actuator<HandbotArms>()->left.shoulder = kRaised;
  };
  return {check};
}

const ChecksRegistration palm_checks({HandbotProximity::kType, palmChecks});
const ChecksRegistration cup_checks({HandbotVacuum::kType, cupChecks});

}  // namespace
}  // namespace swarmanoid::conformance
