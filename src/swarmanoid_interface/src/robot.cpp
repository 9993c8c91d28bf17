#include "swarmanoid_interface/robot.hpp"

#include <algorithm>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {
namespace {

constexpr int kLogsPerSecond = 10;
constexpr std::size_t kLongestLog = 10000;  // [bytes]

/// Returns at most the first `bytes` bytes of a text, without an incomplete UTF-8 character at the end.
std::string_view beginOf(std::string_view text, std::size_t bytes) {
  if (text.size() <= bytes) {
    return text;
  }
  const auto continues_letter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  while (bytes > 0 && continues_letter(text[bytes])) {
    --bytes;
  }
  return text.substr(0, bytes);
}

}  // namespace

Robot::Robot(std::string name, std::string type, std::uint64_t seed)
    : random_(seed, name, "controller"), name_(std::move(name)), type_(std::move(type)) {}

void Robot::restart(std::uint64_t seed) {
  random_ = RandomStream(seed, name_, "controller");
  time_ = kEpoch;
  debug_values_.clear();
  has_warned_of_debug_ = false;
  log_window_start_ = kEpoch;
  logged_in_window_ = 0;
}

void* Robot::find(const Devices& devices, const char* type, const char* kind) const {
  std::vector<std::string> known;
  for (const auto& [name, device] : devices) {
    if (name == type) {
      return device;
    }
    known.push_back(name);
  }
  throw DeviceError("robot '" + name_ + "' (" + type_ + ") has no " + kind + " '" + type +
                    "' in its controller's configuration; listed: " + (known.empty() ? "none" : joinNames(known)));
}

bool Robot::hasSensor(const std::string& type) const {
  return std::any_of(sensors_.begin(), sensors_.end(), [&](const auto& entry) { return entry.first == type; });
}

bool Robot::hasActuator(const std::string& type) const {
  return std::any_of(actuators_.begin(), actuators_.end(), [&](const auto& entry) { return entry.first == type; });
}

void Robot::log(LogLevel level, const std::string& text) {
  // a clock that was set back starts a new second too
  if (time_ < log_window_start_ || time_ - log_window_start_ >= std::chrono::seconds(1)) {
    log_window_start_ = time_;
    logged_in_window_ = 0;
  }
  ++logged_in_window_;
  if (!log_sink_ || logged_in_window_ > kLogsPerSecond + 1) {
    return;
  }
  if (logged_in_window_ > kLogsPerSecond) {
    log_sink_(level, name_, "(more in this second is left out)");
    return;
  }
  // the sink ends the line; a line break in the text would add a blank one in every log
  const std::size_t end = text.find_last_not_of("\r\n") + 1;
  if (end <= kLongestLog) {
    log_sink_(level, name_, text.substr(0, end));
    return;
  }
  log_sink_(level, name_,
            std::string(beginOf(text, kLongestLog)) + " (found " + std::to_string(end) + " bytes; beyond " +
                std::to_string(kLongestLog) + " they are left out)");
}

void Robot::debug(std::string_view key, std::string_view value) {
  if (!has_warned_of_debug_ && std::max(key.size(), value.size()) > kLongestDebugText) {
    warnOfDebug("a debug key or value of " + std::to_string(std::max(key.size(), value.size())) +
                " bytes: those beyond " + std::to_string(kLongestDebugText) + " are left out");
  }
  key = beginOf(key, kLongestDebugText);
  value = beginOf(value, kLongestDebugText);
  for (auto& [known, old_value] : debug_values_) {
    if (known == key) {
      old_value = value;
      return;
    }
  }
  if (debug_values_.size() >= kMostDebugKeys) {
    if (!has_warned_of_debug_) {
      warnOfDebug("debug key '" + std::string(key) + "' beyond the first " + std::to_string(kMostDebugKeys) +
                  ": it and further ones are left out");
    }
    return;
  }
  constexpr std::size_t kRoom = 64;
  std::string& kept = debug_values_.emplace_back(key, "").second;
  kept.reserve(kRoom);
  kept = value;
}

void Robot::warnOfDebug(const std::string& problem) {
  if (log_sink_) {
    log_sink_(LogLevel::kWarning, name_, "found " + problem);
    has_warned_of_debug_ = true;
  }
}

void Robot::provideSensor(const std::string& type, const void* readings) {
  // stored without const in the same list type as the actuators; sensor() returns it as const
  sensors_.emplace_back(type, const_cast<void*>(readings));
}

void Robot::provideActuator(const std::string& type, void* command) { actuators_.emplace_back(type, command); }

}  // namespace swarmanoid
