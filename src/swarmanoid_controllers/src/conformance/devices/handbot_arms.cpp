// The encoders say the angles that the joints are turned to. A handbot has no camera, so its own encoders are all that
// measures the motion.
#include <array>
#include <memory>
#include <string>

#include "../checks.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"

namespace swarmanoid::conformance {
namespace {

using JointAngles = std::array<double, HandbotArmsState::kJoints>;

/// What the encoders have said while the arms moved.
struct Motion {
  JointAngles before{};
  JointAngles speeds{};  // sums [rad/s]
  double ticks = 0.0;

  void begin(const HandbotArmsState& state) {
    *this = {};
    for (std::size_t i = 0; i < before.size(); ++i) {
      before[i] = state.joints[i].angle;
    }
  }
  void add(const HandbotArmsState& state) {
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      speeds[i] += state.joints[i].speed;
    }
    ticks += 1.0;
  }
};

/// The mean of the speeds times the time is about the way: a speed that has the wrong sign or unit is found, or none.
void judgeSpeeds(Bench& bench, const Motion& motion, double took) {
  // Speeds are those of moments, and over topics a busy machine misses some: three readings of 0.1 s at full speed.
  constexpr double kAllowed = 0.3 * HandbotArms::kFastest;  // rad
  for (std::size_t i = 0; i < motion.speeds.size(); ++i) {
    bench.expectNear("way by the speeds of " + std::string(HandbotArmsState::kNames[i]),
                     motion.speeds[i] / motion.ticks * took,
                     bench.sensor<HandbotArmsState>()->joints[i].angle - motion.before[i], kAllowed, "rad");
  }
}

/// Moves each joint to an angle of its own, so that no two can be confused; first so far that the speeds tell.
Check arms(Bench& bench) {
  Check check{HandbotArms::kType, {HandbotArms::kType, HandbotArmsState::kType}, "", {}, {}};
  const auto motion = std::make_shared<Motion>();
  for (const JointAngles& angles :
       {JointAngles{-1.4, 0.9, 1.35, -1.2, -0.8, -1.6}, JointAngles{-0.9, -0.1, -0.2, -0.5, 0.15, 0.1},
        JointAngles{-0.3, 0.0, 0.0, -0.3, 0.0, 0.0}}) {
    constexpr double kClose = 0.08;  // rad
    check.stages.push_back({"moving both arms", 2.0,
                            [&bench, angles, motion] {
                              motion->begin(*bench.sensor<HandbotArmsState>());
                              HandbotArms& command = *bench.actuator<HandbotArms>();
                              command.left = {angles[0], angles[1], angles[2]};
                              command.right = {angles[3], angles[4], angles[5]};
                            },
                            [&bench, motion] { motion->add(*bench.sensor<HandbotArmsState>()); }, nullptr,
                            [&bench, motion](double took) { judgeSpeeds(bench, *motion, took); }});
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
