/// Texts of files of interventions, and the experiment that they refer to.
#pragma once

#include <string>

#include "swarmanoid_experiment_files/testing/small_world.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"

namespace swarmanoid::test {

/// The small world with two engines, and a controller with a device, for use in files.
inline Experiment namedParts() {
  Experiment experiment = smallWorld()->experiment();
  for (const char* id : {"ground", "air"}) {
    EngineDescription engine;
    engine.label = "dummy_engine";
    engine.id = id;
    experiment.engines.push_back(engine);
  }
  ControllerDescription controller;
  controller.id = "drive";
  DeviceDescription proximity;
  proximity.type = FootbotProximity::kType;
  controller.sensors.push_back(proximity);
  experiment.controllers.push_back(controller);
  return experiment;
}

inline std::string fileOf(const std::string& elements) { return "<interventions>\n" + elements + "</interventions>\n"; }

}  // namespace swarmanoid::test
