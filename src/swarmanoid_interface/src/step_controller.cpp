#include "swarmanoid_interface/step_controller.hpp"

#include "process/user_calls.hpp"
#include "swarmanoid_interface/plain_text.hpp"

namespace swarmanoid {
namespace {

void letGo(std::shared_ptr<Controller>& controller, std::string_view part, const Robot& robot) {
  const UserCode destruction{"destruction", part, robot.name()};
  const UserCall call(destruction);
  controller.reset();
  restoreLocale();
}

}  // namespace

bool stepController(Controller& controller, UserCode& step, Robot& robot, std::uint64_t tick, Time time, Duration dt,
                    std::string& failure) {
  robot.startTick(tick, time);
  step.tick = tick;
  const NotedCall call(step);
  return succeeds([&] { controller.step(time, dt); }, failure);
}

std::shared_ptr<Controller> startController(const std::function<std::shared_ptr<Controller>()>& make,
                                            std::string_view part, Robot& robot, const Configuration& parameters) {
  std::shared_ptr<Controller> controller = callUserCode({"construction", part, robot.name()}, make);
  try {
    callUserCode({"init", part, robot.name()}, [&] { controller->init(robot, parameters); });
  } catch (...) {
    // destroy() is not called, since init did not complete
    letGo(controller, part, robot);
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
  letGo(controller, part, robot);
  return failure.empty() ? "" : "destroy: " + failure;
}

std::string controllerPart(const std::string& id, const std::string& label) {
  const Registry::Entry* entry = Registry::instance().find(PluginKind::kController, label);
  const std::string library = entry == nullptr ? "" : libraryOf(&entry->make.target_type());
  return "controller '" + id + "'" + (library.empty() ? "" : " of " + library);
}

}  // namespace swarmanoid
