// A partner answers the robot's calls: in time, from its position, and only while the robot calls it. By radio,
// messages to another address are neither answered nor received.
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>

#include "../checks.hpp"
#include "../driving.hpp"
#include "../talk.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/bluetooth.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"
#include "swarmanoid_interface/devices/wifi.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr double kPartnerPatience = 10.0;  // s, until the partner answers for the first time
constexpr double kPartnerBearing = 0.15;   // rad, placement error of robots

/// Messages between a robot and its partner, by one kind of device.
/// @tparam Device the transmitter @tparam Heard the receiver
template <class Device, class Heard>
class Talk {
 public:
  using Message = typename Heard::Message;
  static constexpr bool kIsRadio = std::is_base_of_v<RadioCommand<Device::kBytes>, Device>;

  explicit Talk(Bench& bench) : bench_(bench), partner_(bench.surroundings().partner) {}

  /// Sends a new call, repeated in each tick.
  void call() { say(partner_, true); }
  /// Send a new call to the partner's address, or to that of another robot: radios only.
  void callPrivately() { say(partner_, false); }
  void callAnother() { say(partner_ + "'s neighbour", false); }
  void fallSilent() { bench_.actuator<Device>()->fallSilent(); }

  /// Fails if the robot receives its own call, or a message to another address.
  void listen() {
    for (const Message& message : bench_.sensor<Heard>()->messages) {
      if (message.payload == call_) {
        bench_.fail("the robot hears itself");
      }
      if (message.payload == whisper<Device::kBytes>()) {
        bench_.fail("the robot hears what is for another one");
      }
    }
  }
  /// Returns the first answer to the current call; null: there is none.
  const Message* answer() const {
    for (const Message& message : bench_.sensor<Heard>()->messages) {
      if (message.payload == answerTo(call_)) {
        return &message;
      }
    }
    return nullptr;
  }

 private:
  void say(const std::string& whom, bool to_all) {
    Device& device = *bench_.actuator<Device>();
    call_ = callOf<Device::kBytes>(bench_.robot().name(), partner_, ++count_);
    if constexpr (kIsRadio) {
      device.send(call_, to_all ? kEverybody : addressOf(whom));
    } else {
      device.send(call_);
    }
  }

  Bench& bench_;
  std::string partner_;
  typename Device::Payload call_{};
  std::uint8_t count_ = 0;
};

/// Sends a new call until it is answered. @param say function of Talk @param judge of the answer, or null
template <class SomeTalk>
Stage callUntilAnswered(const std::shared_ptr<SomeTalk>& talk, const char* what, double seconds,
                        void (SomeTalk::*say)(), std::function<void(const typename SomeTalk::Message&)> judge) {
  return {what,
          seconds,
          [talk, say] { (talk.get()->*say)(); },
          [talk] { talk->listen(); },
          [talk] { return talk->answer() != nullptr; },
          [talk, judge = std::move(judge)](double) {
            talk->listen();
            if (judge) {
              judge(*talk->answer());
            }
          }};
}

/// Waits for the maximum time of an answer, and checks that there is none. @param say function of Talk
template <class SomeTalk>
Stage expectNoAnswer(Bench& bench, const std::shared_ptr<SomeTalk>& talk, const char* what, void (SomeTalk::*say)()) {
  Stage stage{what,    bench.settlingTime() + bench.surroundings().answer_time,
              nullptr, [talk] { talk->listen(); },
              nullptr, nullptr};
  stage.begin = [talk, say] { (talk.get()->*say)(); };
  stage.end = [&bench, talk, what](double) {
    bench.expectTrue(std::string("while it is ") + what + ", nobody answers it", talk->answer() == nullptr);
  };
  return stage;
}

void judgePlace(Bench& bench, const RangeAndBearingMessage& answer) {
  const Surroundings& place = bench.surroundings();
  if (place.partner_distance == 0.0) {
    return;
  }
  constexpr double kDistance = 0.05;  // m, placement error of robots
  bench.expectAbout("range of the partner", static_cast<double>(answer.range),
                    std::hypot(place.partner_distance, place.partner_height), kDistance, "m");
  bench.expectAngle("bearing of the partner", static_cast<double>(answer.bearing), place.partner_bearing,
                    kPartnerBearing);
  bench.expectNear("elevation of the partner", static_cast<double>(answer.elevation),
                   std::atan2(place.partner_height, place.partner_distance), kPartnerBearing, "rad");
}

template <std::size_t byte_count>
void judgePlace(Bench& bench, const RadioMessage<byte_count>& answer) {
  bench.expectTrue("the sender's address is the partner's", answer.sender == addressOf(bench.surroundings().partner));
}

