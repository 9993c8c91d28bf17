/// The base class of controllers that step all robots of one controller configuration at once, over arrays of readings
/// and commands, instead of one robot at a time (swarmanoid_interface/controller.hpp). It is supplied from outside
/// (supplied_parts.hpp), as the bindings to Python do; robots on hardware have no such controller.
///
/// Threads  all functions are called on the simulation's own thread.
/// Errors   an exception of `init` refuses the experiment; one of `start` refuses what would start the robot: the
///          experiment, a spawn, a change of the command source. One of `step` stops the robots of this step, each with
///          the safe stop, and only these; a failure that `step` writes down stops that robot alone. They are not
///          stepped again.
#pragma once

#include <string>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/robot.hpp"
#include "swarmanoid_interface/span.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

/// A robot that is to be stepped.
struct GroupMember {
  Row row = kNoRow;
  Robot* robot = nullptr;          ///< for its random numbers, log and debug values; not null
  std::string* failure = nullptr;  ///< `step` may write why this robot is to stop; empty, not null
};

class GroupController {
 public:
  virtual ~GroupController() = default;

  /// When the world is built, at the start and at each reset, before there are robots.
  /// @param parameters those of the configuration in the experiment file @throws ConfigError
  virtual void init(const Configuration& parameters) = 0;

  /// A robot is to be stepped from now on: it has come into the world, or its commands come from its controller again,
  /// which starts anew then. @param commands Space::commands @throws std::exception why it does not start
  virtual void start(const Space& /*space*/, Banks& /*commands*/, Row /*row*/, Robot& /*robot*/) {}

  /// The phase `control`: reads Space::readings of the members, and writes their commands.
  /// @param commands Space::commands
  /// @param members by entity number: those commanded by their controller, and not failed. May be none.
  virtual void step(const Space& space, Banks& commands, Span<const GroupMember> members) = 0;
};

}  // namespace swarmanoid
