// Phase 2: every controller turns readings into commands.
#include <exception>

#include "tick.hpp"

namespace swarmanoid::phases {
namespace {

void step(const Space& space, Driver& driver) {
  driver.robot->startTick(space.tick, space.time);
  try {
    driver.controller->step(space.time, space.clocktick);
  } catch (const std::exception& error) {
    driver.failure = *error.what() == '\0' ? "threw an exception without a text" : error.what();
    driver.has_failed = true;
  } catch (...) {
    driver.failure = "threw something that is no std::exception";
    driver.has_failed = true;
  }
}

}  // namespace

void control(Space& space, std::vector<Driver>& drivers, const Workers& workers, Lockstep& lockstep,
             const Robot::LogSink& log) {
  lockstep.send(space, drivers);
  constexpr std::size_t kGrain = 64;
  workers.forRanges(drivers.size(), kGrain, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      if (!drivers[i].has_failed && drivers[i].controller != nullptr) {
        step(space, drivers[i]);
      }
    }
  });
  lockstep.receive(space, drivers, log);
}

}  // namespace swarmanoid::phases
