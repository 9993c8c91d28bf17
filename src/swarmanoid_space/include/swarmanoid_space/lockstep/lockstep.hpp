/// Lockstep with participants: processes that run controllers for a space. Each tick every participant gets one sensor
/// frame and gives one command frame; the tick waits for it. No ROS here: whoever carries the frames passes a function
/// that sends them, and calls `answer` with what comes back.
///
/// Results do not depend on when an answer comes, or in which order: with equal answers a run has the bits of one whose
/// controllers are in process.
///
/// Time     time-outs are wall time; nothing here needs simulated time to advance.
/// Threads  join, answer, wake, cancel, reports: any thread. The rest: the space's. A Send is called on the space's
///          thread, without locks, and may answer at once.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_interface/frames.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

struct RobotInstance;

/// What becomes of a tick when a participant is late.
enum class LatePolicy {
  kWait,  ///< it waits on, as long as it takes
  kSkip,  ///< it goes on: the robots keep their last commands, and no tick waits for the participant until it answers
  kStop   ///< the run stops
};

/// "wait", "skip", "stop".
const char* toString(LatePolicy policy);
/// @return nothing if it is none
std::optional<LatePolicy> parseLatePolicy(const std::string& text);

class Lockstep {
 public:
  using Seconds = std::chrono::duration<double>;
  using Send = std::function<void(const SensorFrame&)>;
  using Disturbed = std::function<bool()>;

  struct Options {
    LatePolicy policy = LatePolicy::kWait;
    Seconds timeout{1.0};        ///< for the answer of a participant
    Seconds join_timeout{20.0};  ///< for a robot without a participant, and for a participant's first answer
  };

  struct Request {
    std::string participant;           ///< its name; a participant that joins again under it replaces its former self
    std::vector<std::string> robots;   ///< that it commands, at least one
    std::optional<LatePolicy> policy;  ///< instead of the space's
    std::optional<Seconds> timeout;    ///< likewise
  };

  /// The state of a participant, for diagnostics. One without a name stands for robots without a participant.
  struct Report {
    std::string participant;
    std::vector<std::string> robots;
    bool is_late = false;
    std::uint64_t answers = 0;
    std::uint64_t times_late = 0;
    std::uint64_t refused = 0;  ///< answers for a wrong tick, doubled, or of a former self
  };

  // For the carrier.

  /// From the next frame on the participant commands these robots. Another participant that is late with one of them
  /// is dropped.
  /// @throws std::runtime_error for a robot that is not commanded from elsewhere, or by another participant that is not
  /// late; then nothing has changed
  Registration join(const Request& request, Send send);
  /// The answer to a frame. One that no tick waits for is refused, and reported once for each participant.
  /// @return why it is refused; "" if it is not
  std::string answer(CommandFrame frame);
  std::vector<Report> reports() const;

  // For the simulation.

  void setOptions(const Options& options);
  /// Between ticks, whenever robots, their devices or their commanders have changed.
  /// @param robots with their indices in the RobotInstances of the simulation
  void offer(const std::vector<std::pair<RemoteRobot, std::size_t>>& robots, const Space& space);
  /// Sends the readings to all participants, waits for their answers, and makes these the commands of the robots.
  ///
  /// An intervention that is requested meanwhile need not wait for a participant that is late or never registers: the
  /// tick is given up, and made again after the intervention. Each participant gets one sensor frame a tick; the
  /// command frame that answers a frame from before the tick was given up is valid, although it is based on the
  /// readings of that time.
  ///
  /// @param events gets what is reported of participants
  /// @param is_disturbed asked before each wait, see `wake`; may be empty
  /// @return false: it was disturbed, nothing has changed, call it again for the same tick
  /// @throws std::runtime_error naming the participant that is late, by LatePolicy::kStop, or if it is cancelled
  bool exchange(Space& space, std::vector<RobotInstance>& instances, std::vector<Event>& events,
                const Robot::LogSink& log, const Disturbed& is_disturbed);
  /// A waiting `exchange` asks again whether it is disturbed. From any thread.
  void wake();
  /// `exchange` waits no more, now and later.
  void cancel();

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kNoInstance = ~std::size_t{0};

  struct Offered {
    RemoteRobot robot;
    std::size_t instance = 0;
    bool is_commanded = false;
  };
  struct Participant {
    std::string name;
    std::vector<RemoteRobot> robots;
    std::vector<std::size_t> instances;  // of the robots; kNoInstance: not to be commanded now
    Send send;
    LatePolicy policy = LatePolicy::kWait;
    Seconds timeout{1.0};
    SensorFrame frame;             // the last one, filled on the space's thread
    std::vector<bool> is_present;  // of the robots, in that frame
    CommandFrame answer;
    Clock::time_point sent;
    bool is_asked = false;     // this tick
    bool is_answered = false;  // this tick
    bool is_late = false;      // and that was reported
    bool is_new = true;        // since it joined no frame was made for it
    bool needs_frame = true;   // this tick's
    bool has_applied = false;  // since it joined its robots have had commands of it
    std::uint64_t answers = 0;
    std::uint64_t times_late = 0;
    std::uint64_t refused = 0;
  };
  struct Notice {
    Event::Kind kind;
    std::string participant;
    std::string text;
  };
  using Lock = std::unique_lock<std::mutex>;

  void resolve(Participant& participant);
  void markCommanded();
  /// Drops its former self, and a late participant that has a robot of it. @return whether there was a former self
  bool replace(Participant& joined);
  void ask(Participant& participant, const Space& space, const std::vector<RobotInstance>& instances);
  /// @return those to whom a frame is to be sent
  std::vector<std::shared_ptr<Participant>> askAll(const Space& space, const std::vector<RobotInstance>& instances);
  /// No tick waits for a participant that was asked for robots which it commands no more.
  void forgetWhoHasGone(const std::vector<RobotInstance>& instances);
  void startWaiting(const Space& space);
  void finishWaiting(const Space& space);
  bool isDone() const;
  /// For its next answer: connections take their time before the first.
  Seconds timeoutOf(const Participant& participant) const;
  bool isAnybodyUnassigned() const;
  std::vector<std::string> unassignedRobots() const;
  Clock::time_point nextDeadline() const;
  void checkDeadlines(const Space& space);
  static void report(const Notice& notice, std::vector<Event>& events, const Robot::LogSink& log);
  void reportAll(Lock& lock, std::vector<Event>& events, const Robot::LogSink& log);
  static bool isCommandable(std::size_t instance, const std::vector<RobotInstance>& instances);
  static void apply(const Participant& participant, Space& space, std::vector<RobotInstance>& instances);

  mutable std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  Options options_;
  std::vector<Offered> offered_;
  std::vector<std::shared_ptr<Participant>> participants_;  // by name
  std::vector<Notice> notices_;                             // to be reported on the space's thread
  std::string stop_reason_;
  std::uint64_t last_session_ = 0;
  std::uint64_t run_ = 0;
  std::uint64_t tick_ = 0;
  std::uint64_t seed_ = 1;
  Duration clocktick_{};
  Clock::time_point started_;  // this tick's waiting, without the time since it was given up
  std::optional<Clock::time_point> given_up_;
  bool unassigned_reported_ = false;  // robots without a participant
  bool is_cancelled_ = false;
};

}  // namespace swarmanoid
