/// Until when something may be looked at that Python has got from a run: readings and commands stand in memory of the
/// run, which a tick or a reset may give to another owner.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>

namespace swarmanoid::bindings {

/// That of a run; it goes on with each tick and reset.
struct Moment {
  std::uint64_t number = 0;
  bool is_ticking = false;  ///< and no code in Python is called just now: another thread makes ticks
};

/// For as long as code in Python is called: what it may look at is not being changed, and what it has got is good until
/// the call is over.
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

/// Whatever was made in a moment, and is good for this moment only.
class OfMoment {
 public:
  explicit OfMoment(std::shared_ptr<const Moment> moment) : moment_(std::move(moment)), number_(moment_->number) {}

  /// @throws std::runtime_error unless it is still that moment
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
