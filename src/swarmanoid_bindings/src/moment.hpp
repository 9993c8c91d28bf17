/// Validity of objects that Python got from a run: readings and commands refer to memory of the run, which a tick or a
/// reset may reuse.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>

namespace swarmanoid::bindings {

/// Current moment of a run; its number grows with each tick and reset.
struct Moment {
  std::uint64_t number = 0;
  bool is_ticking = false;  ///< another thread makes ticks, and calls no Python code at the moment
};

/// Scope of a call of Python code from a tick: the run does not change meanwhile, and objects that the code gets are
/// valid until the end of the call.
class Pause {
 public:
  explicit Pause(Moment& moment) : moment_(moment), was_ticking_(moment.is_ticking) { moment_.is_ticking = false; }
  ~Pause() {
    moment_.is_ticking = was_ticking_;
    ++moment_.number;
  }
  Pause(const Pause&) = delete;
  Pause& operator=(const Pause&) = delete;

 private:
  Moment& moment_;
  bool was_ticking_;
};

/// Validity check of an object that is valid only in the moment of its creation.
class OfMoment {
 public:
  explicit OfMoment(std::shared_ptr<const Moment> moment) : moment_(std::move(moment)), number_(moment_->number) {}

  /// @throws std::runtime_error if that moment is over
  void require() const {
    if (moment_->is_ticking) {
      throw std::runtime_error("the simulation is making ticks on another thread: wait until they are made");
    }
    if (moment_->number != number_) {
      throw std::runtime_error("these are robots of an earlier tick: ask the simulation again after each tick");
    }
  }

 private:
  std::shared_ptr<const Moment> moment_;
  std::uint64_t number_;
};

}  // namespace swarmanoid::bindings
