/// The errors of a device in one controller configuration, in the order in which they act, and their state for one
/// robot.
///
/// Phases   add, addAlias: while the device is configured. makeState: between ticks, when a robot is added. apply: in
///          `sense` and `actuate`.
/// Threads  the chain is const after it is configured; states of different robots may be used concurrently. apply
///          allocates only for a span that is longer than all previous ones, and does not lock, log or throw.
/// Repeats  the draws of an <error> depend on the seed, the robot's name, the device, the kind, the field and the tick.
///          They do not depend on other errors, except those of the same kind on the same field. These are numbered in
///          the order of the file: without the first, the second draws the numbers of the first. Faults of single
///          robots (device_fault.hpp) draw from separate streams. A tick may be repeated: each error then starts from
///          its state after the previous tick.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "swarmanoid_space/error_models/error_model.hpp"
#include "swarmanoid_space/error_models/error_model_description.hpp"

namespace swarmanoid {

/// The description of a device's fields. @throws ConfigError if REGISTER_DEVICE does not stand below its struct
const DeviceType& requireDeviceType(const std::string& type, const SourceLocation& location);

/// The state of the errors of one robot's device between ticks.
struct ErrorState {
  static constexpr std::uint64_t kNoTick = ~std::uint64_t{0};

  std::uint64_t tick = kNoTick;         ///< of the last call
  std::uint64_t first_tick = kNoTick;   ///< of the first one
  std::vector<RandomStream> streams;    ///< one for all aliases, then one for each <error>
  std::vector<double> memory;           ///< one after the other, for the numbers of all errors
  std::vector<double> memory_before;    ///< the same after the previous tick
  std::vector<FieldHistory> histories;  ///< by error
  std::vector<ElementBuffer> elements;  ///< by span of the device

  /// Later draws use another seed; all stored values stay.
  void reseed(std::uint64_t seed) {
    for (RandomStream& stream : streams) {
      stream.reseed(seed);
    }
  }

  void archive(StateArchive& state) { state(tick, first_tick, streams, memory, memory_before, histories, elements); }
};

/// The origin of an error; different origins draw from different streams.
enum class ErrorOrigin {
  kConfiguration,  ///< applies to all robots of a controller configuration
  kFault           ///< applies to one robot, set by an intervention
};

class ErrorChain {
 public:
  /// @param device must outlive the chain
  explicit ErrorChain(const DeviceType& device, ErrorOrigin origin = ErrorOrigin::kConfiguration);

  /// Adds an error that a parameter of the device means. Aliases act before all errors that are added with `add`, and
  /// share the device's own random stream.
  /// @param kind a known one @param field as in selectFields @param parameter of the kind, which gets the value; the
  /// other parameters have their defaults
  /// @pre nothing was added with `add` @throws ConfigError if the field is unknown or does not suit
  void addAlias(const std::string& kind, const std::string& field, const std::string& parameter, double value);
  /// @throws ConfigError if the kind or the field is unknown, or if they do not suit each other
  void add(const ErrorModelDescription& description);

  /// Whether there are errors besides the aliases.
  bool hasListed() const { return entries_.size() > alias_count_; }

  /// Makes the state for a new robot. Allocates all memory that ticks need.
  /// @param seed of the experiment @param entity name of the robot
  /// @param most_elements of a span; memory is reserved for this many
  ErrorState makeState(std::uint64_t seed, std::string_view entity, std::size_t most_elements) const;

  /// Disturbs a device in place. Its spans point to the state afterwards. Numbers of sensors are limited to the bounds
  /// of their fields; commands are limited by their actuator.
  /// @param device an instance of the device's struct @param state of this chain, made after the last error was added
  void apply(void* device, ErrorState& state, std::uint64_t tick) const { apply(device, state, tick, 0); }
  /// The same without the aliases.
  void applyListed(void* device, ErrorState& state, std::uint64_t tick) const {
    apply(device, state, tick, alias_count_);
  }
  /// Points the spans on which errors act to the state, as after `apply`; for a state that was loaded from a snapshot.
  void pointSpans(void* device, ErrorState& state) const { deliverElements(static_cast<std::byte*>(device), state); }

 private:
  struct Entry {
    std::unique_ptr<const ErrorModel> model;
    FieldSelection fields;
    std::uint64_t from_tick = 0;
    std::string stream;        // identifies the error among those of the device; "" for aliases
    std::size_t stream_index;  // in ErrorState::streams
    std::size_t memory_begin;  // in ErrorState::memory
    std::size_t memory_size;   // 0 if the model keeps no memory
  };

  Entry& append(const ErrorKind& kind, const Configuration& parameters, FieldSelection fields);
  void useSpans(const FieldSelection& fields);
  void limit(const FieldSelection& fields);
  void startTick(ErrorState& state, std::uint64_t tick) const;
  void takeElements(const std::byte* device, ErrorState& state) const;
  void deliverElements(std::byte* device, ErrorState& state) const;
  void apply(void* device, ErrorState& state, std::uint64_t tick, std::size_t first_entry) const;

  const DeviceType& device_;
  ErrorOrigin origin_;
  std::vector<SpanPlace> spans_;
  std::vector<std::size_t> used_spans_;  // spans with errors on or in them, by index in spans_
  std::vector<Entry> entries_;
  std::size_t alias_count_ = 0;
  std::size_t memory_size_ = 0;
  FieldSelection limited_;  // bounded numbers that errors change, each once
};

}  // namespace swarmanoid
