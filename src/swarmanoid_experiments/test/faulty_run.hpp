/// Two robots, one of which gets faults, for tests.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {

using Errors = std::vector<ErrorModelDescription>;

inline ErrorModelDescription error(const std::string& kind, const std::string& field = "",
                                   const std::map<std::string, std::string>& parameters = {},
                                   std::uint64_t from_tick = 0) {
  ErrorModelDescription result;
  result.kind = kind;
  result.field = field;
  result.from_tick = from_tick;
  for (const auto& [name, value] : parameters) {
    result.parameters.set(name, value);
  }
  return result;
}

/// Two robots far apart, and a prey 18 cm ahead of the first one.
inline World twoRobots(const std::string& speed = "0") {
  World world;
  world.entities = footbot("fb_1", 3.0, 5.0, 0.0) + footbot("fb_2", 7.0, 5.0, 0.0) +
                   "<cylindric_prey id='prey'><position>3.18, 5, 0</position><orientation>0, 0, 0</orientation>"
                   "<radius>0.06</radius><height>0.1</height><color>yellow</color></cylindric_prey>";
  world.members = member("fb_1") + member("fb_2");
  world.drive = "<left>" + speed + "</left><right>" + speed + "</right>";
  return world;
}

/// The same world with child elements in its proximity sensor.
inline std::unique_ptr<Simulation> withErrors(const std::string& elements) {
  loadBuiltInPlugins();
  std::string text = twoRobots().xml();
  const std::string sensor = "<footbot_proximity/>";
  text.replace(text.find(sensor), sensor.size(), "<footbot_proximity>" + elements + "</footbot_proximity>");
  return std::make_unique<Simulation>(parseExperiment(text, "test.xml"));
}

class FaultyRun {
 public:
  explicit FaultyRun(std::unique_ptr<Simulation> made) : simulation(std::move(made)) { simulation->start(); }
  explicit FaultyRun(const World& world) : FaultyRun(world.make()) {}

  void set(const std::string& robot, const std::string& device, const Errors& errors) {
    simulation->apply(SetFault{robot, device, errors});
  }
  void tick(int ticks = 1) {
    for (int i = 0; i < ticks; ++i) {
      simulation->tick();
    }
  }
  /// Reading of the proximity sensor after one more tick.
  float next(const std::string& robot, std::size_t sensor) {
    tick();
    return reading(robot, sensor);
  }
  float reading(const std::string& robot, std::size_t sensor) const {
    const Space& space = simulation->space();
    return space.readings.find<FootbotProximity>(space.entities.find(robot))->value[sensor];
  }
  void movePrey(double x) { simulation->apply(MoveEntity{"prey", {{x, 5.0, 0.0}, Eigen::Quaterniond::Identity()}}); }
  double x(const std::string& robot) const { return poseOf(*simulation, robot).position.x(); }
  std::uint64_t deep() const { return deepHash(simulation->space()); }

  std::unique_ptr<Simulation> simulation;
};

inline constexpr const char* kProximity = "footbot_proximity";
inline constexpr const char* kWheels = "footbot_wheels";

}  // namespace swarmanoid::test
