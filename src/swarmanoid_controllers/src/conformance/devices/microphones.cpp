// Any robot with microphones detects the sound source at the test place; a robot with a differential drive turns, and
// detects it in another direction.
#include "swarmanoid_interface/devices/microphones.hpp"

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "../checks.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"
#include "swarmanoid_interface/devices/footbot_microphones.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr double kTurnRateToListen = 0.5;  // rad/s
constexpr double kListeningTurn = 1.0;     // rad
constexpr double kHearingError = 0.2;      // rad, allowed error

std::string needsSound(const Bench& bench) {
  return bench.surroundings().has_sound ? "" : "nothing sounds here (sound is false)";
}

/// A microphone: its position, and its reading.
struct Ear {
  Eigen::Vector2d place;  // m
  double level = 0.0;     // dB
};

std::vector<Ear> earsOf(const Microphones& heard) {
  std::vector<Ear> ears;
  for (const Microphone& microphone : heard.sensors) {
    ears.push_back({{microphone.x, microphone.y}, microphone.level});
  }
  return ears;
}

std::vector<Ear> earsOf(const FootbotMicrophones& heard) {
  std::vector<Ear> ears;
  for (std::size_t i = 0; i < FootbotMicrophones::kCount; ++i) {
    ears.push_back({FootbotMicrophones::place(i).head<2>(), heard.level[i]});
  }
  return ears;
}

bool tellsDirections(const std::vector<Ear>& ears) { return ears.size() >= LoudestSound::kFewestForBearing; }

/// Correlation of the levels with the microphones' positions along the reported bearing. @return above 0 if levels rise
/// towards it
double riseTowards(double bearing, const std::vector<Ear>& ears) {
  double mean = 0.0;
  for (const Ear& ear : ears) {
    mean += ear.level / static_cast<double>(ears.size());
  }
  double rise = 0.0;
  for (const Ear& ear : ears) {
    rise += ear.place.dot(Eigen::Vector2d(std::cos(bearing), std::sin(bearing))) * (ear.level - mean);
  }
  return rise;
}

/// @tparam Device Microphones or FootbotMicrophones
template <class Device>
Check hears(Bench& bench) {
  Check check{std::string(Device::kType) + "_hear", {Device::kType}, needsSound(bench), {}, {}};
  check.stages.push_back(settle(bench, [&bench] {
    const LoudestSound& loudest = bench.sensor<Device>()->loudest;
    const std::vector<Ear> ears = earsOf(*bench.sensor<Device>());
    bench.expectTrue("the loudest source has a frequency", loudest.frequency > 0.0F);
    if (tellsDirections(ears)) {
      bench.expectTrue("the loudest source is louder than all else together", loudest.confidence > 0.5F);
      bench.expectTrue("levels rise towards its bearing, " + withUnit(loudest.bearing, "rad"),
                       riseTowards(loudest.bearing, ears) > 0.0);
    }
  }));
  return check;
}

template <class Device>
Check turns(Bench& bench) {
  const std::string type = Device::kType;
  Check check{type + "_turn", {type, DifferentialDrive::kType}, needsSound(bench), {type + "_hear"}, {}};
  check.follows = {DifferentialDrive::kType};  // that check begins at the start pose
  const auto before = std::make_shared<double>(0.0);
  check.stages.push_back(settle(bench, [&bench, before] { *before = bench.sensor<Device>()->loudest.bearing; }));
  check.stages.push_back({"turning to the left", kListeningTurn / kTurnRateToListen, nullptr,
                          [&bench] { bench.actuator<DifferentialDrive>()->drive(0.0, kTurnRateToListen); }, nullptr,
                          nullptr});
  check.stages.push_back(settle(bench, [&bench, before] {
    const Device& heard = *bench.sensor<Device>();
    if (tellsDirections(earsOf(heard))) {
      bench.expectAngle("bearing of the loudest source after a turn to the left", heard.loudest.bearing,
                        *before - kListeningTurn, kHearingError);
    }
  }));
  return check;
}

template <class Device>
std::vector<Check> microphoneChecks(Bench& bench) {
  if (!bench.isListed(Device::kType)) {
    return {};
  }
  std::vector<Check> checks{hears<Device>(bench)};
  if (bench.isListed(DifferentialDrive::kType)) {
    checks.push_back(turns<Device>(bench));
  }
  return checks;
}

const ChecksRegistration microphone_checks({Microphones::kType, microphoneChecks<Microphones>});
const ChecksRegistration footbot_microphone_checks({FootbotMicrophones::kType, microphoneChecks<FootbotMicrophones>});

}  // namespace
}  // namespace swarmanoid::conformance
