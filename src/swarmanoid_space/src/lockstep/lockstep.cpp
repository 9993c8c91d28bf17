// Participants and their answers; the exchange of a tick is in exchange.cpp.
#include "swarmanoid_space/lockstep/lockstep.hpp"

#include <algorithm>
#include <stdexcept>

#include "swarmanoid_interface/contains.hpp"

namespace swarmanoid {

const char* toString(LatePolicy policy) {
  switch (policy) {
    case LatePolicy::kWait:
      return "wait";
    case LatePolicy::kSkip:
      return "skip";
    case LatePolicy::kStop:
      return "stop";
  }
  return "";
}

std::optional<LatePolicy> parseLatePolicy(const std::string& text) {
  for (const LatePolicy policy : {LatePolicy::kWait, LatePolicy::kSkip, LatePolicy::kStop}) {
    if (text == toString(policy)) {
      return policy;
    }
  }
  return std::nullopt;
}

void Lockstep::setOptions(const Options& options) {
  const std::lock_guard<std::mutex> lock(mutex_);
  options_ = options;
}

void Lockstep::offer(const std::vector<std::pair<RemoteRobot, std::size_t>>& robots, const Space& space) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::vector<std::string> unassigned_before = unassignedRobots();
  offered_.clear();
  for (const auto& [robot, instance] : robots) {
    offered_.push_back({robot, instance, false});
  }
  for (const auto& participant : participants_) {
    resolve(*participant);
  }
  markCommanded();
  const std::vector<std::string> unassigned = unassignedRobots();
  const bool is_known = std::all_of(unassigned.begin(), unassigned.end(),
                                    [&](const std::string& name) { return contains(unassigned_before, name); });
  unassigned_reported_ = unassigned_reported_ && is_known && run_ == space.run && stop_reason_.empty();
  if (run_ != space.run) {
    given_up_.reset();
  }
  run_ = space.run;
  tick_ = space.tick;
  seed_ = space.seed;
  clocktick_ = space.clocktick;
  stop_reason_.clear();
}

void Lockstep::resolve(Participant& participant) {
  participant.instances.assign(participant.robots.size(), kNoInstance);
  for (std::size_t i = 0; i < participant.robots.size(); ++i) {
    for (const Offered& offered : offered_) {
      if (offered.robot.name == participant.robots[i].name &&
          offered.robot.controller == participant.robots[i].controller) {
        participant.instances[i] = offered.instance;
      }
    }
  }
}

void Lockstep::markCommanded() {
  for (Offered& offered : offered_) {
    offered.is_commanded = std::any_of(participants_.begin(), participants_.end(), [&](const auto& participant) {
      const auto& instances = participant->instances;
      return std::find(instances.begin(), instances.end(), offered.instance) != instances.end();
    });
  }
}

Registration Lockstep::join(const Request& request, Send send) {
  const std::lock_guard<std::mutex> lock(mutex_);
  auto joined = std::make_shared<Participant>();
  joined->name = request.participant;
  joined->policy = request.policy.value_or(options_.policy);
  joined->timeout = request.timeout.value_or(options_.timeout);
  joined->send = std::move(send);
  if (request.participant.empty() || request.robots.empty()) {
    throw std::runtime_error(
        "found a registration without a name or without robots, allowed: a name, and one robot or "
        "more");
  }
  for (const std::string& robot : request.robots) {
    const auto found = std::find_if(offered_.begin(), offered_.end(),
                                    [&](const Offered& offered) { return offered.robot.name == robot; });
    if (found == offered_.end()) {
      std::vector<std::string> known;
      for (const Offered& offered : offered_) {
        known.push_back(offered.robot.name);
      }
      throw std::runtime_error("robot '" + robot + "' is not commanded from another process; those are: " +
                               (known.empty() ? "none" : joinNames(known)) + didYouMean(robot, known));
    }
    for (const auto& other : participants_) {
      const auto& instances = other->instances;
      if (other->name != joined->name && !other->is_late &&
          std::find(instances.begin(), instances.end(), found->instance) != instances.end()) {
        throw std::runtime_error("robot '" + robot + "' is commanded by participant '" + other->name + "'");
      }
    }
    if (std::find(joined->instances.begin(), joined->instances.end(), found->instance) != joined->instances.end()) {
      throw std::runtime_error("found robot '" + robot + "' twice, allowed: once");
    }
    joined->robots.push_back(found->robot);
    joined->instances.push_back(found->instance);
  }
  const bool is_again = replace(*joined);
  joined->frame.stamp.session = ++last_session_;
  const auto place = std::find_if(participants_.begin(), participants_.end(),
                                  [&](const auto& other) { return joined->name < other->name; });
  participants_.insert(place, joined);
  markCommanded();
  unassigned_reported_ = unassigned_reported_ && isAnybodyUnassigned();
  notices_.push_back({Event::Kind::kParticipantJoined, joined->name,
                      std::string(is_again ? "again, " : "") + "for " + joinNames(request.robots)});
  changed_.notify_all();
  return {last_session_, run_, tick_, seed_, clocktick_, joined->robots};
}

