/// Small worlds for the formulas of docs/reference/models.md: one engine, and robots that execute a function.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>

#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/robot.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {

constexpr double kDegree = M_PI / 180.0;  // rad

// of a footbot
constexpr double kWheelRadius = 0.029;  // m
constexpr double kSeparation = 0.14;    // m, of its wheels

/// Executed by robots in each tick: reads sensors, sets commands. All robots share it, and differ by name.
using Program = std::function<void(Robot&)>;
void setProgram(Program program);

/// Concatenates numbers and words.
template <class... Parts>
std::string join(const Parts&... parts) {
  std::ostringstream text;
  text.precision(17);
  (text << ... << parts);
  return text.str();
}

/// @param heading [deg]
inline std::string entity(const std::string& type, const std::string& id, double x, double y, double z,
                          double heading = 0.0, const std::string& more = "") {
  return join("<", type, " id='", id, "'><position>", x, ",", y, ",", z, "</position><orientation>0,0,", heading,
              "</orientation>", more, "</", type, ">");
}

/// A robot of a type whose controller runs the program.
inline std::string robot(const std::string& type, const std::string& id, double x, double y, double z,
                         double heading = 0.0) {
  return entity(type, id, x, y, z, heading, "<controller>" + type + "</controller>");
}

inline std::string prey(const std::string& id, double x, double y, double radius, double height,
                        const std::string& more = "") {
  return entity("cylindric_prey", id, x, y, 0.0, 0.0,
                join("<radius>", radius, "</radius><height>", height, "</height>", more));
}

inline std::string block(const std::string& id, double x, double y, double z, const std::string& size,
                         double heading = 0.0, const std::string& more = "") {
  return entity("block", id, x, y, z, heading, "<size>" + size + "</size>" + more);
}

/// Parts of an experiment; SI units, except the clocktick in milliseconds.
struct ModelWorld {
  std::string entities;
  std::string members;  ///< ids of the entities that the engine moves, separated by spaces
  std::string engine = "kinematics2d";
  std::string engine_parameters;
  std::string more_engines;  ///< more elements of <engines>
  std::string footbot_sensors;
  std::string eyebot_sensors;
  std::string eyebot_actuators = "<eyebot_velocity/><eyebot_laser/>";
  std::string handbot_actuators = "<handbot_rope/>";
  std::string handbot_sensors = "<handbot_rope_state/>";
  std::string wheels = "<footbot_wheels/>";
  std::string footbot_actuators = "<footbot_gripper/><footbot_leds/>";
  std::string extras;  ///< more elements of <arena>
  int clocktick = 100;
  std::uint64_t seed = 1;

  std::unique_ptr<Simulation> start() const;
};

inline void tick(Simulation& simulation, int ticks = 1) {
  for (int i = 0; i < ticks; ++i) {
    simulation.tick();
  }
}

inline Row rowOf(const Simulation& simulation, std::string_view name) {
  return simulation.space().entities.find(std::string(name));
}
inline const Pose& poseOf(const Simulation& simulation, std::string_view name) {
  return simulation.space().entities.pose[rowOf(simulation, name)];
}
inline const Twist& twistOf(const Simulation& simulation, std::string_view name) {
  return simulation.space().entities.twist[rowOf(simulation, name)];
}
/// Heading about z [rad].
inline double headingOf(const Simulation& simulation, std::string_view name) {
  const Eigen::Vector3d ahead = poseOf(simulation, name).orientation * Eigen::Vector3d::UnitX();
  return std::atan2(ahead.y(), ahead.x());
}

}  // namespace swarmanoid::test
