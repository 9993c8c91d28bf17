// Part of phase 2: what has come over topics becomes commands; who gets none for too long stops.
#include "phases.hpp"
#include "swarmanoid_interface/command_mailbox.hpp"
#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid::phases {
namespace {

void tell(Space& space, const Driver& driver, LogLevel level, const std::string& text, const Robot::LogSink& log) {
  space.events.push_back({Event::Kind::kIntervention, driver.robot->name(), "", text});
  if (log) {
    log(level, driver.robot->name(), text);
  }
}

/// @return whether there were any
bool obey(const CommandMailbox::Commands& commands, Space& space, const Driver& driver) {
  bool is_told = false;
  VariableParts parts;  // actuators with spans would need a place that lasts; there are none
  for (const auto& actuator : driver.group->actuators) {
    const auto command = commands.find({driver.robot->name(), actuator->type()});
    if (command != commands.end()) {
      ByteReader in(command->second);
      findDeviceType(actuator->type())->read(in, space.commands.find(actuator->type(), driver.row), parts);
      is_told = true;
    }
  }
  return is_told;
}

}  // namespace

void obeyTopics(Space& space, std::vector<Driver>& drivers, CommandMailbox& mailbox, const Robot::LogSink& log) {
  if (mailbox.isIdle()) {
    return;
  }
  const CommandMailbox::Commands commands = mailbox.take();
  for (Driver& driver : drivers) {
    if (driver.source != CommandSource::kTopics || driver.has_failed) {
      continue;
    }
    if (obey(commands, space, driver)) {
      driver.last_command = space.time;
      driver.stops_since.reset();
      if (!driver.is_told) {
        driver.is_told = true;
        tell(space, driver, LogLevel::kInfo, "commands come over topics", log);
      }
    } else if (driver.is_told && space.time - driver.last_command >= driver.command_timeout) {
      driver.is_told = false;
      driver.stops_since = space.time;
      tell(space, driver, LogLevel::kWarning, "no more commands over topics, the robot stops", log);
    }
  }
}

}  // namespace swarmanoid::phases
