/// Access objects: the parts of the space that plugins may write, by phase.
///
/// In a tick, engines, sensors and actuators get the space const, and one of these objects with the columns and lists
/// that they may write in that phase. A plugin cannot make an access object, because the constructor needs a space that
/// is not const: an engine that lights an LED does not compile. Neither does an access object with a column of another
/// phase, since a column names its phases in its type (WrittenIn).
///
/// Cost     references only.
/// Threads  an access object may be used by several threads, for different entities.
#pragma once

#include <vector>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

/// For sensors that report on the readings of a tick.
struct ReportAccess {
  explicit ReportAccess(Space& space) : events(space.events), overflows(space.overflows) {}

  std::vector<Event>& events;
  std::vector<Overflow>& overflows;
};

/// For commands of controllers, in this process and in others, and of topics.
struct ControlAccess {
  explicit ControlAccess(Space& space)
      : commands(space.commands), controllers(writable<WrittenIn::kControl>(space.controllers)) {}

  Banks& commands;
  ByRow<ControllerState>& controllers;
};

/// For actuators, and for safe stops.
struct ActuateAccess {
  explicit ActuateAccess(Space& space)
      : wheels(writable<WrittenIn::kActuate>(space.wheels)),
        flight(writable<WrittenIn::kActuate>(space.flight)),
        joint_commands(writable<WrittenIn::kActuate>(space.joint_commands)),
        holder_commands(writable<WrittenIn::kActuate>(space.holder_commands)),
        leds(writable<WrittenIn::kActuate>(space.leds)),
        properties(writable<WrittenIn::kActuate>(space.properties)) {}

  ByRow<WheelsCommand>& wheels;
  ByRow<FlightCommand>& flight;
  ListByRow<JointCommand>& joint_commands;
  ListByRow<HolderCommand>& holder_commands;
  ListByRow<Color>& leds;
  ListByRow<double>& properties;  ///< of radio tags: their data (kTagData)
};

/// For engines that move their entities.
struct MoveAccess {
  explicit MoveAccess(Space& space)
      : pose(writable<WrittenIn::kMove>(space.entities.pose)),
        twist(writable<WrittenIn::kMove>(space.entities.twist)),
        joints(writable<WrittenIn::kMove>(space.joints)),
        wheel_turns(writable<WrittenIn::kMove>(space.wheel_turns)) {}

  ByRow<Pose>& pose;
  ByRow<Twist>& twist;
  ListByRow<JointState>& joints;
  ByRow<WheelTurns>& wheel_turns;
};

/// For engines that make and break grips and attachments.
struct ConnectAccess {
  explicit ConnectAccess(Space& space)
      : structure(space.structure), attachments(space.attachments), events(space.events) {}

  StructuralTree& structure;
  Attachments& attachments;
  std::vector<Event>& events;
};

/// For actuators, once the engines have moved (Actuator::afterMove).
struct AfterMoveAccess {
  explicit AfterMoveAccess(Space& space)
      : laser_spots(space.laser_spots), wheel_turns(writable<WrittenIn::kConnect>(space.wheel_turns)) {}

  std::vector<LaserSpot>& laser_spots;
  ByRow<WheelTurns>& wheel_turns;
};

/// For handovers.
struct HandOverAccess {
  explicit HandOverAccess(Space& space)
      : mover(writable<WrittenIn::kConnect>(space.mover)), entities_without_engine(space.entities_without_engine) {}

  ByRow<const Engine*>& mover;
  EntitiesWithoutEngine& entities_without_engine;
};

/// For the phase `index`.
struct IndexAccess {
  explicit IndexAccess(Space& space)
      : index(space.index), outside(writable<WrittenIn::kIndex>(space.outside)), events(space.events) {}

  PositionalIndex& index;
  ByRow<char>& outside;
  std::vector<Event>& events;
};

/// For the phase `power`.
struct PowerAccess {
  explicit PowerAccess(Space& space)
      : batteries(writable<WrittenIn::kPower>(space.batteries)),
        properties(writable<WrittenIn::kPower>(space.properties)) {}

  ListByRow<BatteryState>& batteries;
  ListByRow<double>& properties;  ///< of robots with a battery: their stores
};

}  // namespace swarmanoid