bool Lockstep::replace(Participant& joined) {
  bool is_again = false;
  for (auto other = participants_.begin(); other != participants_.end();) {
    const bool is_former_self = (*other)->name == joined.name;
    if (is_former_self) {
      is_again = true;
      joined.times_late = (*other)->times_late;
      joined.refused = (*other)->refused;
      joined.answers = (*other)->answers;
    }
    const bool is_in_the_way =
        std::any_of((*other)->instances.begin(), (*other)->instances.end(), [&](std::size_t instance) {
          return instance != kNoInstance &&
                 std::find(joined.instances.begin(), joined.instances.end(), instance) != joined.instances.end();
        });
    other = is_former_self || is_in_the_way ? participants_.erase(other) : other + 1;
  }
  return is_again;
}

std::string Lockstep::answer(CommandFrame frame) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = std::find_if(participants_.begin(), participants_.end(), [&](const auto& participant) {
    return participant->frame.stamp.session == frame.stamp.session;
  });
  if (found == participants_.end()) {
    return "session " + std::to_string(frame.stamp.session) + " is over, or never was";
  }
  Participant& participant = **found;
  const bool is_this_tick = participant.is_asked && frame.stamp == participant.frame.stamp;
  if (is_this_tick && !participant.is_answered) {
    participant.answer = std::move(frame);
    participant.is_answered = true;
    ++participant.answers;
    if (isDone()) {
      changed_.notify_all();
    }
    return "";
  }
  if (participant.is_late && !is_this_tick && participant.policy == LatePolicy::kSkip) {
    participant.is_late = false;  // the participant is alive, and is waited for again from its next frame on
    notices_.push_back({Event::Kind::kParticipantJoined, participant.name,
                        "is back: it answered for tick " + std::to_string(frame.stamp.tick)});
    return "too late for tick " + std::to_string(frame.stamp.tick);
  }
  std::string problem = is_this_tick ? "answered twice for tick " + std::to_string(frame.stamp.tick)
                                     : "answered for tick " + std::to_string(frame.stamp.tick) + " of run " +
                                           std::to_string(frame.stamp.run) + ", asked for tick " +
                                           std::to_string(participant.frame.stamp.tick) + " of run " +
                                           std::to_string(participant.frame.stamp.run);
  if (participant.refused++ == 0) {
    notices_.push_back({Event::Kind::kAnswerRefused, participant.name, problem + "; more of the like is only counted"});
  }
  return problem;
}

std::vector<Lockstep::Report> Lockstep::reports() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<Report> reports;
  for (const auto& participant : participants_) {
    Report report{participant->name,   {}, participant->is_late, participant->answers, participant->times_late,
                  participant->refused};
    for (const RemoteRobot& robot : participant->robots) {
      report.robots.push_back(robot.name);
    }
    reports.push_back(std::move(report));
  }
  const std::vector<std::string> unassigned = unassignedRobots();
  if (!unassigned.empty()) {
    reports.push_back({"", unassigned, true, 0, 0, 0});
  }
  return reports;
}

bool Lockstep::isAnybodyUnassigned() const {
  return std::any_of(offered_.begin(), offered_.end(), [](const Offered& offered) { return !offered.is_commanded; });
}

std::vector<std::string> Lockstep::unassignedRobots() const {
  std::vector<std::string> names;
  for (const Offered& offered : offered_) {
    if (!offered.is_commanded) {
      names.push_back(offered.robot.name);
    }
  }
  return names;
}

void Lockstep::wake() {
  const std::lock_guard<std::mutex> lock(mutex_);
  changed_.notify_all();
}

void Lockstep::cancel() {
  const std::lock_guard<std::mutex> lock(mutex_);
  is_cancelled_ = true;
  changed_.notify_all();
}

}  // namespace swarmanoid
