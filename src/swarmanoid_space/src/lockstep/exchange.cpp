// Part of phase 2: readings are sent to the participants, and their answers become commands. Until all have answered
// only the participants' frames change, so a waiting tick can be given up.
#include <algorithm>
#include <stdexcept>

#include "../assembly/robot_instance.hpp"
#include "swarmanoid_interface/frame_parts.hpp"
#include "swarmanoid_space/lockstep/controller_frames.hpp"
#include "swarmanoid_space/lockstep/lockstep.hpp"

namespace swarmanoid {
namespace {

void readCommands(ByteReader& in, const RemoteRobot& robot, Banks& commands, RobotInstance& instance) {
  VariableParts parts;  // actuators with spans would need storage that outlives the call; there are none
  for (const DeviceLayout& actuator : robot.actuators) {
    try {
      readBlock(*findDeviceType(actuator.type), in, commands.find(actuator.type, instance.row), parts);
    } catch (const ByteError& error) {
      throw ByteError(actuator.type + ": " + error.what());
    }
  }
  for (const auto& [key, value] : readDebugValues(in)) {
    instance.robot->debug(key, value);
  }
}

/// Skips the answer for a robot that was deleted, or got another command source, after the frame was sent.
void skipAnswer(ByteReader& in, StepStatus status, const RemoteRobot& robot) {
  if (status == StepStatus::kFailed) {
    in.text();
  } else if (status == StepStatus::kStepped) {
    for (std::size_t i = 0; i < robot.actuators.size(); ++i) {
      in.block();
    }
    readDebugValues(in);
  }
}

void fail(RobotInstance& instance, const std::string& reason, ByRow<ControllerState>& states) {
  states[instance.row].status = StepStatus::kFailed;
  instance.has_failed = true;
  instance.failure = reason;
}

}  // namespace

bool Lockstep::isCommandable(std::size_t instance, const std::vector<RobotInstance>& instances) {
  return instance != kNoInstance && !instances[instance].has_failed;
}

void Lockstep::ask(Participant& participant, const Space& space, const std::vector<RobotInstance>& instances) {
  participant.is_new = false;
  participant.needs_frame = false;
  participant.is_answered = false;
  SensorFrame& frame = participant.frame;
  frame.stamp.run = space.run;
  frame.stamp.tick = space.tick;
  frame.seed = space.seed;
  frame.time = space.time;
  frame.clocktick = space.clocktick;
  frame.data.clear();
  ByteWriter out(frame.data);
  participant.is_asked = false;
  participant.is_present.assign(participant.robots.size(), false);
  for (std::size_t i = 0; i < participant.robots.size(); ++i) {
    const std::size_t instance = participant.instances[i];
    const bool is_present = isCommandable(instance, instances);
    participant.is_present[i] = is_present;
    out.number(static_cast<std::uint8_t>(is_present));
    if (is_present) {
      participant.is_asked = true;
      writeReadings(space, instances[instance].row, participant.robots[i].sensors, out);
    }
  }
  participant.sent = Clock::now();
}

std::vector<std::shared_ptr<Lockstep::Participant>> Lockstep::askAll(const Space& space,
                                                                     const std::vector<RobotInstance>& instances) {
  std::vector<std::shared_ptr<Participant>> asked;
  for (const auto& participant : participants_) {
    if (participant->needs_frame) {
      ask(*participant, space, instances);
      if (participant->is_asked) {
        asked.push_back(participant);
      }
    }
  }
  return asked;
}

void Lockstep::forgetWhoHasGone(const std::vector<RobotInstance>& instances) {
  for (const auto& participant : participants_) {
    if (participant->needs_frame) {
      continue;
    }
    participant->is_asked = false;
    for (std::size_t i = 0; i < participant->robots.size(); ++i) {
      participant->is_asked =
          participant->is_asked || (participant->is_present[i] && isCommandable(participant->instances[i], instances));
    }
  }
}

bool Lockstep::exchange(const Space& space, const ControlAccess& access, std::vector<RobotInstance>& instances,
                        std::vector<Event>& events, const Robot::LogSink& log, const Disturbed& is_disturbed) {
  Lock lock(mutex_);
  if (participants_.empty() && offered_.empty()) {
    return true;
  }
  startWaiting(space);
  forgetWhoHasGone(instances);
  while (!isDone() && !is_cancelled_ && stop_reason_.empty()) {
    reportAll(lock, events, log);
    const auto asked = askAll(space, instances);
    if (isDone() || !asked.empty()) {
      lock.unlock();
      for (const auto& participant : asked) {
        participant->send(participant->frame);
      }
      lock.lock();
    } else if (is_disturbed && is_disturbed()) {
      given_up_ = Clock::now();
      return false;
    } else if (changed_.wait_until(lock, nextDeadline()) == std::cv_status::timeout) {
      checkDeadlines(space);
    }
  }
  finishWaiting(space);
  reportAll(lock, events, log);
  if (!stop_reason_.empty() || is_cancelled_) {
    throw std::runtime_error(is_cancelled_ ? "stopped while waiting for participants" : stop_reason_);
  }
  for (const Offered& offered : offered_) {
    access.controllers[instances[offered.instance].row].status = StepStatus::kNothing;
  }
  for (const auto& participant : participants_) {
    if (participant->is_asked && participant->is_answered) {
      apply(*participant, access, instances);
      participant->has_applied = true;
    }
  }
  return true;
}

void Lockstep::apply(const Participant& participant, const ControlAccess& access,
                     std::vector<RobotInstance>& instances) {
  ByteReader in(participant.answer.data);
  for (std::size_t i = 0; i < participant.robots.size(); ++i) {
    const std::size_t instance = participant.instances[i];
    const bool is_commanded = participant.is_present[i] && isCommandable(instance, instances);
    if (is_commanded && !participant.has_applied) {
      ++access.controllers[instances[instance].row].starts;
    }
    try {
      const auto status = static_cast<StepStatus>(in.number<std::uint8_t>());
      if (is_commanded && status == StepStatus::kStepped) {
        readCommands(in, participant.robots[i], access.commands, instances[instance]);
        access.controllers[instances[instance].row].status = StepStatus::kStepped;
      } else if (is_commanded && status == StepStatus::kFailed) {
        fail(instances[instance], in.text(), access.controllers);
      } else if (participant.is_present[i] && (status == StepStatus::kStepped || status == StepStatus::kFailed)) {
        skipAnswer(in, status, participant.robots[i]);
      } else if (participant.is_present[i] || status != StepStatus::kNothing) {
        throw ByteError("found the status " + std::to_string(static_cast<int>(status)) + ", which does not fit");
      }
    } catch (const ByteError& error) {
      // the rest of the frame cannot be read either
      for (std::size_t k = i; k < participant.robots.size(); ++k) {
        if (participant.instances[k] != kNoInstance && !instances[participant.instances[k]].has_failed) {
          fail(instances[participant.instances[k]],
               "participant '" + participant.name + "' sent a bad command frame: " + participant.robots[i].name + ": " +
                   error.what(),
               access.controllers);
        }
      }
      return;
    }
  }
}

}  // namespace swarmanoid
