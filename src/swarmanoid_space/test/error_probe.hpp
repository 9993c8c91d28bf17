/// Test devices with all kinds of fields, and errors for them as an experiment file would describe them.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_space/error_models/error_chain.hpp"
#include "swarmanoid_space/error_models/error_model.hpp"
#include "swarmanoid_space/error_models/error_model_description.hpp"

namespace swarmanoid::test {

struct Echo {
  float distance = 0.0F;
  float strength = 0.0F;
};

template <class Visitor>
void fields(Visitor& visit, Echo& echo) {
  visit(echo.distance, {"distance", "m"});
  visit(echo.strength, {"strength"});
}

struct Probe {
  static constexpr const char* kType = "probe_of_a_test";
  enum class Mode : std::uint8_t { kOff, kOn };

  double free = -1.0;
  std::array<float, 4> value{0.5F, 0.5F, 0.5F, 0.5F};
  double heading = 0.0;
  std::uint8_t level = 0;
  bool on = false;
  Mode mode = Mode::kOff;
  Span<const Echo> echoes;
};

template <class Visitor>
void fields(Visitor& visit, Probe& probe) {
  visit(probe.free, {"free"});
  visit(probe.value, {"value", "", "", {0.0, 1.0}});
  visit(probe.heading, {"heading", "rad", "", {-M_PI, M_PI}, true});
  visit(probe.level, {"level"});
  visit(probe.on, {"on"});
  visit(probe.mode, {"mode"});
  visit(probe.echoes, {"echoes"});
}
REGISTER_DEVICE(Probe, kSensor, "All sorts of fields.")

struct ProbeCommand {
  static constexpr const char* kType = "probe_command_of_a_test";
  double amount = 0.0;
};

template <class Visitor>
void fields(Visitor& visit, ProbeCommand& command) {
  visit(command.amount, {"amount", "", "", {-1.0, 1.0}});
}
REGISTER_DEVICE(ProbeCommand, kActuator, "A command with a range.")

struct ProbeSwitch {
  static constexpr const char* kType = "probe_switch_of_a_test";
  bool on = false;
};

template <class Visitor>
void fields(Visitor& visit, ProbeSwitch& probe) {
  visit(probe.on, {"on"});
}
REGISTER_DEVICE(ProbeSwitch, kSensor, "No number.")

/// Numbers with bounds on one side of 0 that their types cannot represent: single precision stores 0.7 as less, 0.8 as
/// more.
struct ProbeBounds {
  static constexpr const char* kType = "probe_bounds_of_a_test";
  float positive = 0.75F;
  float negative = -0.75F;
  std::uint8_t whole = 5;
};

template <class Visitor>
void fields(Visitor& visit, ProbeBounds& probe) {
  visit(probe.positive, {"positive", "", "", {0.7, 0.8}});
  visit(probe.negative, {"negative", "", "", {-0.8, -0.7}});
  visit(probe.whole, {"whole", "", "", {2.5, 7.5}});
}
REGISTER_DEVICE(ProbeBounds, kSensor, "Bounds between the numbers of a type.")

inline const DeviceType& probeType() { return *findDeviceType(Probe::kType); }

/// An <error> of the kind in line 3 of a file, its field in line 4 and its parameters in line 5.
inline ErrorModelDescription error(const std::string& kind, const std::string& field,
                                   const std::map<std::string, std::string>& given) {
  ErrorModelDescription description;
  description.kind = kind;
  description.field = field;
  description.location = {"file.xml", 3};
  description.field_location = {"file.xml", 4};
  description.parameters = Configuration("error", "", {"file.xml", 5});
  if (const ErrorKind* known = findErrorKind(kind)) {
    for (const Parameter& parameter : known->description.parameters) {
      const auto value = given.find(parameter.name);
      description.parameters.set(parameter.name, value == given.end() ? parameter.value.value_or("") : value->second);
    }
  }
  return description;
}

constexpr std::size_t kDraws = 100000;

/// Readings of `free` in consecutive ticks, of one robot whose ideal reading is `ideal(tick)`.
template <class Ideal>
std::vector<double> overTicks(const ErrorModelDescription& error, Ideal ideal, std::size_t ticks = kDraws) {
  ErrorChain chain(probeType());
  chain.add(error);
  ErrorState state = chain.makeState(7, "robot", 0);
  std::vector<double> delivered;
  for (std::size_t tick = 0; tick < ticks; ++tick) {
    Probe probe;
    probe.free = ideal(tick);
    chain.apply(&probe, state, tick);
    delivered.push_back(probe.free);
  }
  return delivered;
}

inline double constant(std::size_t /*tick*/) { return 3.0; }
inline double ramp(std::size_t tick) { return 0.25 * static_cast<double>(tick) + 1.0; }

}  // namespace swarmanoid::test