template <class Device, class Heard>
Check talkCheck(Bench& bench) {
  using SomeTalk = Talk<Device, Heard>;
  const auto talk = std::make_shared<SomeTalk>(bench);
  const auto judge = [&bench](const typename SomeTalk::Message& answer) { judgePlace(bench, answer); };
  const double in_time = bench.surroundings().answer_time;
  Check check{Device::kType, {Device::kType, Heard::kType}, needsPartner(bench), {}, {}};
  check.is_at_start = true;
  check.stages.push_back(
      callUntilAnswered(talk, "an answer of the partner", kPartnerPatience, &SomeTalk::call, nullptr));
  check.stages.push_back(callUntilAnswered(talk, "an answer to something new", in_time, &SomeTalk::call, judge));
  check.stages.push_back(expectNoAnswer(bench, talk, "silent", &SomeTalk::fallSilent));
  if constexpr (SomeTalk::kIsRadio) {
    check.stages.push_back(callUntilAnswered(talk, "an answer to what is for the partner alone", in_time,
                                             &SomeTalk::callPrivately, judge));
    check.stages.push_back(expectNoAnswer(bench, talk, "talking to another robot", &SomeTalk::callAnother));
  }
  Stage end = settle(bench, nullptr);
  end.begin = [talk] { talk->fallSilent(); };
  check.stages.push_back(std::move(end));
  check.tidy_up = [talk] { talk->fallSilent(); };
  return check;
}

/// During a turn to the left and back, the partner's bearing changes by the same angle in the other direction.
Check bearingTurns(Bench& bench, const Drive& drive) {
  using SomeTalk = Talk<RangeAndBearing, RangeAndBearingReceived>;
  constexpr double kRate = 0.5;  // rad/s
  constexpr double kTime = 2.0;  // s
  Check check{"range_and_bearing_turns",
              {RangeAndBearing::kType, RangeAndBearingReceived::kType, drive.device},
              needsPartner(bench),
              {RangeAndBearing::kType},
              {}};
  check.trusts = {drive.check};
  check.is_at_start = drive.returns;
  const auto talk = std::make_shared<SomeTalk>(bench);
  const auto before = std::make_shared<double>(0.0);
  const auto took = std::make_shared<double>(0.0);
  const auto hear = [&bench, talk](const std::function<void(double)>& judge) {
    return callUntilAnswered<SomeTalk>(
        talk, "an answer of the partner", bench.surroundings().answer_time, &SomeTalk::call,
        [judge](const RangeAndBearingMessage& answer) { judge(static_cast<double>(answer.bearing)); });
  };
  check.stages.push_back(settle(bench, nullptr));
  check.stages.push_back(hear([before](double bearing) { *before = bearing; }));
  for (const double rate : {kRate, -kRate}) {
    check.stages.push_back({"turning", kTime, nullptr, [drive, rate] { drive.command(0.0, rate); }, nullptr,
                            [took](double seconds) { *took = seconds; }});
    check.stages.push_back(settle(bench, nullptr));
    check.stages.push_back(hear([&bench, before, took, rate](double bearing) {
      bench.expectAbout(rate > 0.0 ? "turned left, the partner's bearing changed by"
                                   : "turned right, the partner's bearing changed by",
                        wrapTurn(bearing - *before), -rate * *took, kLeastAngle, "rad");
      *before = bearing;
    }));
  }
  check.stages.push_back(settle(bench, nullptr));
  check.stages.back().begin = [talk] { talk->fallSilent(); };
  check.tidy_up = [talk] { talk->fallSilent(); };
  return check;
}

template <class Device, class Heard>
std::vector<Check> messageChecks(Bench& bench) {
  if (!bench.isListed(Device::kType)) {
    return {};
  }
  std::vector<Check> checks{talkCheck<Device, Heard>(bench)};
  if constexpr (std::is_same_v<Device, RangeAndBearing>) {
    if (const auto drive = turningDriveOf(bench)) {
      checks.push_back(bearingTurns(bench, *drive));
    }
  }
  return checks;
}

/// The partner's part: answers calls to it. @return whether there was one
template <class Device, class Heard>
bool answerCalls(Bench& bench) {
  Device& device = *bench.actuator<Device>();
  for (const typename Heard::Message& message : bench.sensor<Heard>()->messages) {
    if (!isCallFor(message.payload, bench.robot().name())) {
      continue;
    }
    if constexpr (Talk<Device, Heard>::kIsRadio) {
      device.send(answerTo(message.payload), message.sender);
    } else {
      device.send(answerTo(message.payload));
    }
    return true;
  }
  if constexpr (Talk<Device, Heard>::kIsRadio) {
    device.send(whisper<Device::kBytes>(), addressOf(bench.robot().name()));
  } else {
    device.fallSilent();
  }
  return false;
}

template <class Device, class Heard>
std::vector<Check> calledByOther(Bench& bench) {
  constexpr double kPatience = 120.0;  // s, until the other robot comes to this check
  Check check{std::string(Device::kType) + "_of_the_other", {Device::kType, Heard::kType}, "", {}, {}};
  if (!bench.isListed(Heard::kType)) {
    return {check};
  }
  const auto was_called = std::make_shared<bool>(false);
  check.always = [&bench, was_called] { *was_called = answerCalls<Device, Heard>(bench) || *was_called; };
  check.stages.push_back(
      {"a call of the other robot", kPatience, nullptr, nullptr, [was_called] { return *was_called; }, nullptr});
  return {check};
}

template <class Device, class Heard>
DeviceChecks checksOf() {
  return {Device::kType, messageChecks<Device, Heard>, nullptr, nullptr, nullptr, calledByOther<Device, Heard>};
}

const ChecksRegistration range_and_bearing_checks(checksOf<RangeAndBearing, RangeAndBearingReceived>());
const ChecksRegistration wifi_checks(checksOf<Wifi, WifiReceived>());
const ChecksRegistration bluetooth_checks(checksOf<Bluetooth, BluetoothReceived>());

}  // namespace
}  // namespace swarmanoid::conformance
