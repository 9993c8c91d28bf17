#include "swarmanoid_interface/step_controller.hpp"

#include <exception>

namespace swarmanoid {

std::string stepController(Controller& controller, Robot& robot, std::uint64_t tick, Time time, Duration dt) {
  robot.startTick(tick, time);
  try {
    controller.step(time, dt);
  } catch (const std::exception& error) {
    return *error.what() == '\0' ? "threw an exception without a text" : error.what();
  } catch (...) {
    return "threw something that is no std::exception";
  }
  return "";
}

}  // namespace swarmanoid
