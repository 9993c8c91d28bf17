/// The base classes of error models: what one <error> of an experiment file does to the readings of a sensor or to the
/// commands of an actuator.
///
/// Phases   made and `prepare`: between ticks. apply: in `sense` and `actuate`.
/// Threads  apply is called at once for different robots. No allocation, lock, log or throw in it.
/// Repeats  apply may be called again in the same tick, and then has the same effect; what it keeps from tick to tick
///          is in ErrorStep, never in the model.
///
/// To add a kind: one file in src/error_models/kinds/, with a class that derives from NumberError or WholeFieldError
/// and ends with REGISTER_ERROR_MODEL.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/random.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/error_models/field_history.hpp"
#include "swarmanoid_space/error_models/field_selection.hpp"

namespace swarmanoid {

/// One robot's device in one tick, and what an error model keeps for it.
struct ErrorStep {
  std::uint64_t tick = 0;
  std::uint64_t first_tick =
      0;  ///< in which it acts on this robot: the <error>'s `from_tick`, or a later robot's first
  const FieldSelection* fields = nullptr;
  const std::vector<SpanPlace>* spans = nullptr;  ///< of the device
  DisturbedDevice device;
  RandomStream* random = nullptr;   ///< of this <error> and robot, at the start of the tick's sequence
  double* memory = nullptr;         ///< one for each number, as it was after the last tick
  FieldHistory* history = nullptr;  ///< with as many slots as historySlots

  bool isActive() const { return tick >= first_tick; }
  void keep(std::size_t slot) const { history->keep(slot, *fields, *spans, device); }
  void restore(std::size_t slot) const { history->restore(slot, *fields, *spans, device); }
};

class ErrorModel {
 public:
  virtual ~ErrorModel() = default;

  /// Draws what stays the same for the whole run. @param memory of one number of one robot
  virtual double firstMemory(RandomStream& /*random*/) const { return 0.0; }
  /// Number of moments of which the fields are kept.
  virtual std::size_t historySlots() const { return 0; }
  /// Called in each tick, also before it is active.
  virtual void apply(const ErrorStep& step) const = 0;
};

/// An error model that changes number by number. `Kind` has a const function
///     double disturb(double value, double& memory, RandomStream& random) const
/// that returns the number with its error. `memory` is 0 or firstMemory at first, and belongs to the number; the
/// elements of a span share that of their field.
template <class Kind>
class NumberError : public ErrorModel {
 public:
  static constexpr ErrorSubject kSubject = ErrorSubject::kNumbers;

  void apply(const ErrorStep& step) const override {
    if (!step.isActive()) {
      return;
    }
    const Kind& kind = static_cast<const Kind&>(*this);
    forEachNumber(*step.fields, step.device, [&](const NumberPlace& place, std::byte* bytes, std::size_t index) {
      place.write(bytes, kind.disturb(place.read(bytes), step.memory[index], *step.random));
    });
  }
};

/// An error model that delivers fields as they were at another moment.
class WholeFieldError : public ErrorModel {
 public:
  static constexpr ErrorSubject kSubject = ErrorSubject::kWholeFields;
};

/// The description that a kind gives of itself.
struct ErrorKindDescription {
  std::string name;     ///< the attribute `kind`
  std::string summary;  ///< one sentence
  std::vector<Parameter> parameters;
};

struct ErrorKind {
  ErrorKindDescription description;
  ErrorSubject subject = ErrorSubject::kNumbers;
  /// @throws ConfigError
  std::function<std::unique_ptr<const ErrorModel>(const Configuration& parameters)> make;
};

/// All kinds by name.
std::vector<const ErrorKind*> errorKinds();
/// @return null if there is none
const ErrorKind* findErrorKind(const std::string& name);
std::vector<std::string> errorKindNames();

/// A parameter of a kind: a number.
Parameter errorParameter(const std::string& name, Range range, const std::string& description,
                         std::optional<std::string> value = {});

/// Registers a kind while the library loads.
struct ErrorKindRegistration {
  explicit ErrorKindRegistration(ErrorKind kind);
};

}  // namespace swarmanoid

/// At the end of a kind's source. `Class` has a static function `ErrorKindDescription describe()`, and is made from the
/// configuration of its parameters.
#define REGISTER_ERROR_MODEL(Class)                                                                           \
  namespace {                                                                                                 \
  const ::swarmanoid::ErrorKindRegistration SWARMANOID_CONCATENATE(registration_, __COUNTER__)(               \
      {Class::describe(), Class::kSubject,                                                                    \
       [](const ::swarmanoid::Configuration& parameters) -> std::unique_ptr<const ::swarmanoid::ErrorModel> { \
         return std::make_unique<Class>(parameters);                                                          \
       }});                                                                                                   \
  }
