/// A probabilistic finite state machine of a controller's parameters: states with a behaviour each, and transitions
/// between them with conditions. After AutoMoDe: Francesca, Brambilla, Brutschy, Trianni and Birattari, "AutoMoDe: a
/// novel approach to the automatic design of control software for robot swarms", Swarm Intelligence 8 (2014).
///
///     <states>
///       <search behaviour="exploration" turning="40"/>
///       <deliver behaviour="phototaxis"/>
///     </states>
///     <transitions>
///       <found from="search" to="deliver" condition="black_floor"/>
///       <delivered from="deliver" to="search" condition="white_floor" probability="0.9"/>
///     </transitions>
///
/// The machine starts in the first state. The transitions of a state are tested in the order of the file; the first one
/// that fires is taken.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/random.hpp"

namespace swarmanoid {

enum class Behaviour { kExploration, kStop, kPhototaxis, kAntiPhototaxis, kAttraction, kRepulsion };
enum class Condition { kBlackFloor, kGrayFloor, kWhiteFloor, kManyNeighbours, kFewNeighbours, kAlways };
enum class FloorShade { kBlack, kGray, kWhite };

/// Inputs of the conditions in one step.
struct Surroundings {
  FloorShade floor = FloorShade::kGray;
  std::size_t neighbours = 0;
};

struct MachineState {
  std::string name;
  Behaviour behaviour = Behaviour::kStop;
  int turning = 0;        ///< maximum number of steps of a turn; exploration only
  double strength = 0.0;  ///< weight of neighbours; attraction and repulsion only
};

struct Transition {
  std::size_t from = 0;  ///< index of a state
  std::size_t to = 0;    ///< index of a state
  Condition condition = Condition::kAlways;
  double probability = 1.0;  ///< of being taken in a step in which the condition holds
  double count = 0.0;        ///< number of neighbours at which many and few are equally likely
  double steepness = 0.0;    ///< slope of the probability over the number of neighbours

  /// Probability of being taken in this step.
  double probabilityIn(const Surroundings& surroundings) const;
};

class Machine {
 public:
  Machine() = default;
  /// Reads <states> and <transitions>. @throws ConfigError
  explicit Machine(const Configuration& parameters);

  void reset() { current_ = 0; }
  void archive(StateArchive& state) { state(current_); }
  const MachineState& state() const { return states_[current_]; }
  /// Draws one number for each transition with a probability above 0, until one is taken.
  /// @return whether a transition was taken; it may lead to the same state
  bool advance(const Surroundings& surroundings, RandomStream& random);

  bool uses(Behaviour behaviour) const;
  bool uses(Condition condition) const;

 private:
  void readState(const Configuration& state);
  void readTransition(const Configuration& transition);
  std::size_t stateOf(const Configuration& transition, const std::string& key) const;

  std::vector<MachineState> states_;
  std::vector<Transition> transitions_;
  std::size_t current_ = 0;
};

}  // namespace swarmanoid
