// A loudspeaker plays a loud tone and a quieter, lower one, then falls silent: an observer with microphones judges.
#include "swarmanoid_interface/devices/loudspeaker.hpp"

#include <cmath>
#include <memory>
#include <optional>

#include "../checks.hpp"
#include "swarmanoid_interface/devices/footbot_microphones.hpp"
#include "swarmanoid_interface/devices/microphones.hpp"

namespace swarmanoid::conformance {
namespace {

struct Tone {
  double level;      ///< at 1 m [dB]
  double frequency;  ///< [Hz]
};
constexpr Tone kLoud{70.0, 880.0};
constexpr Tone kQuiet{60.0, 440.0};
constexpr double kToneTime = 3.0;  // s, for each tone

std::vector<Check> loudspeakerChecks(Bench& bench) {
  if (!bench.isListed(Loudspeaker::kType)) {
    return {};
  }
  const auto sound = [&bench](const Tone& tone) {
    return [&bench, tone] { bench.actuator<Loudspeaker>()->sound(tone.level, tone.frequency); };
  };
  Check check = shown(bench, Loudspeaker::kType, sound(kLoud));
  check.stages[0].seconds = kToneTime;
  check.stages.push_back({"sounding", kToneTime, sound(kQuiet), nullptr, nullptr, nullptr});
  check.stages.push_back(settle(bench, nullptr));
  check.stages.back().begin = [&bench] { bench.actuator<Loudspeaker>()->fallSilent(); };
  check.tidy_up = check.stages.back().begin;
  return {check};
}

/// Mean power level of the microphones [dB].
double loudnessOf(const Microphones& heard) {
  double power = 0.0;
  for (const Microphone& microphone : heard.sensors) {
    power += Sound::power(static_cast<double>(microphone.level)) / static_cast<double>(heard.sensors.size());
  }
  return Sound::level(power);
}
double loudnessOf(const FootbotMicrophones& heard) {
  double power = 0.0;
  for (const float level : heard.level) {
    power += Sound::power(static_cast<double>(level)) / static_cast<double>(heard.level.size());
  }
  return Sound::level(power);
}

/// Last measured level of each tone [dB].
struct HeardTones {
  std::optional<double> loud;
  std::optional<double> quiet;

  template <class Device>
  void listen(const Device& device) {
    const auto is = [&device](const Tone& tone) {
      return std::abs(static_cast<double>(device.loudest.frequency) - tone.frequency) < 0.02 * tone.frequency;
    };
    if (is(kLoud)) {
      loud = loudnessOf(device);
    } else if (is(kQuiet)) {
      quiet = loudnessOf(device);
    }
  }
};

/// @tparam Device Microphones or FootbotMicrophones, without another source as loud
template <class Device>
std::vector<Check> heardFromOther(Bench& bench) {
  constexpr double kPatience = 60.0;  // s
  constexpr double kError = 1.5;      // dB
  Check check{"loudspeaker_of_the_other", {Device::kType}, "", {}, {}};
  const auto heard = std::make_shared<HeardTones>();
  check.always = [&bench, heard] { heard->listen(*bench.sensor<Device>()); };
  check.stages.push_back({"hearing a tone of 880 Hz and then one of 440 Hz", kPatience, nullptr, nullptr,
                          [heard] { return heard->loud.has_value() && heard->quiet.has_value(); }, nullptr});
  check.stages.push_back(settle(bench, [&bench, heard] {
    bench.expectNear("the second tone is quieter by", *heard->loud - *heard->quiet, kLoud.level - kQuiet.level, kError,
                     "dB");
    if (const double way = bench.surroundings().listening_distance; way > 0.0) {
      bench.expectNear("level of the first tone", *heard->loud, kLoud.level + Sound::level(Sound::spread(way * way)),
                       kError, "dB");
    }
  }));
  check.stages.push_back({"silence", kToneTime + 2.0 * bench.settlingTime() + 1.0, nullptr, nullptr,
                          [&bench] { return bench.sensor<Device>()->loudest.frequency == 0.0F; }, nullptr});
  return {check};
}

const ChecksRegistration loudspeaker_checks({Loudspeaker::kType, loudspeakerChecks});
const ChecksRegistration on_microphones({Microphones::kType, noChecks, nullptr, nullptr, nullptr,
                                         heardFromOther<Microphones>});
const ChecksRegistration footbot_ears({FootbotMicrophones::kType, noChecks, nullptr, nullptr, nullptr,
                                       heardFromOther<FootbotMicrophones>});

}  // namespace
}  // namespace swarmanoid::conformance
