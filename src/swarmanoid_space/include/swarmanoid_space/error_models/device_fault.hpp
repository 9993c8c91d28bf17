/// The faults of one robot's device, in addition to the errors of its configuration, with their state.
///
/// Phases   created between ticks, by an intervention. apply: in `sense` and `actuate`, after the errors of the
///          configuration.
/// Threads  the object belongs to one robot: faults of different robots act concurrently.
/// Repeats  as in ErrorChain, from separate streams: the draws of configured errors of the same kind and field do not
///          change. A fault that is set again after a repair draws the same numbers again.
#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "swarmanoid_space/error_models/device_errors.hpp"

namespace swarmanoid {

class DeviceFault {
 public:
  /// @param type Device::kType; the text must outlive the object @param errors as in DeviceErrors::add
  /// @param seed, entity, most_elements as in ErrorChain::makeState
  /// @pre there are errors @throws ConfigError if they do not suit the device
  DeviceFault(const char* type, std::vector<ErrorModelDescription> errors, std::uint64_t seed, std::string_view entity,
              std::size_t most_elements)
      : errors_(std::move(errors)), chain_(type, ErrorOrigin::kFault) {
    chain_.add(errors_);
    state_ = chain_.makeState(seed, entity, most_elements);
  }

  const std::vector<ErrorModelDescription>& errors() const { return errors_; }

  /// As ErrorChain::apply.
  void apply(void* device, std::uint64_t tick) { chain_.apply(device, state_, tick); }

  /// As ErrorChain::pointSpans.
  void pointSpans(void* device) { chain_.pointSpans(device, state_); }

  /// As ErrorState::reseed.
  void reseed(std::uint64_t seed) { state_.reseed(seed); }

  /// For snapshots; loads into an object that was made with the same errors.
  void archive(StateArchive& state) { state(state_); }

 private:
  std::vector<ErrorModelDescription> errors_;
  DeviceErrors chain_;
  ErrorState state_;
};

}  // namespace swarmanoid
