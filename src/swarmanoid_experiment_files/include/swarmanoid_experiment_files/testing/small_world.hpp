/// A world without engines and controllers: two footbots, an eyebot, a prey, a block, a lamp and a nest.
#pragma once

#include <memory>
#include <string>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {

inline std::unique_ptr<Simulation> smallWorld(int ticks = 50, const std::string& clocktick_ms = "100") {
  const std::string text = R"(
<ahss-config>
  <framework><clocktick>)" +
                           clocktick_ms + R"(</clocktick><maxclock>)" + std::to_string(ticks) +
                           R"(</maxclock></framework>
  <arena size="5,5,3" optimization="2D">
    <floor_patch id="nest"><position>1, 1, 0</position><radius>0.4</radius><color>green</color></floor_patch>
    <block id="wall"><position>2.5, 4, 0.2</position><orientation>0, 0, 30</orientation><size>1, 0.1, 0.4</size></block>
    <light id="lamp"><position>2.5, 2.5, 2.9</position><orientation>0, 0, 0</orientation></light>
    <cylindric_prey id="prey"><position>3, 1, 0</position><orientation>0, 0, 0</orientation>
      <radius>0.06</radius><height>0.1</height><color>yellow</color></cylindric_prey>
    <footbot id="fb_1"><position>1, 2, 0</position><orientation>0, 0, 90</orientation></footbot>
    <footbot id="fb_2"><position>2, 2, 0</position><orientation>0, 0, 0</orientation></footbot>
    <eyebot id="eb"><position>2.5, 2.5, 2</position><orientation>0, 0, 0</orientation></eyebot>
  </arena>
</ahss-config>)";
  return std::make_unique<Simulation>(parseExperiment(text, "small_world.xml"));
}

}  // namespace swarmanoid::test
