// The encoders measure the commanded angles of the joints. A handbot has no camera, so its own encoders are the only
// measurement of the motion.
#include <array>
#include <memory>
#include <string>

#include "../checks.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"

namespace swarmanoid::conformance {
namespace {

using JointAngles = std::array<double, HandbotArmsState::kJoints>;

/// Readings of the encoders during a motion.
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

/// The mean speed times the duration is about the distance: this detects a speed with a wrong sign or unit, or without
/// a value.
void judgeSpeeds(Bench& bench, const Motion& motion, double took) {
  // Speeds are instantaneous, and over topics a busy machine misses some: three readings of 0.1 s at full speed.
  constexpr double kAllowed = 0.3 * HandbotArms::kFastest;  // rad
  for (std::size_t i = 0; i < motion.speeds.size(); ++i) {
    bench.expectNear("way by the speeds of " + std::string(HandbotArmsState::kNames[i]),
                     motion.speeds[i] / motion.ticks * took,
                     bench.sensor<HandbotArmsState>()->joints[i].angle - motion.before[i], kAllowed, "rad");
  }
}

/// Moves each joint to a different angle, so that none can be mistaken for another; the first motion is the longest, so
/// that the speeds can be judged.
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
