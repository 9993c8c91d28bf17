// The magnet attaches to the ceiling, and releases.
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"
#include "../checks.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"

namespace swarmanoid::conformance {
namespace {

Check magnet(Bench& bench) {
  Check check{EyebotMagnet::kType,
              {EyebotMagnet::kType, EyebotMagnetState::kType, EyebotVelocity::kType},
              needsCeiling(bench),
              {},
              {}};
  check.follows = {"velocity_up"};    // a robot with a wrong upward velocity does not reach the ceiling
  constexpr double kPatience = 20.0;  // s
  constexpr double kDescent = 1.5;    // s
  check.stages.push_back({"flying up to the ceiling and holding on to it", kPatience,
                          [&bench] { bench.actuator<EyebotMagnet>()->on = true; },
                          [&bench] {
                            bench.actuator<EyebotVelocity>()->linear = {0.0, 0.0, 0.2};
                          },
                          [&bench] { return bench.sensor<EyebotMagnetState>()->attached; }, nullptr});
  check.stages.push_back(settle(bench, [&bench] {
    bench.expectTrue("it still hangs at the ceiling", bench.sensor<EyebotMagnetState>()->attached);
  }));
  check.stages.push_back({"letting go", 2.0, [&bench] { bench.actuator<EyebotMagnet>()->on = false; }, nullptr,
                          [&bench] { return !bench.sensor<EyebotMagnetState>()->attached; }, nullptr});
  check.stages.push_back({"flying down", kDescent, nullptr,
                          [&bench] {
                            bench.actuator<EyebotVelocity>()->linear = {0.0, 0.0, -0.2};
                          },
                          nullptr,
                          [&bench](double) {
                            bench.expectTrue("it does not hang any more", !bench.sensor<EyebotMagnetState>()->attached);
                          }});
  check.tidy_up = [&bench] { bench.actuator<EyebotMagnet>()->on = false; };
  return check;
}

std::vector<Check> magnetChecks(Bench& bench) { return {magnet(bench)}; }

const ChecksRegistration magnet_checks({EyebotMagnet::kType, magnetChecks});

}  // namespace
}  // namespace swarmanoid::conformance
