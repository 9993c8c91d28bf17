#include "swarmanoid_interface/step_controller.hpp"

#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_interface/user_code.hpp"
#include "user_calls.hpp"

namespace swarmanoid {

std::string stepController(Controller& controller, std::string_view part, Robot& robot, std::uint64_t tick, Time time,
                           Duration dt) {
  robot.startTick(tick, time);
  const UserCode code{"step", part, robot.name(), tick};
  const NotedCall call(code);
  return failureOf([&] { controller.step(time, dt); });
}

std::shared_ptr<Controller> startController(const std::function<std::shared_ptr<Controller>()>& make,
                                            std::string_view part, Robot& robot, const Configuration& parameters) {
  std::shared_ptr<Controller> controller = callUserCode({"construction", part, robot.name()}, make);
  try {
    callUserCode({"init", part, robot.name()}, [&] { controller->init(robot, parameters); });
  } catch (...) {
    // it is not destroyed, for it was never ready
    const UserCall call({"destruction", part, robot.name()});
    controller.reset();
    restoreLocale();
    throw;
  }
  restoreLocale();
  return controller;
}

std::string endController(std::shared_ptr<Controller>& controller, std::string_view part, const Robot& robot) {
  if (controller == nullptr) {
    return "";
  }
  const std::string failure = failureOf({"destroy", part, robot.name()}, [&] { controller->destroy(); });
  const UserCall call({"destruction", part, robot.name()});
  controller.reset();
  restoreLocale();
  return failure.empty() ? "" : "destroy: " + failure;
}

std::string controllerPart(const std::string& id, const std::string& label) {
  const Registry::Entry* entry = Registry::instance().find(PluginKind::kController, label);
  const std::string library = entry == nullptr ? "" : libraryOf(&entry->make.target_type());
  return "controller '" + id + "'" + (library.empty() ? "" : " of " + library);
}

}  // namespace swarmanoid
