/// Robots at given poses, without engines, and a rule that measures them.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {

/// Position and heading of a footbot.
struct Stand {
  double x = 0.0;        ///< m
  double y = 0.0;        ///< m
  double heading = 0.0;  ///< rad
};

inline Pose poseOf(const Stand& stand) {
  return {{stand.x, stand.y, 0.0}, Eigen::Quaterniond(Eigen::AngleAxisd(stand.heading, Eigen::Vector3d::UnitZ()))};
}

inline std::string standingFootbot(const std::string& id, const Stand& stand) {
  return "<footbot id='" + id + "'><position>" + numberText(stand.x) + "," + numberText(stand.y) +
         ",0</position><orientation>0,0," + numberText(stand.heading * 180.0 / M_PI) + "</orientation></footbot>\n";
}

/// Ticks of 0.1 s in an arena of 10 m x 10 m; footbots fb_1, fb_2, ..., and one with a name outside the group.
class MeasuredRun {
 public:
  /// @param rule with the id `r` @param more further elements of the arena
  explicit MeasuredRun(const std::string& rule, const std::vector<Stand>& stands, const std::string& more = "")
      : simulation_(make(rule, stands, more)) {
    simulation_->start();
  }

  double metric(const std::string& name) const { return std::get<double>(simulation_->metrics().at("r." + name)); }
  void tick(int count = 1) {
    for (int i = 0; i < count; ++i) {
      simulation_->tick();
    }
  }
  /// Takes effect at once; the rule measures it after the next tick.
  void put(const std::string& entity, const Stand& stand) { simulation_->apply(MoveEntity{entity, poseOf(stand)}); }
  void remove(const std::string& entity) { simulation_->apply(DeleteEntity{entity}); }
  /// Adds a footbot like those of the file.
  void spawn(const std::string& id, const Stand& stand) {
    EntityDescription robot = simulation_->experiment().arena.entities.front();
    robot.id = id;
    robot.position = {stand.x, stand.y, 0.0};
    robot.angles = {0.0, 0.0, stand.heading};
    simulation_->apply(SpawnEntity{robot, {}});
  }
  Simulation& simulation() { return *simulation_; }

 private:
  static std::unique_ptr<Simulation> make(const std::string& rule, const std::vector<Stand>& stands,
                                          const std::string& more) {
    loadPluginLibrary("swarmanoid_devices", {}, {});
    std::string robots = standingFootbot("other", {9.3, 9.1, 1.1});
    for (std::size_t i = 0; i < stands.size(); ++i) {
      robots += standingFootbot("fb_" + std::to_string(i + 1), stands[i]);
    }
    return std::make_unique<Simulation>(
        parseExperiment("<ahss-config><framework><clocktick>100</clocktick><maxclock>1000</maxclock></framework>\n"
                        "<arena size='10,10,3' optimization='2D'>\n" +
                            robots + more + "</arena>\n<rules>\n" + rule + "\n</rules></ahss-config>",
                        "run.xml"));
  }

  std::unique_ptr<Simulation> simulation_;
};

/// @return number of heap allocations of a tick in a steady state
inline long allocationsOfATick(MeasuredRun& run) {
  constexpr int kSome = 5;
  run.tick(kSome);
  const long before = heap_allocations;
  run.simulation().tick();
  return heap_allocations - before;
}

/// Reason why a rule is refused, or "" if it is accepted.
inline std::string refusalOfRule(const std::string& rule) {
  try {
    const MeasuredRun run(rule, {{1.0, 1.0, 0.0}});
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

}  // namespace swarmanoid::test
