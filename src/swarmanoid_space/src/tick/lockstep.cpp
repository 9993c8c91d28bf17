// Part of phase 2: readings go to the participants, and their answers become commands.
#include <algorithm>
#include <stdexcept>

#include "../cast.hpp"
#include "swarmanoid_interface/frame_parts.hpp"
#include "swarmanoid_space/controller_frames.hpp"
#include "swarmanoid_space/lockstep.hpp"

namespace swarmanoid {
namespace {

std::string toText(Lockstep::Seconds seconds) { return numberText(seconds.count()) + " s"; }

void readCommands(ByteReader& in, const RemoteRobot& robot, Space& space, Driver& driver) {
  VariableParts parts;  // actuators with spans would need a place that lasts; there are none
  for (const DeviceLayout& actuator : robot.actuators) {
    try {
      readBlock(*findDeviceType(actuator.type), in, space.commands.find(actuator.type, driver.row), parts);
    } catch (const ByteError& error) {
      throw ByteError(actuator.type + ": " + error.what());
    }
  }
  for (const auto& [key, value] : readDebugValues(in)) {
    driver.robot->debug(key, value);
  }
}

ControllerState& stateOf(const Driver& driver, Space& space) {
  return space.controllers[static_cast<std::size_t>(driver.row)];
}

void fail(Driver& driver, const std::string& reason, Space& space) {
  stateOf(driver, space).word = RobotWord::kFailed;
  driver.has_failed = true;
  driver.failure = reason;
}

}  // namespace

void Lockstep::send(const Space& space, const std::vector<Driver>& drivers) {
  std::vector<std::shared_ptr<Participant>> asked;
  {
    const Lock lock(mutex_);
    if (offered_.empty() && participants_.empty()) {
      return;
    }
    run_ = space.run;
    tick_ = space.tick;
    seed_ = space.seed;
    started_ = Clock::now();
    for (const auto& participant : participants_) {
      ask(*participant, space, drivers);
      if (participant->is_asked) {
        asked.push_back(participant);
      }
    }
  }
  for (const auto& participant : asked) {
    participant->send(participant->frame);
  }
}

void Lockstep::ask(Participant& participant, const Space& space, const std::vector<Driver>& drivers) {
  participant.is_new = false;
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
  for (std::size_t i = 0; i < participant.robots.size(); ++i) {
    const std::size_t driver = participant.drivers[i];
    const bool is_present = driver != kNowhere && !drivers[driver].has_failed;
    out.number(static_cast<std::uint8_t>(is_present));
    if (is_present) {
      participant.is_asked = true;
      writeReadings(space, drivers[driver].row, participant.robots[i].sensors, out);
    }
  }
  participant.sent = Clock::now();
}

bool Lockstep::isDone() const {
  const bool is_skipping = are_lonely_told_ && options_.policy == LatePolicy::kSkip;
  return (is_skipping || !isAnybodyLonely()) &&
         std::all_of(participants_.begin(), participants_.end(), [](const auto& participant) {
           const bool is_skipped = participant->is_late && participant->policy == LatePolicy::kSkip;
           return !participant->is_new && (!participant->is_asked || participant->is_answered || is_skipped);
         });
}

Lockstep::Seconds Lockstep::timeoutOf(const Participant& participant) const {
  return participant.has_obeyed ? participant.timeout : std::max(participant.timeout, options_.join_timeout);
}

Lockstep::Clock::time_point Lockstep::nextDeadline() const {
  const auto after = [](Clock::time_point from, Seconds timeout) {
    return from + std::chrono::duration_cast<Clock::duration>(timeout);
  };
  // who has been told of is waited for without an end, so this is the next moment at which something is to be told
  Clock::time_point next = after(Clock::now(), Seconds(3600.0));
  if (!are_lonely_told_ && isAnybodyLonely()) {
    next = std::min(next, after(started_, options_.join_timeout));
  }
  for (const auto& participant : participants_) {
    if (participant->is_asked && !participant->is_answered && !participant->is_late) {
      next = std::min(next, after(participant->sent, timeoutOf(*participant)));
    }
  }
  return next;
}

void Lockstep::checkDeadlines(const Space& space) {
  const Clock::time_point now = Clock::now();
  const std::string in_tick = " in tick " + std::to_string(space.tick);
  const std::vector<std::string> lonely = lonelyRobots();
  if (!lonely.empty() && !are_lonely_told_ && now - started_ >= options_.join_timeout) {
    are_lonely_told_ = true;
    const std::string text = "no participant has registered for " + joinNames(lonely) + in_tick + " (" +
                             toText(options_.join_timeout) + "); policy " + toString(options_.policy);
    notes_.push_back({Event::Kind::kParticipantLate, "", text});
    if (options_.policy == LatePolicy::kStop && stop_reason_.empty()) {
      stop_reason_ = text;
    }
  }
  for (const auto& participant : participants_) {
    if (!participant->is_asked || participant->is_answered || participant->is_late ||
        now - participant->sent < timeoutOf(*participant)) {
      continue;
    }
    participant->is_late = true;
    ++participant->times_late;
    const std::string text =
        "no answer" + in_tick + " (" + toText(timeoutOf(*participant)) + "); policy " + toString(participant->policy);
    notes_.push_back({Event::Kind::kParticipantLate, participant->name, text});
    if (participant->policy == LatePolicy::kStop && stop_reason_.empty()) {
      stop_reason_ = "participant '" + participant->name + "': " + text;
    }
  }
}

void Lockstep::receive(Space& space, std::vector<Driver>& drivers, const Robot::LogSink& log) {
  Lock lock(mutex_);
  if (participants_.empty() && offered_.empty()) {
    return;
  }
  while (!isDone() && !is_cancelled_ && stop_reason_.empty()) {
    tellAll(lock, space, log);
    std::vector<std::shared_ptr<Participant>> newcomers;
    for (const auto& participant : participants_) {
      if (participant->is_new) {
        ask(*participant, space, drivers);
        if (participant->is_asked) {
          newcomers.push_back(participant);
        }
      }
    }
    if (isDone() || !newcomers.empty()) {
      lock.unlock();
      for (const auto& participant : newcomers) {
        participant->send(participant->frame);
      }
      lock.lock();
      continue;
    }
    if (changed_.wait_until(lock, nextDeadline()) == std::cv_status::timeout) {
      checkDeadlines(space);
    }
  }
  for (const auto& participant : participants_) {
    if (participant->is_answered && participant->is_late) {
      participant->is_late = false;
      notes_.push_back(
          {Event::Kind::kParticipantJoined, participant->name, "is back in tick " + std::to_string(space.tick)});
    }
  }
  tellAll(lock, space, log);
  if (!stop_reason_.empty() || is_cancelled_) {
    throw std::runtime_error(is_cancelled_ ? "stopped while waiting for participants" : stop_reason_);
  }
  for (const auto& participant : participants_) {
    if (participant->is_asked && participant->is_answered) {
      obey(*participant, space, drivers);
      participant->has_obeyed = true;
    }
  }
}

void Lockstep::obey(const Participant& participant, Space& space, std::vector<Driver>& drivers) {
  ByteReader in(participant.answer.data);
  for (std::size_t i = 0; i < participant.robots.size(); ++i) {
    const std::size_t driver = participant.drivers[i];
    const bool is_commanded = driver != kNowhere && !drivers[driver].has_failed;
    if (is_commanded && !participant.has_obeyed) {
      ++stateOf(drivers[driver], space).starts;
    }
    try {
      const auto word = static_cast<RobotWord>(in.number<std::uint8_t>());
      if (is_commanded && word == RobotWord::kStepped) {
        readCommands(in, participant.robots[i], space, drivers[driver]);
        stateOf(drivers[driver], space).word = RobotWord::kStepped;
      } else if (is_commanded && word == RobotWord::kFailed) {
        fail(drivers[driver], in.text(), space);
      } else if (is_commanded || word != RobotWord::kNothing) {
        throw ByteError("found the word " + std::to_string(static_cast<int>(word)) + ", which does not fit");
      }
    } catch (const ByteError& error) {
      // what follows cannot be read either
      for (std::size_t k = i; k < participant.robots.size(); ++k) {
        if (participant.drivers[k] != kNowhere && !drivers[participant.drivers[k]].has_failed) {
          fail(drivers[participant.drivers[k]],
               "participant '" + participant.name + "' sent a bad command frame: " + participant.robots[i].name + ": " +
                   error.what(),
               space);
        }
      }
      return;
    }
  }
}

void Lockstep::tell(const Note& note, Space& space, const Robot::LogSink& log) const {
  space.events.push_back({note.kind, note.participant, "", note.text});
  if (log) {
    const bool is_good = note.kind == Event::Kind::kParticipantJoined;
    log(is_good ? LogLevel::kInfo : LogLevel::kWarning,
        note.participant.empty() ? "lockstep" : "participant '" + note.participant + "'", note.text);
  }
}

void Lockstep::tellAll(Lock& lock, Space& space, const Robot::LogSink& log) {
  std::vector<Note> notes;
  notes.swap(notes_);
  lock.unlock();
  for (const Note& note : notes) {
    tell(note, space, log);
  }
  lock.lock();
}

}  // namespace swarmanoid
