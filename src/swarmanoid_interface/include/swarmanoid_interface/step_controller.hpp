/// Makes, steps and ends one controller, for all hosts of controllers. Calls of the controller are recorded in the
/// notes of user_code.hpp.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid {

/// The reason for which a robot is stopped if its controller commands a number that is not finite.
constexpr const char* kNotFinite = "commanded a number that is not finite";

/// Steps the controller; every exception is caught.
/// @param step the note of the call; the host makes it once, {"step", part, robot.name()}, and keeps it: only its tick
/// is set in each step
/// @param failure the reason if it failed; written only then
/// @return true if it did not fail; after false the controller must not be stepped again
bool stepController(Controller& controller, UserCode& step, Robot& robot, std::uint64_t tick, Time time, Duration dt,
                    std::string& failure);

/// Makes a controller and initialises it. A controller that does not start is released without destroy().
/// @param part the controller and its library, for people (UserCode::part)
/// @throws ConfigError of its init, unchanged; std::runtime_error for anything else that is thrown
std::shared_ptr<Controller> startController(const std::function<std::shared_ptr<Controller>()>& make,
                                            std::string_view part, Robot& robot, const Configuration& parameters);

/// Calls destroy() of the controller and releases it, even if it throws. Does nothing for null.
/// @return "", or "destroy: " and the description of the exception
std::string endController(std::shared_ptr<Controller>& controller, std::string_view part, const Robot& robot);

/// Returns "controller 'drive' of libdiffusion.so"; without the library if the label is not registered.
std::string controllerPart(const std::string& id, const std::string& label);

}  // namespace swarmanoid
