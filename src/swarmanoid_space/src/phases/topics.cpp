// Part of phase 2: commands received over topics are applied; a robot that receives none within its timeout stops.
#include "phases.hpp"
#include "swarmanoid_interface/command_mailbox.hpp"
#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid::phases {
namespace {

void report(std::vector<Event>& events, const RobotInstance& instance, LogLevel level, const std::string& text,
            const Robot::LogSink& log) {
  events.push_back({Event::Kind::kIntervention, instance.robot->name(), "", text});
  if (log) {
    log(level, instance.robot->name(), text);
  }
}

/// @return whether there was a command for the robot
bool apply(const CommandMailbox::Commands& received, Banks& commands, const RobotInstance& instance) {
  bool has_applied = false;
  VariableParts parts;  // actuators with spans would need storage that outlives the call; there are none
  for (const auto& actuator : instance.group->actuators) {
    const auto command = received.find({instance.robot->name(), actuator->type()});
    if (command != received.end()) {
      ByteReader in(command->second);
      findDeviceType(actuator->type())->read(in, commands.find(actuator->type(), instance.row), parts);
      has_applied = true;
    }
  }
  return has_applied;
}

}  // namespace

void applyTopics(const Space& space, Banks& commands, std::vector<Event>& events, std::vector<RobotInstance>& instances,
                 CommandMailbox& mailbox, const Robot::LogSink& log) {
  if (mailbox.isIdle()) {
    return;
  }
  const CommandMailbox::Commands received = mailbox.take();
  for (RobotInstance& instance : instances) {
    if (instance.source != CommandSource::kTopics || instance.has_failed) {
      continue;
    }
    if (apply(received, commands, instance)) {
      instance.last_command = space.time;
      instance.stops_since.reset();
      if (!instance.is_commanded) {
        instance.is_commanded = true;
        report(events, instance, LogLevel::kInfo, "commands come over topics", log);
      }
    } else if (instance.is_commanded && space.time - instance.last_command >= instance.command_timeout) {
      instance.is_commanded = false;
      instance.stops_since = space.time;
      report(events, instance, LogLevel::kWarning, "no more commands over topics, the robot stops", log);
    }
  }
}

}  // namespace swarmanoid::phases
