// Part of phase 2: what has come over topics becomes commands; a robot that gets none for too long stops.
#include "phases.hpp"
#include "swarmanoid_interface/command_mailbox.hpp"
#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid::phases {
namespace {

void report(Space& space, const Driver& driver, LogLevel level, const std::string& text, const Robot::LogSink& log) {
  space.events.push_back({Event::Kind::kIntervention, driver.robot->name(), "", text});
  if (log) {
    log(level, driver.robot->name(), text);
  }
}

/// @return whether there was a command for the robot
bool apply(const CommandMailbox::Commands& commands, Space& space, const Driver& driver) {
  bool has_applied = false;
  VariableParts parts;  // actuators with spans would need a place that lasts; there are none
  for (const auto& actuator : driver.group->actuators) {
    const auto command = commands.find({driver.robot->name(), actuator->type()});
    if (command != commands.end()) {
      ByteReader in(command->second);
      findDeviceType(actuator->type())->read(in, space.commands.find(actuator->type(), driver.row), parts);
      has_applied = true;
    }
  }
  return has_applied;
}

}  // namespace

void applyTopics(Space& space, std::vector<Driver>& drivers, CommandMailbox& mailbox, const Robot::LogSink& log) {
  if (mailbox.isIdle()) {
    return;
  }
  const CommandMailbox::Commands commands = mailbox.take();
  for (Driver& driver : drivers) {
    if (driver.source != CommandSource::kTopics || driver.has_failed) {
      continue;
    }
    if (apply(commands, space, driver)) {
      driver.last_command = space.time;
      driver.stops_since.reset();
      if (!driver.is_commanded) {
        driver.is_commanded = true;
        report(space, driver, LogLevel::kInfo, "commands come over topics", log);
      }
    } else if (driver.is_commanded && space.time - driver.last_command >= driver.command_timeout) {
      driver.is_commanded = false;
      driver.stops_since = space.time;
      report(space, driver, LogLevel::kWarning, "no more commands over topics, the robot stops", log);
    }
  }
}

}  // namespace swarmanoid::phases
