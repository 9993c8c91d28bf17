// Part of phase 2: for whom a tick waits, how long, and what is told of it.
#include <algorithm>

#include "../cast.hpp"
#include "swarmanoid_space/lockstep.hpp"

namespace swarmanoid {
namespace {

std::string toText(Lockstep::Seconds seconds) { return numberText(seconds.count()) + " s"; }

}  // namespace

void Lockstep::startWaiting(const Space& space) {
  const Clock::time_point now = Clock::now();
  const bool is_same_tick = given_up_ && run_ == space.run && tick_ == space.tick;
  const Clock::duration away = is_same_tick ? now - *given_up_ : Clock::duration::zero();
  started_ = is_same_tick ? started_ + away : now;
  given_up_.reset();
  run_ = space.run;
  tick_ = space.tick;
  seed_ = space.seed;
  for (const auto& participant : participants_) {
    const FrameStamp& stamp = participant->frame.stamp;
    participant->needs_frame = participant->is_new || stamp.run != space.run || stamp.tick != space.tick;
    if (!participant->needs_frame) {
      participant->sent += away;
    }
  }
}

bool Lockstep::isDone() const {
  const bool is_skipping = are_lonely_told_ && options_.policy == LatePolicy::kSkip;
  return (is_skipping || !isAnybodyLonely()) &&
         std::all_of(participants_.begin(), participants_.end(), [](const auto& participant) {
           const bool is_skipped = participant->is_late && participant->policy == LatePolicy::kSkip;
           return !participant->needs_frame && (!participant->is_asked || participant->is_answered || is_skipped);
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

void Lockstep::finishWaiting(const Space& space) {
  for (const auto& participant : participants_) {
    if (participant->is_answered && participant->is_late) {
      participant->is_late = false;
      notes_.push_back(
          {Event::Kind::kParticipantJoined, participant->name, "is back in tick " + std::to_string(space.tick)});
    }
  }
}

void Lockstep::tell(const Note& note, std::vector<Event>& events, const Robot::LogSink& log) {
  events.push_back({note.kind, note.participant, "", note.text});
  if (log) {
    const bool is_good = note.kind == Event::Kind::kParticipantJoined;
    log(is_good ? LogLevel::kInfo : LogLevel::kWarning,
        note.participant.empty() ? "lockstep" : "participant '" + note.participant + "'", note.text);
  }
}

void Lockstep::tellAll(Lock& lock, std::vector<Event>& events, const Robot::LogSink& log) {
  std::vector<Note> notes;
  notes.swap(notes_);
  lock.unlock();
  for (const Note& note : notes) {
    tell(note, events, log);
  }
  lock.lock();
}

}  // namespace swarmanoid
