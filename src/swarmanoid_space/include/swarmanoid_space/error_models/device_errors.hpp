/// The errors of one sensor or actuator object: none, until one is added.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "swarmanoid_space/error_models/error_chain.hpp"

namespace swarmanoid {

class DeviceErrors {
 public:
  explicit DeviceErrors(const char* type) : type_(type) {}

  bool isEmpty() const { return chain_ == nullptr; }
  bool hasListed() const { return chain_ != nullptr && chain_->hasListed(); }

  /// @throws ConfigError
  void add(const std::vector<ErrorModelDescription>& errors) {
    for (const ErrorModelDescription& error : errors) {
      require(error.location).add(error);
    }
  }
  /// Adds nothing if the value is 0.
  void addAlias(const std::string& kind, const std::string& field, const std::string& parameter, double value) {
    if (value != 0.0) {
      require({}).addAlias(kind, field, parameter, value);
    }
  }

  /// These are as those of ErrorChain. @pre it is not empty
  ErrorState makeState(std::uint64_t seed, std::string_view entity, std::size_t most_elements) const {
    return chain_->makeState(seed, entity, most_elements);
  }
  void apply(void* device, ErrorState& state, std::uint64_t tick) const { chain_->apply(device, state, tick); }
  void applyListed(void* device, ErrorState& state, std::uint64_t tick) const {
    chain_->applyListed(device, state, tick);
  }

 private:
  ErrorChain& require(const SourceLocation& location) {
    if (chain_ == nullptr) {
      chain_ = std::make_unique<ErrorChain>(requireDeviceType(type_, location));
    }
    return *chain_;
  }

  const char* type_;
  std::unique_ptr<ErrorChain> chain_;
};

}  // namespace swarmanoid
