/// The life of one controller, wherever it runs: for those who host controllers. Calls of it are noted (user_code.hpp).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid {

/// Why a robot is stopped whose controller commands a number that is not finite.
constexpr const char* kNotFinite = "commanded a number that is not finite";

/// Whatever the controller throws is caught.
/// @param step the call, as it is noted: its host makes it once, {"step", part, robot.name()}, and keeps it; a robot is
/// stepped often, so its tick alone is set anew
/// @param failure why it failed; written only then
/// @return whether it did not fail; else it is not to be stepped again
bool stepController(Controller& controller, UserCode& step, Robot& robot, std::uint64_t tick, Time time, Duration dt,
                    std::string& failure);

/// Makes a controller and initialises it.
/// @param part the controller and its library, for people (UserCode::part) One that does not start is let go without
/// destroy().
/// @throws ConfigError that its init throws, as it is; std::runtime_error for whatever else is thrown
std::shared_ptr<Controller> startController(const std::function<std::shared_ptr<Controller>()>& make,
                                            std::string_view part, Robot& robot, const Configuration& parameters);

/// Has it destroyed and lets it go, whatever it throws. Null: nothing is done.
/// @return "", or "destroy: " and what it threw
std::string endController(std::shared_ptr<Controller>& controller, std::string_view part, const Robot& robot);

/// "controller 'drive' of libdiffusion.so"; without the library if the label is not registered.
std::string controllerPart(const std::string& id, const std::string& label);

}  // namespace swarmanoid
