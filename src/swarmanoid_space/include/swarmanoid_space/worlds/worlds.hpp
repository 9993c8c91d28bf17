/// The same experiment many times, for learning and evolution: worlds that differ in seed and in values of the file,
/// stepped by one call, with observations and actions of all their robots as arrays.
///
/// A robot of a chosen controller configuration is an agent. It has a slot in its world: those of the start in the
/// order of entity numbers; a robot that is added later takes the first slot that is free, and is no agent if there is
/// none. Observations are the readings that its controller would get in the next tick, and actions are its commands in
/// each tick of a step. So a policy makes the same run, bit for bit, as the same computation in a controller.
/// Observations of a run that is over are the readings of its last tick.
///
/// Arrays   contiguous, [worlds][slots][numbers] or [worlds][slots]; they stay in place while this object lives.
/// Threads  all functions from one thread. Worlds are stepped on `threads` threads, one thread for a world; results do
///          not depend on their number.
/// Units    those of the devices' fields; float32. A field of a sensor's list, such as the blobs of a camera, is read
/// by
///          direction, scaled as the inputs of neural controllers: "footbot_camera.blobs.distance[sectors=8 near
///          maximum=3 colors=yellow,green]" (docs/reference/neural_controllers.md has the attributes).
/// Errors   ConfigError for a wrong experiment or option. An exception in a world ends that world's run; `step` and
///          `reset` throw a std::runtime_error with the number and the reason of the first such world, after all others
///          are done.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_space/experiment/experiment.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {

/// What happens to a world whose run is over, as Gymnasium's AutoresetMode.
enum class Autoreset : std::uint8_t {
  kNextStep,  ///< the next step resets it, makes no tick, and ignores its actions
  kSameStep,  ///< it is reset at once: observations are those of the new run, finalObservations those of the old one
  kDisabled   ///< it stays as it is until `reset`
};

class Worlds {
 public:
  struct Options {
    std::size_t count = 1;                  ///< number of worlds, to a million
    std::string controller;                 ///< id of the configuration of the agents; "": the only one
    std::vector<std::string> observations;  ///< fields of sensors, such as "footbot_proximity.value"
    std::vector<std::string> actions;       ///< fields of actuators, such as "footbot_wheels.left"
    std::string reward;                     ///< a metric of the run, whose rise in a step rewards each agent; "": none.
                                            ///< Reading metrics allocates; nothing else in a step of the suite does
    std::size_t ticks_per_step = 1;         ///< from 1
    std::size_t threads = 1;                ///< from 1 to 1024
    Autoreset autoreset = Autoreset::kNextStep;
  };
  /// Returns the experiment of a world, with its seed; called once for each world, in order.
  using Describe = std::function<Experiment(std::size_t world)>;

  /// What a world's simulation gets besides its experiment; `group_controllers` of the agents are overwritten.
  struct Supply {
    RunContext context;
    SuppliedParts parts;
  };
  /// Called once for each world, in order.
  using Supplies = std::function<Supply(std::size_t world)>;

  Worlds(Options options, const Describe& describe);
  /// The same with rules, scripts or output of each world. Parts in another language than C++ must expect calls from
  /// any of the threads.
  Worlds(Options options, const Describe& describe, const Supplies& supplies);
  ~Worlds();
  Worlds(const Worlds&) = delete;
  Worlds& operator=(const Worlds&) = delete;

  const Options& options() const;
  std::size_t count() const { return options().count; }
  /// Number of agents that a world may have: the most of any world at the start.
  std::size_t slots() const;
  std::size_t observationSize() const;  ///< numbers of an agent
  std::size_t actionSize() const;       ///< numbers of an agent

  /// Starts the runs of some worlds anew. @param chosen of each world, not 0: it is reset; null: all worlds
  /// @param seeds of each world; null: the last one plus the number of worlds
  void reset(const std::uint8_t* chosen = nullptr, const std::uint64_t* seeds = nullptr);
  /// The state of a world's run (snapshot.hpp). @pre world < count() @throws std::runtime_error as Simulation::snapshot
  std::shared_ptr<const Snapshot> snapshot(std::size_t world) const;
  /// Goes on from a snapshot in some worlds, each with the same state; rewards become 0. @param chosen as of `reset`
  /// @throws std::runtime_error if it is of another experiment
  void restore(const Snapshot& snapshot, const std::uint8_t* chosen = nullptr);
  /// @param actions [worlds][slots][action size]; rows without an agent are ignored
  void step(const float* actions);
  void step(const double* actions);  ///< the same without rounding to single precision

  /// Arrays of the last step or reset: rows without an agent are 0. @{
  float* observations();       ///< [worlds][slots][observation size]
  float* finalObservations();  ///< the same, of worlds that kSameStep has reset in this step; else 0
  float* rewards();            ///< [worlds][slots]
  std::uint8_t* present();     ///< [worlds][slots]: 1 for an agent whose robot remains and has not been stopped
  std::uint8_t* terminated();  ///< [worlds]: 1 if a rule has ended the run, or no agent remains
  std::uint8_t* truncated();   ///< [worlds]: 1 if the last tick of the run was made
  /// @}
  /// Writes position x, y, z and quaternion x, y, z, w of each agent in W. @param poses [worlds][slots][7]
  void readPoses(double* poses) const;

  /// The same with linear velocity [m/s] and angular velocity [rad/s] in W. @param twists [worlds][slots][6]
  void readTwists(double* twists) const;
  /// The whole state of worlds, for critics: a row for each slot, then one for each movable entity that is no agent, by
  /// entity number, as many as the most of any world at the start. Numbers of a row: 1, position [m], orientation as a
  /// quaternion x, y, z, w, linear velocity [m/s], angular velocity [rad/s], all in W; or all 0 without an entity. @{
  static constexpr std::size_t kStateNumbers = 14;
  std::size_t stateRows() const;
  void readState(double* numbers) const;  ///< [worlds][state rows][kStateNumbers]
  /// @}

  /// One world, for everything else. @pre world < count()
  const Simulation& world(std::size_t world) const;
  /// The same to change it between steps, by interventions, ticks or resets; `observe` follows.
  Simulation& world(std::size_t world);
  /// Renews all arrays but rewards after worlds were changed from outside.
  void observe();
  /// Row in Space of each slot; kNoRow for one that is not present. @pre world < count()
  std::vector<Row> rowsOf(std::size_t world) const;

  /// Bounds of each number of each field, in the order of names; infinite without. @param names as of Options
  /// @throws ConfigError for an unknown name
  static std::vector<std::vector<Range>> boundsOf(const std::vector<std::string>& names, DeviceKind kind);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace swarmanoid
