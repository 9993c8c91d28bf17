#include "model_world.hpp"

#include <utility>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/controller.hpp"

namespace swarmanoid::test {
namespace {

Program& program() {
  static Program program;
  return program;
}

class Programmed final : public Controller {
 public:
  void init(Robot& robot, const Configuration&) override { robot_ = &robot; }
  void step(Time, Duration) override { program()(*robot_); }

 private:
  Robot* robot_ = nullptr;
};

std::string controller(const std::string& id, const std::string& actuators, const std::string& sensors) {
  return "<programmed id='" + id + "' library='swarmanoid_devices'><actuators>" + actuators + "</actuators><sensors>" +
         sensors + "</sensors><parameters/></programmed>";
}

}  // namespace

void setProgram(Program next) { program() = std::move(next); }

std::unique_ptr<Simulation> ModelWorld::start() const {
  loadBuiltInPlugins();
  std::string mapping;
  std::istringstream ids(members);
  for (std::string id; ids >> id;) {
    mapping += "<entity id='" + id + "'/>";
  }
  const bool has_handbot = entities.find("<handbot") != std::string::npos;
  const std::string text = join(
      "<ahss-config><framework><clocktick>", clocktick, "</clocktick><maxclock>1000000</maxclock><random_seed>", seed,
      "</random_seed></framework><controllers>", controller("footbot", wheels + footbot_actuators, footbot_sensors),
      controller("eyebot", eyebot_actuators, eyebot_sensors),
      has_handbot ? controller("handbot", handbot_actuators, handbot_sensors) : "",
      "</controllers><arena size='20,20,10' optimization='2D'>", entities, extras, "</arena><engines><", engine,
      " id='engine'>", engine_parameters, "</", engine, ">", more_engines,
      "</engines><arena_physics><engine id='engine'>", mapping, "</engine></arena_physics></ahss-config>");
  auto simulation = std::make_unique<Simulation>(parseExperiment(text, "model.xml"));
  simulation->start();
  return simulation;
}

}  // namespace swarmanoid::test

REGISTER_CONTROLLER(swarmanoid::test::Programmed, "programmed")
