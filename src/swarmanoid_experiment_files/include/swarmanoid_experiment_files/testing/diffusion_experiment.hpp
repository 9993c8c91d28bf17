/// The diffusion experiment at any size, for benchmarks.
#pragma once

#include <cmath>
#include <string>

namespace swarmanoid {

/// Footbots at random places in a square arena with walls, all running `diffusion`: 24 proximity rays of 10 cm.
/// @param area_per_robot [m2]; @param engine the element of `<engines>`, with the id "ground"; @param clocktick_ms [ms]
inline std::string diffusionExperiment(int robots, double area_per_robot, const std::string& engine,
                                       int clocktick_ms = 100) {
  const double side = std::sqrt(robots * area_per_robot);
  const std::string length = std::to_string(side);
  const std::string low = std::to_string(0.15);
  const std::string high = std::to_string(side - 0.15);
  return "<ahss-config><framework><clocktick>" + std::to_string(clocktick_ms) +
         "</clocktick><maxclock>1000000000</maxclock></framework><controllers>"
         "<diffusion id='dc' library='diffusion'><actuators><footbot_wheels/></actuators><sensors>"
         "<footbot_proximity><range>0.1</range></footbot_proximity></sensors></diffusion></controllers><arena size='" +
         length + "," + length + ",1' optimization='2D' bounded='true'><distribute quantity='" +
         std::to_string(robots) + "' layout='uniform'><minimum>" + low + "," + low + ",0</minimum><maximum>" + high +
         "," + high +
         ",0</maximum><max_trials>100000</max_trials><footbot id='fb'><controller>dc</controller></footbot>"
         "</distribute></arena><engines>" +
         engine +
         "</engines><arena_physics><engine id='ground'><entity id='fb'/></engine></arena_physics></ahss-config>";
}

}  // namespace swarmanoid
