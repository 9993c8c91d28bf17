/// The faults of one robot's device, beside the errors of its configuration, with all that is kept of them.
///
/// Phases   made between ticks, when somebody intervenes. apply: in `sense` and `actuate`, after the errors of the
///          configuration.
/// Threads  it belongs to one robot: faults of different robots act at the same time.
/// Repeats  as in ErrorChain, from streams of their own: what errors of the same kind and field draw stays as it is.
///          A fault that is given again after the device was mended draws what it drew.
#pragma once

#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "swarmanoid_space/error_models/device_errors.hpp"

namespace swarmanoid {

class DeviceFault {
 public:
  /// @param type Device::kType: the text must outlive the object @param errors as in DeviceErrors::add
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

  /// As ErrorState::reseed.
  void reseed(std::uint64_t seed) { state_.reseed(seed); }

 private:
  std::vector<ErrorModelDescription> errors_;
  DeviceErrors chain_;
  ErrorState state_;
};

}  // namespace swarmanoid
