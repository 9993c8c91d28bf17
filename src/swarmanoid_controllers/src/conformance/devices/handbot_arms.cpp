// The encoders say the angles that the joints are turned to. A handbot has no camera, so its own encoders are all that
// measures the motion.
#include <array>

#include "../checks.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"

namespace swarmanoid::conformance {
namespace {

/// Moves each joint to an angle of its own, so that no two can be confused.
Check arms(Bench& bench) {
  Check check{HandbotArms::kType, {HandbotArms::kType, HandbotArmsState::kType}, "", {}, {}};
  using Angles = std::array<double, HandbotArmsState::kJoints>;
  for (const Angles& angles : {Angles{-0.6, 0.3, 0.5, -0.9, -0.4, -0.7}, Angles{-0.9, -0.1, -0.2, -0.5, 0.15, 0.1},
                               Angles{-0.3, 0.0, 0.0, -0.3, 0.0, 0.0}}) {
    constexpr double kClose = 0.08;  // rad
    check.stages.push_back({"moving both arms", 2.0,
                            [&bench, angles] {
                              HandbotArms& command = *bench.actuator<HandbotArms>();
                              command.left = {angles[0], angles[1], angles[2]};
                              command.right = {angles[3], angles[4], angles[5]};
                            },
                            nullptr, nullptr, nullptr});
    check.stages.push_back(settle(bench, [&bench, angles] {
      for (std::size_t i = 0; i < angles.size(); ++i) {
        bench.expectNear(HandbotArmsState::kNames[i], bench.sensor<HandbotArmsState>()->joints[i].angle, angles[i],
                         kClose, "rad");
      }
    }));
  }
  return check;
}

std::vector<Check> armsChecks(Bench& bench) { return {arms(bench)}; }

const ChecksRegistration arms_checks({HandbotArms::kType, armsChecks});

}  // namespace
}  // namespace swarmanoid::conformance
