/// Actuator and sensor: the rotating long-range distance scanner of a footbot (thesis figure 1.1c), a head that turns
/// about the robot's upright axis, with four infrared beams at right angles.
///
/// Beams 0 and 2, ahead and behind in the head's frame, measure short distances; beams 1 and 3, left and right, long
/// ones. The layout and the two ranges, 4 to 30 cm and 20 to 150 cm, are those of the marXbot on which the footbot is
/// based, as the control interface of ARGoS states them (foot-bot, ci_footbot_distance_scanner_sensor.h).
///
/// Frames: angles are in the robot's frame, counter-clockwise seen from above, 0 is straight ahead. Distances are
/// measured from the axis of the head, at the link `scanner`.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/distance.hpp"

namespace swarmanoid {

/// The command of the head. Its initial value is off: the head stops, and nothing is measured.
struct FootbotScanner {
  static constexpr const char* kType = "footbot_scanner";
  static constexpr const char* kRobot = "footbot";

  static constexpr double kFastest = 6.283185307179586;  ///< either way: one turn in a second [rad/s]

  enum class Mode : std::uint8_t {
    kOff,    ///< stops, measures nothing
    kSpeed,  ///< turns continuously at a speed
    kAngle   ///< turns to an angle, the shorter way, and stays there
  };

  Mode mode = Mode::kOff;
  double angle = 0.0;  ///< target in mode kAngle [rad]
  double speed = 0.0;  ///< target in mode kSpeed [rad/s]

  void switchOff() { *this = {}; }
  void turnAt(double rad_per_s) { *this = {Mode::kSpeed, 0.0, rad_per_s}; }
  void holdAngle(double rad) { *this = {Mode::kAngle, rad, 0.0}; }

  /// Returns the turn of the head in `dt` [rad]; all heads of the suite follow this law. @param from the present angle
  /// [rad] @param dt [s]
  double turnFrom(double from, double dt) const {
    const double most = kFastest * dt;
    const double wanted = mode == Mode::kSpeed ? speed * dt : mode == Mode::kAngle ? wrapTurn(angle - from) : 0.0;
    return std::clamp(wanted, -most, most);
  }
};

template <class Visitor>
void fields(Visitor& visit, FootbotScanner& scanner) {
  constexpr double kFastest = FootbotScanner::kFastest;
  visit(scanner.mode, {"mode", "", "0: off; 1: turns at a speed; 2: turns to an angle and stays there"});
  visit(scanner.angle, {"angle", "rad", "to turn to in mode 2, in the robot's frame; modulo a turn"});
  visit(scanner.speed, {"speed", "rad/s", "to turn at in mode 1; cut to the range", {-kFastest, kFastest}});
}
REGISTER_DEVICE_OF_SUITE(FootbotScanner, kActuator, "The motor of the rotating distance scanner.")

/// Measurements of the four beams while the head turned in the last tick.
struct FootbotScannerReadings {
  static constexpr const char* kType = "footbot_scanner_readings";
  static constexpr const char* kRobot = "footbot";

  static constexpr std::size_t kBeams = 4;
  static constexpr std::size_t kSamples = 8;      ///< per beam and tick
  static constexpr Range kShortRange{0.04, 0.3};  ///< measuring range of beams 0 and 2 [m]
  static constexpr Range kLongRange{0.2, 1.5};    ///< measuring range of beams 1 and 3 [m]

  /// The samples of a tick, oldest first, evenly spaced over the period; the last one is at the end of the tick.
  using Samples = std::array<float, kSamples>;

  double angle = 0.0;   ///< of the head at the end of the tick, in (-pi, pi] [rad]
  float period = 0.0F;  ///< time span of the samples: a tick [s]
  Samples angles{};     ///< of beam 0 in the robot's frame, in (-pi, pi] [rad]; beam i is i quarter turns further left
  // distances [m]; by REP-117 infinity with nothing in range, -infinity with an object too close, NaN while off
  Samples short_ahead = unmeasuredDistances<kSamples>();
  Samples long_left = unmeasuredDistances<kSamples>();
  Samples short_behind = unmeasuredDistances<kSamples>();
  Samples long_right = unmeasuredDistances<kSamples>();

  /// The distances of beam 0, 1, 2 or 3.
  Samples& distances(std::size_t beam) {
    return beam == 0 ? short_ahead : beam == 1 ? long_left : beam == 2 ? short_behind : long_right;
  }
  const Samples& distances(std::size_t beam) const {
    return const_cast<FootbotScannerReadings*>(this)->distances(beam);
  }

  static constexpr bool isLong(std::size_t beam) { return beam % 2 == 1; }
  static constexpr Range rangeOf(std::size_t beam) { return isLong(beam) ? kLongRange : kShortRange; }
  /// Direction of a beam in the head's frame, in [0, 2 pi) [rad].
  static constexpr double offset(std::size_t beam) { return static_cast<double>(beam) * M_PI / 2.0; }

  /// Returns the angle of the head when a sample was taken [rad]; it turns at constant speed.
  /// @param before its angle one period ago [rad] @param turn its turn since then [rad]
  static constexpr double angleOf(std::size_t sample, double before, double turn) {
    return before + turn * static_cast<double>(sample + 1) / static_cast<double>(kSamples);
  }
};

template <class Visitor>
void fields(Visitor& visit, FootbotScannerReadings& scanner) {
  constexpr Range kShort = FootbotScannerReadings::kShortRange;
  constexpr Range kLong = FootbotScannerReadings::kLongRange;
  visit(scanner.angle, {"angle", "rad", "of the head now, in the robot's frame", {-M_PI, M_PI}, true});
  visit(scanner.period, {"period", "s", "over which the samples were taken"});
  visit(scanner.angles, {"angles", "rad", "of the head when each sample was taken", {-M_PI, M_PI}, true});
  visit(scanner.short_ahead, distanceField("short_ahead", kDistanceMeaning, kShort));
  visit(scanner.long_left, distanceField("long_left", "as `short_ahead`, a quarter of a turn further left", kLong));
  visit(scanner.short_behind, distanceField("short_behind", "as `short_ahead`, half a turn further", kShort));
  visit(scanner.long_right, distanceField("long_right", "as `short_ahead`, a quarter of a turn further right", kLong));
}
REGISTER_DEVICE_OF_SUITE(FootbotScannerReadings, kSensor, "Readings of the beams of the rotating distance scanner.")

}  // namespace swarmanoid
