/// The errors of one sensor or actuator object; none until one is added. A device without errors costs only a branch.
///
/// Units, phases, threads and repeats are those of ErrorChain. Errors are added while the device is configured;
/// afterwards the object is only read, concurrently by all threads, each with the states of different robots.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_space/error_models/error_chain.hpp"

namespace swarmanoid {

class DeviceErrors {
 public:
  /// @param type Device::kType; the text must outlive the object
  explicit DeviceErrors(const char* type, ErrorOrigin origin = ErrorOrigin::kConfiguration)
      : type_(type), origin_(origin) {}

  bool isEmpty() const { return chain_ == nullptr; }
  /// Whether there are errors besides the aliases.
  bool hasListed() const { return chain_ != nullptr && chain_->hasListed(); }

  /// Adds the <error> elements of an experiment file, in their order.
  /// @throws ConfigError if an error does not suit the device, or REGISTER_DEVICE does not stand below its struct;
  /// earlier errors stay added
  void add(const std::vector<ErrorModelDescription>& errors) {
    for (const ErrorModelDescription& error : errors) {
      require(error.location).add(error);
    }
  }
  /// Adds an error that a parameter of the device means (ErrorChain::addAlias), or nothing if the value is 0.
  /// @pre nothing was added with `add`, and the kind is known
  /// @throws ConfigError if the field is unknown or does not suit
  void addAlias(const std::string& kind, const std::string& field, const std::string& parameter, double value) {
    if (value != 0.0) {
      require({}).addAlias(kind, field, parameter, value);
    }
  }

  // The other functions are those of ErrorChain. @pre the object is not empty

  ErrorState makeState(std::uint64_t seed, std::string_view entity, std::size_t most_elements) const {
    SWARMANOID_EXPECTS(!isEmpty());
    return chain_->makeState(seed, entity, most_elements);
  }
  void apply(void* device, ErrorState& state, std::uint64_t tick) const {
    SWARMANOID_EXPECTS(!isEmpty());
    chain_->apply(device, state, tick);
  }
  void applyListed(void* device, ErrorState& state, std::uint64_t tick) const {
    SWARMANOID_EXPECTS(!isEmpty());
    chain_->applyListed(device, state, tick);
  }
  void pointSpans(void* device, ErrorState& state) const {
    SWARMANOID_EXPECTS(!isEmpty());
    chain_->pointSpans(device, state);
  }

 private:
  ErrorChain& require(const SourceLocation& location) {
    if (chain_ == nullptr) {
      chain_ = std::make_unique<ErrorChain>(requireDeviceType(type_, location), origin_);
    }
    return *chain_;
  }

  const char* type_;
  ErrorOrigin origin_;
  std::unique_ptr<ErrorChain> chain_;
};

}  // namespace swarmanoid
