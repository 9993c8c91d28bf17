/// One step of one controller, wherever it runs. For those who host controllers.
#pragma once

#include <cstdint>
#include <string>

#include "swarmanoid_interface/controller.hpp"

namespace swarmanoid {

/// Whatever the controller throws is caught.
/// @return "", or why it failed: then it is not to be stepped again
std::string stepController(Controller& controller, Robot& robot, std::uint64_t tick, Time time, Duration dt);

}  // namespace swarmanoid
