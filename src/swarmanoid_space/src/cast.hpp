/// Who acts in a simulation: engines, devices, controllers, visualisations.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_space/actuator.hpp"
#include "swarmanoid_space/engine.hpp"
#include "swarmanoid_space/sensor.hpp"
#include "swarmanoid_space/simulation.hpp"
#include "swarmanoid_space/visualisation.hpp"
#include "workers.hpp"

namespace swarmanoid {

/// One controller configuration of the experiment, with the devices that all its robots share.
struct ControllerGroup {
  const ControllerDescription* description = nullptr;
  std::vector<std::shared_ptr<Sensor>> sensors;
  std::vector<std::shared_ptr<Actuator>> actuators;
  std::function<std::shared_ptr<Controller>()> make;
};

/// One robot with its controller.
struct Driver {
  Row row = kNoRow;
  Robot* robot = nullptr;
  ControllerGroup* group = nullptr;
  std::shared_ptr<Controller> controller;
  bool has_failed = false;
  std::string failure;  ///< set by `control` or `actuate` in the tick in which it fails
};

struct Simulation::Seat {
  Engine* engine = nullptr;
  Role role = Role::kMove;
};

struct Simulation::Cast {
  explicit Cast(int threads) : workers(threads) {}

  Workers workers;
  std::vector<std::shared_ptr<Engine>> engines;
  std::vector<std::unique_ptr<ControllerGroup>> groups;
  std::vector<Driver> drivers;                       ///< by entity number
  std::vector<std::vector<Simulation::Seat>> seats;  ///< by entity row
  std::vector<std::shared_ptr<Visualisation>> visualisations;
  std::vector<Row> faulty;  ///< scratch of `actuate`

  Engine* findEngine(const std::string& id) const;
  ControllerGroup* findGroup(const std::string& id) const;
  Driver* findDriver(Row row);
};

}  // namespace swarmanoid
