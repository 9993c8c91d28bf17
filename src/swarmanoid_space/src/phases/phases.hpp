/// The phases of a tick, one file each, in this order. A phase gets the space const, and the parts that it writes:
/// single columns and lists, or an access object (access.hpp), which it passes on to the plugins that it calls.
#pragma once

#include <memory>
#include <vector>

#include "../assembly/handover.hpp"
#include "../assembly/robot_instance.hpp"
#include "../assembly/workers.hpp"
#include "swarmanoid_interface/command_mailbox.hpp"
#include "swarmanoid_space/access.hpp"
#include "swarmanoid_space/intervention_queue.hpp"

namespace swarmanoid::phases {

/// Sensor banks read the space and fill in the readings, with their errors. Repeated calls in one tick give the same
/// readings.
void sense(const Space& space, const std::vector<std::unique_ptr<ControllerGroup>>& groups, const Workers& workers);

/// Sensors report on the readings of the tick.
void report(const Space& space, const ReportAccess& access,
            const std::vector<std::unique_ptr<ControllerGroup>>& groups);

/// Applies commands received over topics to the robots with that source; a robot that receives none within its timeout
/// stops.
void applyTopics(const Space& space, Banks& commands, std::vector<Event>& events, std::vector<RobotInstance>& instances,
                 CommandMailbox& mailbox, const Robot::LogSink& log);

/// Results of the pass of `control` over all robots, so that further passes are needed in few ticks.
struct Found {
  bool is_failure = false;  ///< a robot has failed, in this tick or before
  bool is_stop = false;     ///< a robot is being stopped
};

/// Every controller of this process turns readings into commands; participants have done so before, see
/// Lockstep::exchange. A robot whose controller throws is marked as failed; with a GroupController, all robots of the
/// group are. @return which kinds of robots need a further pass
Found control(const Space& space, const ControlAccess& access,
              const std::vector<std::unique_ptr<ControllerGroup>>& groups, std::vector<RobotInstance>& instances,
              const Workers& workers);

/// Robots that are being stopped get the commands of a safe stop (swarmanoid_interface/safe_stop.hpp).
void stopSafely(const Space& space, const ActuateAccess& access, std::vector<RobotInstance>& instances);

/// Commands are checked, disturbed by their errors, and limited. `faulty` gets the rows whose commands contained a
/// number that is not finite.
void actuate(const Space& space, const ActuateAccess& access,
             const std::vector<std::unique_ptr<ControllerGroup>>& groups, std::vector<Row>& faulty,
             const Workers& workers);

/// Overrides commands of robots without power: wheels are off while only the super-capacitor supplies the robot, LEDs
/// are off with an empty battery. Robots that still fly after their safe stop continue to descend.
void cutPower(const Space& space, const ActuateAccess& access, const std::vector<RobotInstance>& instances);

/// Checking this many poses takes some tens of microseconds; no thread is woken for fewer.
constexpr std::size_t kGrainOfPoses = 16384;

/// Every engine moves its entities; the positional index is closed. `seconds` gets the wall time of each engine if they
/// are timed.
void move(const Space& space, const MoveAccess& access, PositionalIndex& index,
          const std::vector<Named<Engine>>& engines, const Workers& workers, bool are_timed,
          std::vector<double>& seconds);

/// Grips are made and broken; then state that depends on the new poses is updated.
void connect(const Space& space, const ConnectAccess& access, const AfterMoveAccess& after_move,
             const std::vector<Named<Engine>>& engines, const std::vector<std::unique_ptr<ControllerGroup>>& groups);

/// Handover rules: an entity that enters, leaves, is attached ... may change the engine that moves it.
void handOver(const Space& space, const HandOverAccess& access, std::vector<Event>& events,
              const std::vector<Named<Engine>>& engines, const std::vector<RobotInstance>& instances,
              std::vector<HandoverTrigger>& triggers, ByRow<std::vector<Membership>>& memberships);

/// Entities without ground below them fall into a hole, which is an event. @param fallen gets these entities; the
/// function does not remove them
void fall(const Space& space, std::vector<Row>& fallen, std::vector<Event>& events);

/// Updates the positional index with the new poses. Entities that have left the arena get an event.
void index(const Space& space, const IndexAccess& access, const Workers& workers);

/// Batteries supply the energy that their robots used in the tick, and are charged.
void power(const Space& space, const PowerAccess& access);

/// Rules read the world, write only their metrics, and request interventions.
/// @return whether a rule requests the end, which is an event
bool rule(const Space& space, std::vector<Event>& events, const std::vector<RuleInstance>& rules,
          InterventionQueue& queue);

/// All observers draw. @return whether one requests the end of the run
bool show(const Space& space, const std::vector<ObserverInstance>& observers);

}  // namespace swarmanoid::phases
