/// Shared by the tests of whole simulations: a controller that follows its parameters, and small experiments.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {

/// A world with one plane, z = 0, in which "test_drive" drives footbots.
struct World {
  std::string entities;                                  ///< elements of <arena>
  std::string members;                                   ///< elements of the engine's mapping
  std::string drive = "<left>0</left><right>0</right>";  ///< parameters of the controller "drive"
  std::string engine_parameters;                         ///< elements of <kinematics2d>
  std::string framework;                                 ///< more elements of <framework>
  std::string engines;                                   ///< more elements of <engines>
  std::string physics;                                   ///< more elements of <arena_physics>
  std::string rules;                                     ///< elements of <rules>
  std::string visualisations;                            ///< elements of <visualisations>
  std::string size = "10,10,2";
  std::string center;  ///< of the arena; empty: none
  bool bounded = false;
  int ticks = 100;

  std::string xml() const;
  std::unique_ptr<Simulation> make() const;
};

/// A footbot at a position, driven by "drive"; `member` is its line in the mapping.
std::string footbot(const std::string& id, double x, double y, double heading_deg);
std::string member(const std::string& id);

inline void tick(Simulation& simulation, int ticks = 1) {
  for (int i = 0; i < ticks; ++i) {
    simulation.tick();
  }
}

/// Pose of an entity.
const Pose& poseOf(const Simulation& simulation, std::string_view name);
/// Its heading about z [rad].
double headingOf(const Simulation& simulation, const std::string& name);

/// Engine for the ground of the object retrieval experiment.
struct GroundEngine {
  std::string label = "kinematics2d";
  int subclock = 1;
};

/// The object retrieval experiment, before its first tick.
std::unique_ptr<Simulation> retrieval(std::uint64_t seed, int threads, const GroundEngine& ground = {});

/// The state hashes of the next ticks.
std::vector<std::uint64_t> hashesOf(Simulation& simulation, std::uint64_t ticks);

}  // namespace swarmanoid::test
