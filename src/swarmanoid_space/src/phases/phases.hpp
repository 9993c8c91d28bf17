/// The phases of a tick, one file each, in this order. A phase gets the space const, and the parts that it writes.
/// Those that call plugins which write to the space hand all of it on: what such a plugin may write is said by its base
/// class.
#pragma once

#include <memory>
#include <vector>

#include "../assembly/handover.hpp"
#include "../assembly/robot_instance.hpp"
#include "../assembly/workers.hpp"
#include "swarmanoid_interface/command_mailbox.hpp"
#include "swarmanoid_space/intervention_queue.hpp"

namespace swarmanoid::phases {

/// Banks of sensors read the space and fill the readings, with their errors. Again in the same tick they fill in the
/// same.
void sense(const Space& space, const std::vector<std::unique_ptr<ControllerGroup>>& groups, const Workers& workers);

/// Sensors say what there is to say of the tick's readings.
void report(Space& space, const std::vector<std::unique_ptr<ControllerGroup>>& groups);

/// What has come over topics becomes the commands of the robots with that source; a robot that gets none for its
/// time-out stops.
void applyTopics(const Space& space, Banks& commands, std::vector<Event>& events, std::vector<RobotInstance>& instances,
                 CommandMailbox& mailbox, const Robot::LogSink& log);

/// What `control` has come by on its way over all robots, so that few ticks have to go over them again.
struct Found {
  bool is_failure = false;  ///< a robot that has failed, in this tick or before
  bool is_stop = false;     ///< a robot that is being stopped
};

/// Every controller of this process turns readings into commands; those of participants have done so before, see
/// Lockstep::exchange. A robot whose controller throws is marked as failed, and so are all of a group that is stepped
/// together (GroupController). @return what there is to look for among the robots
Found control(const Space& space, Banks& commands, ByRow<ControllerState>& states,
              const std::vector<std::unique_ptr<ControllerGroup>>& groups, std::vector<RobotInstance>& instances,
              const Workers& workers);

/// Robots that are being stopped get the commands of a safe stop (swarmanoid_interface/safe_stop.hpp).
void stopSafely(Space& space, std::vector<RobotInstance>& instances);

/// Commands are checked, given their errors, limited. `faulty` gets the rows whose commands held a number that is not
/// finite.
void actuate(Space& space, const std::vector<std::unique_ptr<ControllerGroup>>& groups, std::vector<Row>& faulty,
             const Workers& workers);

/// Whatever is commanded: wheels of robots that only their super-capacitor keeps alive are off, and so are the LEDs of
/// those whose battery is empty; those that still fly after their safe stop continue to descend.
void cutPower(Space& space, const std::vector<RobotInstance>& instances);

/// So many poses are looked at in some tens of microseconds: for fewer no thread is woken.
constexpr std::size_t kGrainOfPoses = 16384;

/// Every engine moves what it is in charge of. `seconds` gets the wall time that each of them takes, if they are timed.
void move(Space& space, const std::vector<Named<Engine>>& engines, const Workers& workers, bool are_timed,
          std::vector<double>& seconds);

/// Grips are made and broken; what depends on the new poses follows.
void connect(Space& space, const std::vector<Named<Engine>>& engines,
             const std::vector<std::unique_ptr<ControllerGroup>>& groups);

/// Rules for handover: an entity that enters, leaves, is attached ... may change the engine that moves it.
void handOver(Space& space, const std::vector<Named<Engine>>& engines, const std::vector<RobotInstance>& instances,
              std::vector<HandoverTrigger>& triggers, ByRow<std::vector<Membership>>& memberships);

/// Who has lost the ground falls into a hole, which is an event. @param fallen gets them; they are still there
void fall(const Space& space, std::vector<Row>& fallen, std::vector<Event>& events);

/// The positional index gets the new poses; an event names entities that have left the arena.
void index(const Space& space, PositionalIndex& index, ByRow<char>& outside, std::vector<Event>& events,
           const Workers& workers);

/// Batteries give what their robots have drawn, and take what they are charged with.
void power(Space& space);

/// Rules look at the world, of which they write nothing but their metrics, and ask for interventions.
/// @return whether one asks to finish, which is an event
bool rule(Space& space, const std::vector<RuleInstance>& rules, InterventionQueue& queue);

/// All observers draw. @return whether one asks to finish
bool show(const Space& space, const std::vector<ObserverInstance>& observers);

}  // namespace swarmanoid::phases
