// Holders of any robot: those with an object within reach hold it, the others do not; ropes can be wound.
#include "swarmanoid_interface/devices/holders.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "../checks.hpp"
#include "swarmanoid_interface/devices/joints.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr double kHoldingPatience = 10.0;  // s

const HolderStates::Holder& stateOf(const Bench& bench, std::size_t holder) {
  static const HolderStates::Holder kNone;
  const auto& holders = bench.sensor<HolderStates>()->holders;
  return holder < holders.size() ? holders[holder] : kNone;
}

bool shallHold(const Bench& bench, std::size_t holder) {
  const std::vector<std::size_t>& held = bench.surroundings().held;
  return std::find(held.begin(), held.end(), holder) != held.end();
}

/// Holders are commanded one after the other, so that none can be mistaken for another.
void judgeWhile(Bench& bench, std::size_t commanded) {
  const auto& holders = bench.sensor<HolderStates>()->holders;
  for (std::size_t i = 0; i < holders.size(); ++i) {
    const bool holds = i == commanded && shallHold(bench, i);
    bench.expectTrue("commanded holder " + std::to_string(commanded) + ", holder " + std::to_string(i) +
                         (holds ? " holds" : " does not hold"),
                     holders[i].is_holding == holds);
  }
}

/// Winds a rope in and out; holders without a rope are not judged.
void wind(Check& check, Bench& bench, std::size_t holder) {
  constexpr double kTime = 2.0;       // s
  constexpr double kWinding = 0.05;   // m/s
  constexpr double kLeast = 0.02;     // m, allowed error
  constexpr double kLeastPull = 1.0;  // N
  const auto before = std::make_shared<double>(0.0);
  const auto took = std::make_shared<double>(0.0);
  for (const double speed : {kWinding, -kWinding}) {
    check.stages.push_back(
        {"winding", kTime, [&bench, holder, before] { *before = stateOf(bench, holder).length; },
         [&bench, holder, speed] { bench.actuator<Holders>()->holders[holder].winding_speed = speed; }, nullptr,
         [took](double seconds) { *took = seconds; }});
    check.stages.push_back(settle(bench, [&bench, holder, before, took, speed] {
      if (*before == 0.0) {
        return;
      }
      const HolderStates::Holder& rope = stateOf(bench, holder);
      bench.expectAbout(speed > 0.0 ? "wound in, the rope is shorter by" : "wound out, the rope is shorter by",
                        *before - rope.length, speed * *took, kLeast, "m");
      if (speed > 0.0) {
        bench.expectTrue("it pulls: " + withUnit(rope.force, "N"), rope.force > kLeastPull);
      }
    }));
  }
}

void tryHolder(Check& check, Bench& bench, std::size_t holder) {
  const auto hold = [&bench, holder](bool holds) { bench.actuator<Holders>()->holders[holder] = {holds, 0.0}; };
  Stage take{"taking hold", kHoldingPatience, [hold] { hold(true); }, nullptr, nullptr, nullptr};
  if (shallHold(bench, holder)) {
    take.what += " with holder " + std::to_string(holder);
    take.until = [&bench, holder] { return stateOf(bench, holder).is_holding; };
  } else {
    take.seconds = bench.settlingTime();
  }
  check.stages.push_back(std::move(take));
  check.stages.push_back(settle(bench, [&bench, holder] { judgeWhile(bench, holder); }));
  if (shallHold(bench, holder)) {
    wind(check, bench, holder);
  }
  check.stages.push_back({"letting go", 2.0, [hold] { hold(false); }, nullptr,
                          [&bench, holder] { return !stateOf(bench, holder).is_holding; }, nullptr});
}

std::vector<Check> holdersChecks(Bench& bench) {
  if (!bench.isListed(Holders::kType)) {
    return {};
  }
  Check check{Holders::kType, {Holders::kType, HolderStates::kType}, "", {}, {}};
  const std::vector<std::size_t>& held = bench.surroundings().held;
  if (held.empty()) {
    check.obstacle = "nothing is within reach (held is empty)";
    return {check};
  }
  check.is_at_start = true;
  check.follows = {Joints::kType};  // which ends as it starts: with the arms at the objects
  for (std::size_t i = 0; i <= *std::max_element(held.begin(), held.end()); ++i) {
    tryHolder(check, bench, i);
  }
  check.tidy_up = [&bench] { *bench.actuator<Holders>() = {}; };
  return {check};
}

void restHolders(const Bench& bench) {
  for (Holders::Holder& holder : bench.actuator<Holders>()->holders) {
    holder.winding_speed = 0.0;
  }
}

const ChecksRegistration holders_checks({Holders::kType, holdersChecks, nullptr, restHolders});

}  // namespace
}  // namespace swarmanoid::conformance
