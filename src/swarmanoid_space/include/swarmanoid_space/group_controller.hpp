/// The base class of controllers that step all robots of one controller configuration at once, over arrays of readings
/// and commands, instead of one robot at a time (swarmanoid_interface/controller.hpp). It is supplied from outside
/// (supplied_parts.hpp), for example by the Python bindings; robots on hardware have no such controller.
///
/// Threads  all functions are called on the simulation's own thread.
/// Errors   an exception of `init` rejects the experiment. An exception of `start` rejects the operation that would
///          start the robot: the experiment, a spawn, a change of the command source. An exception of `step` stops all
///          robots of this step with the safe stop, and no others; a failure that `step` writes stops that robot alone.
///          Robots stopped in this way are not stepped again.
#pragma once

#include <string>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/robot.hpp"
#include "swarmanoid_interface/span.hpp"
#include "swarmanoid_interface/state_archive.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

/// A robot to be stepped.
struct GroupMember {
  Row row = kNoRow;
  Robot* robot = nullptr;          ///< for its random numbers, log and debug values; not null
  std::string* failure = nullptr;  ///< reason to stop this robot, written by `step`; empty, not null
};

class GroupController {
 public:
  virtual ~GroupController() = default;

  /// Called when the world is built, at the start and at each reset, before there are robots.
  /// @param parameters those of the configuration in the experiment file @throws ConfigError
  virtual void init(const Configuration& parameters) = 0;

  /// Called before the first step of a robot: after it was added, or after its controller became its command source
  /// again. The controller starts anew in both cases. @param commands Space::commands @throws std::exception the reason
  /// why it does not start
  virtual void start(const Space& /*space*/, Banks& /*commands*/, Row /*row*/, Robot& /*robot*/) {}

  /// The phase `control`: reads Space::readings of the members and writes their commands.
  /// @param commands Space::commands
  /// @param members by entity number: robots commanded by their controller that have not failed. May be empty.
  virtual void step(const Space& space, Banks& commands, Span<const GroupMember> members) = 0;

  /// As Controller::archive, for all robots. When it loads, the space has its state already, and all robots have been
  /// started. @param commands Space::commands
  virtual void archive(const Space& /*space*/, Banks& /*commands*/, StateArchive& state) { state.refuse(); }
};

}  // namespace swarmanoid
