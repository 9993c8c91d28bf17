// The turret's encoder measures the commanded angles, and the held prey has the same bearing.
#include <cmath>

#include "../checks.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"

namespace swarmanoid::conformance {
namespace {

Check turret(Bench& bench) {
  Check check{FootbotTurret::kType, {FootbotTurret::kType, FootbotTurretState::kType}, "", {}, {}};
  check.follows = {"gripper_closes"};  // a held prey shows the direction of the gripper
  const Color prey = bench.surroundings().prey_color;
  for (const double angle : {0.5, -0.4, 0.0}) {
    constexpr double kClose = 0.05;     // rad
    constexpr double kPatience = 10.0;  // s
    check.stages.push_back({"turning the turret to " + withUnit(angle, "rad"), kPatience, nullptr,
                            [&bench, angle] { bench.actuator<FootbotTurret>()->holdAngle(angle); },
                            [&bench, angle] {
                              // with a prey in the gripper the turret may swing for a while
                              const FootbotTurretState& state = *bench.sensor<FootbotTurretState>();
                              return std::abs(state.angle - angle) < kClose && std::abs(state.speed) < kClose;
                            },
                            nullptr});
    check.stages.push_back(settle(bench, [&bench, angle, prey] {
      bench.expectAngle("the turret's angle", bench.sensor<FootbotTurretState>()->angle, angle, kClose);
      const auto* gripper = bench.sensor<FootbotGripperState>();
      const auto held = bench.see(prey);
      if (gripper != nullptr && gripper->gripping && held) {
        bench.expectAngle("bearing of what it holds", bearingOf(*held), angle, 0.3);
      }
    }));
  }
  return check;
}

std::vector<Check> turretChecks(Bench& bench) { return {turret(bench)}; }

const ChecksRegistration turret_checks({FootbotTurret::kType, turretChecks});

}  // namespace
}  // namespace swarmanoid::conformance
