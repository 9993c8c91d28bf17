/// The base classes of error models. An error model implements one <error> of an experiment file: it changes the
/// readings of a sensor or the commands of an actuator.
///
/// Units    numbers are in the unit of their field, and so are the parameters of a kind. Time is counted in ticks.
/// Phases   construction of a model, firstMemory: between ticks. apply: in `sense` and `actuate`.
/// Threads  kinds register while a library loads (one thread), and are only read afterwards. apply is called
///          concurrently for different robots. No allocation, lock, log or throw in it.
/// Errors   the constructor of a kind throws ConfigError at the invalid parameter.
/// Repeats  apply may be called again in the same tick, and then has the same effect. State that lasts from tick to
///          tick is in ErrorStep, never in the model.
///
/// To add a kind: one file in src/error_models/kinds/, with a class that derives from NumberError or WholeFieldError
/// and ends with REGISTER_ERROR_MODEL.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/random.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/error_models/field_history.hpp"
#include "swarmanoid_space/error_models/field_selection.hpp"

namespace swarmanoid {

/// One robot's device in one tick, and the state of an error model for it.
struct ErrorStep {
  std::uint64_t tick = 0;
  /// First tick in which the error acts on this robot: `from_tick` of the <error> or the robot's own first tick,
  /// whichever is later.
  std::uint64_t first_tick = 0;
  const FieldSelection* fields = nullptr;
  const std::vector<SpanPlace>* spans = nullptr;  ///< of the device
  DisturbedDevice device;
  /// The stream of this <error> and robot, at the start of the tick's sequence. Aliases (errors that parameters of the
  /// device mean) draw one after the other from one shared stream.
  RandomStream* random = nullptr;
  double* memory = nullptr;         ///< one value per number, as after the last tick; empty without keepsMemory
  FieldHistory* history = nullptr;  ///< with as many slots as historySlots

  bool isActive() const { return tick >= first_tick; }
  void keep(std::size_t slot) const { history->keep(slot, *fields, *spans, device); }
  void restore(std::size_t slot) const { history->restore(slot, *fields, *spans, device); }
};

class ErrorModel {
 public:
  virtual ~ErrorModel() = default;

  /// Whether the model keeps a double for each number from tick to tick.
  virtual bool keepsMemory() const { return false; }
  /// Draws values that are constant during a run. Called once for each number of each robot, if the model keeps memory.
  /// @param random of this <error> and robot @return the memory of the number before its first tick
  virtual double firstMemory(RandomStream& /*random*/) const { return 0.0; }
  /// Number of times for which the model keeps the fields.
  virtual std::size_t historySlots() const { return 0; }
  /// Called in each tick, even before the error is active.
  virtual void apply(const ErrorStep& step) const = 0;
};

namespace detail {

template <class Kind, class = void>
struct KeepsMemory : std::false_type {};
template <class Kind>
struct KeepsMemory<Kind, std::void_t<decltype(std::declval<const Kind&>().disturb(
                             0.0, std::declval<double&>(), std::declval<RandomStream&>()))>> : std::true_type {};

}  // namespace detail

/// An error model that changes each number separately. `Kind` has one of these const functions, which returns the
/// disturbed number:
///     double disturb(double value, RandomStream& random) const
///     double disturb(double value, double& memory, RandomStream& random) const
/// `memory` starts as firstMemory and belongs to the number; the elements of a span share that of their field.
template <class Kind>
class NumberError : public ErrorModel {
 public:
  static constexpr ErrorSubject kSubject = ErrorSubject::kNumbers;

  bool keepsMemory() const override { return detail::KeepsMemory<Kind>::value; }

  void apply(const ErrorStep& step) const override {
    if (!step.isActive()) {
      return;
    }
    // local copies tell the compiler that writing a number does not change them
    const auto& kind = static_cast<const Kind&>(*this);
    double* const memory = step.memory;
    RandomStream* const random = step.random;
    forEachNumber(*step.fields, step.device, [=, &kind](const NumberPlace& place, std::byte* bytes, std::size_t index) {
      const double value = place.read(bytes);
      double disturbed = value;
      if constexpr (detail::KeepsMemory<Kind>::value) {
        disturbed = kind.disturb(value, memory[index], *random);
      } else {
        static_cast<void>(memory), static_cast<void>(index);
        disturbed = kind.disturb(value, *random);
      }
      // infinite distances ("nothing in range", "too close") stay as they are
      if (!place.is_distance || std::isfinite(value)) {
        place.write(bytes, disturbed);
      }
    });
  }
};

/// An error model that replaces whole fields by their values at another time.
class WholeFieldError : public ErrorModel {
 public:
  static constexpr ErrorSubject kSubject = ErrorSubject::kWholeFields;
};

/// The description of a kind, provided by its class.
struct ErrorKindDescription {
  std::string name;     ///< the attribute `kind`
  std::string summary;  ///< one sentence
  std::vector<Parameter> parameters;
};

struct ErrorKind {
  ErrorKindDescription description;
  ErrorSubject subject = ErrorSubject::kNumbers;
  /// @param parameters of the kind, complete @throws ConfigError if they do not suit each other
  std::function<std::unique_ptr<const ErrorModel>(const Configuration& parameters)> make;
};

/// Returns all kinds, sorted by name. They live as long as the process.
std::vector<const ErrorKind*> errorKinds();
/// @return null if there is no such kind
const ErrorKind* findErrorKind(const std::string& name);
/// Returns the names of all kinds, sorted.
std::vector<std::string> errorKindNames();

/// Makes the description of a parameter of a kind: a number in the unit of the field, or without a unit.
/// @param value the default; without it the parameter is required
Parameter errorParameter(const std::string& name, Range range, const std::string& description,
                         std::optional<std::string> value = {});

/// Registers a kind while the library loads. A second kind of the same name is ignored.
struct ErrorKindRegistration {
  explicit ErrorKindRegistration(ErrorKind kind);
};

}  // namespace swarmanoid

/// Registers a kind; place it at the end of the source. `Class` has a static function
/// `ErrorKindDescription describe()`, and a constructor that takes the configuration of its parameters.
#define REGISTER_ERROR_MODEL(Class)                                                                           \
  namespace {                                                                                                 \
  const ::swarmanoid::ErrorKindRegistration SWARMANOID_CONCATENATE(registration_, __COUNTER__)(               \
      {Class::describe(), Class::kSubject,                                                                    \
       [](const ::swarmanoid::Configuration& parameters) -> std::unique_ptr<const ::swarmanoid::ErrorModel> { \
         return std::make_unique<Class>(parameters);                                                          \
       }});                                                                                                   \
  }
