// Any robot with microphones hears what sounds where it is tested; one with a differential drive turns, and hears it
// from another side.
#include "swarmanoid_interface/devices/microphones.hpp"

#include <cmath>

#include "../checks.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr double kTurnRateToListen = 0.5;  // rad/s
constexpr double kListeningTurn = 1.0;     // rad
constexpr double kHearingError = 0.2;      // rad, allowed error

std::string needsSound(const Bench& bench) {
  return bench.surroundings().has_sound ? "" : "nothing sounds here (sound is false)";
}

bool tellsDirections(const Microphones& heard) { return heard.microphones.size() >= LoudestSound::kFewestForBearing; }

/// How levels rise along the ground towards the bearing that the robot reports. @return more than 0 if they do
double riseTowardsBearing(const Microphones& heard) {
  const double count = static_cast<double>(heard.microphones.size());
  double mean = 0.0;
  for (const Microphone& microphone : heard.microphones) {
    mean += static_cast<double>(microphone.level) / count;
  }
  const double bearing = heard.loudest.bearing;
  double rise = 0.0;
  for (const Microphone& microphone : heard.microphones) {
    const double ahead =
        static_cast<double>(microphone.x) * std::cos(bearing) + static_cast<double>(microphone.y) * std::sin(bearing);
    rise += ahead * (static_cast<double>(microphone.level) - mean);
  }
  return rise;
}

Check hears(Bench& bench) {
  Check check{"microphones_hear", {Microphones::kType}, needsSound(bench), {}, {}};
  check.stages.push_back(settle(bench, [&bench] {
    const Microphones& heard = *bench.sensor<Microphones>();
    bench.expectTrue("the loudest source has a frequency", heard.loudest.frequency > 0.0F);
    if (tellsDirections(heard)) {
      bench.expectTrue("the loudest source is louder than all else together", heard.loudest.confidence > 0.5F);
      bench.expectTrue("levels rise towards its bearing, " + withUnit(heard.loudest.bearing, "rad"),
                       riseTowardsBearing(heard) > 0.0);
    }
  }));
  return check;
}

Check turns(Bench& bench) {
  Check check{
      "microphones_turn", {Microphones::kType, DifferentialDrive::kType}, needsSound(bench), {"microphones_hear"}, {}};
  check.follows = {DifferentialDrive::kType};  // which begins where the robot was put
  const auto before = std::make_shared<double>(0.0);
  check.stages.push_back(settle(bench, [&bench, before] { *before = bench.sensor<Microphones>()->loudest.bearing; }));
  check.stages.push_back({"turning to the left", kListeningTurn / kTurnRateToListen, nullptr,
                          [&bench] { bench.actuator<DifferentialDrive>()->drive(0.0, kTurnRateToListen); }, nullptr,
                          nullptr});
  check.stages.push_back(settle(bench, [&bench, before] {
    const Microphones& heard = *bench.sensor<Microphones>();
    if (tellsDirections(heard)) {
      bench.expectAngle("bearing of the loudest source after a turn to the left", heard.loudest.bearing,
                        *before - kListeningTurn, kHearingError);
    }
  }));
  return check;
}

std::vector<Check> microphoneChecks(Bench& bench) {
  std::vector<Check> checks{hears(bench)};
  if (bench.isListed(DifferentialDrive::kType)) {
    checks.push_back(turns(bench));
  }
  return checks;
}

const ChecksRegistration microphone_checks({Microphones::kType, microphoneChecks});

}  // namespace
}  // namespace swarmanoid::conformance
