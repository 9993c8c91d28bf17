// Part of phase 2: the participants that a tick waits for, their timeouts, and the reports.
#include <algorithm>

#include "../assembly/robot_instance.hpp"
#include "swarmanoid_space/lockstep/lockstep.hpp"

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
  const bool is_skipping = unassigned_reported_ && options_.policy == LatePolicy::kSkip;
  return (is_skipping || !isAnybodyUnassigned()) &&
         std::all_of(participants_.begin(), participants_.end(), [](const auto& participant) {
           const bool is_skipped = participant->is_late && participant->policy == LatePolicy::kSkip;
           return !participant->needs_frame && (!participant->is_asked || participant->is_answered || is_skipped);
         });
}

Lockstep::Seconds Lockstep::timeoutOf(const Participant& participant) const {
  return participant.has_applied ? participant.timeout : std::max(participant.timeout, options_.join_timeout);
}

Lockstep::Clock::time_point Lockstep::nextDeadline() const {
  const auto after = [](Clock::time_point from, Seconds timeout) {
    return from + std::chrono::duration_cast<Clock::duration>(timeout);
  };
  // the wait for a reported participant has no deadline; this one is for the next report
  Clock::time_point next = after(Clock::now(), Seconds(3600.0));
  if (!unassigned_reported_ && isAnybodyUnassigned()) {
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
  const std::vector<std::string> unassigned = unassignedRobots();
  if (!unassigned.empty() && !unassigned_reported_ && now - started_ >= options_.join_timeout) {
    unassigned_reported_ = true;
    const std::string text = "no participant has registered for " + joinNames(unassigned) + in_tick + " (" +
                             toText(options_.join_timeout) + "); policy " + toString(options_.policy);
    notices_.push_back({Event::Kind::kParticipantLate, "", text});
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
    notices_.push_back({Event::Kind::kParticipantLate, participant->name, text});
    if (participant->policy == LatePolicy::kStop && stop_reason_.empty()) {
      stop_reason_ = "participant '" + participant->name + "': " + text;
    }
  }
}

void Lockstep::finishWaiting(const Space& space) {
  for (const auto& participant : participants_) {
    if (participant->is_answered && participant->is_late) {
      participant->is_late = false;
      notices_.push_back(
          {Event::Kind::kParticipantJoined, participant->name, "is back in tick " + std::to_string(space.tick)});
    }
  }
}

void Lockstep::report(const Notice& notice, std::vector<Event>& events, const Robot::LogSink& log) {
  events.push_back({notice.kind, notice.participant, "", notice.text});
  if (log) {
    const bool is_good = notice.kind == Event::Kind::kParticipantJoined;
    log(is_good ? LogLevel::kInfo : LogLevel::kWarning,
        notice.participant.empty() ? "lockstep" : "participant '" + notice.participant + "'", notice.text);
  }
}

void Lockstep::reportAll(Lock& lock, std::vector<Event>& events, const Robot::LogSink& log) {
  std::vector<Notice> notices;
  notices.swap(notices_);
  lock.unlock();
  for (const Notice& notice : notices) {
    report(notice, events, log);
  }
  lock.lock();
}

}  // namespace swarmanoid
