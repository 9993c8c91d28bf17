/// One step of one controller, wherever it runs. For those who host controllers.
#pragma once

#include <cstdint>
#include <string>

#include "swarmanoid_interface/controller.hpp"

namespace swarmanoid {

/// Why a robot is stopped whose controller commands a number that is none.
constexpr const char* kNotFinite = "commanded a number that is not finite";

/// Whatever the controller throws is caught.
/// @return "", or why it failed: then it is not to be stepped again
std::string stepController(Controller& controller, Robot& robot, std::uint64_t tick, Time time, Duration dt);

}  // namespace swarmanoid
