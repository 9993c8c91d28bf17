/// Lockstep with participants: processes that run controllers for a space. In each tick every participant gets one
/// sensor frame and returns one command frame; the tick waits for it. No ROS here: the carrier of the frames passes a
/// function that sends them, and calls `answer` with the replies.
///
/// Results do not depend on the time or order of answers: with equal answers a run is bit for bit that of controllers
/// in the simulator's process.
///
/// Time     time-outs are wall time; nothing here needs simulated time to advance.
/// Threads  join, answer, wake, cancel, reports: any thread. All other functions: the space's thread. A Send is called
///          on the space's thread, without locks, and may answer at once.
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
#include "swarmanoid_space/access.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

struct RobotInstance;

/// Behaviour of a tick when a participant is late.
enum class LatePolicy {
  kWait,  ///< the tick waits without limit
  /// The tick continues: robots keep their last commands, and no tick waits for the participant until it answers.
  kSkip,
  kStop  ///< the run stops
};

/// "wait", "skip", "stop".
const char* toString(LatePolicy policy);
/// @return nothing if the text is none of these
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
    std::string participant;           ///< its name; a new registration under the same name replaces the old one
    std::vector<std::string> robots;   ///< robots that it commands, at least one
    std::optional<LatePolicy> policy;  ///< replaces Options::policy
    std::optional<Seconds> timeout;    ///< replaces Options::timeout
  };

  /// The state of a participant, for diagnostics. An entry without a name stands for robots without a participant.
  struct Report {
    std::string participant;
    std::vector<std::string> robots;
    bool is_late = false;
    std::uint64_t answers = 0;
    std::uint64_t times_late = 0;
    std::uint64_t refused = 0;  ///< answers for a wrong tick, duplicates, answers of an earlier registration
  };

  // Functions for the carrier.

  /// Registers a participant; it commands these robots from the next frame on. Drops another participant that commands
  /// one of them and is late.
  /// @throws std::runtime_error for a robot that is not commanded from another process, or whose participant is not
  /// late; then nothing has changed
  Registration join(const Request& request, Send send);
  /// Receives the answer to a frame. An answer that no tick waits for is refused; the first refusal of each participant
  /// is reported.
  /// @return the reason of the refusal; "" if it is accepted
  std::string answer(CommandFrame frame);
  std::vector<Report> reports() const;

  // Functions for the simulation.

  void setOptions(const Options& options);
  /// Sets the robots that participants may command. Called between ticks, after robots, their devices or their command
  /// sources have changed.
  /// @param robots with their indices in the RobotInstances of the simulation
  void offer(const std::vector<std::pair<RemoteRobot, std::size_t>>& robots, const Space& space);
  /// Sends the readings to all participants, waits for their answers, and applies them as commands of the robots.
  ///
  /// An intervention that is requested meanwhile need not wait for a participant that is late or never registers: the
  /// tick is given up, and made again after the intervention. Each participant gets one sensor frame a tick. Its answer
  /// to a frame from before the interruption stays valid, although it is based on the readings of that time.
  ///
  /// @param events receives the reports about participants
  /// @param is_disturbed called before each wait, see `wake`; may be empty
  /// @return false: it was disturbed and nothing has changed; call it again for the same tick
  /// @throws std::runtime_error naming the participant that is late, by LatePolicy::kStop, or if it is cancelled
  bool exchange(const Space& space, const ControlAccess& access, std::vector<RobotInstance>& instances,
                std::vector<Event>& events, const Robot::LogSink& log, const Disturbed& is_disturbed);
  /// Makes a waiting `exchange` call `is_disturbed` again. From any thread.
  void wake();
  /// Ends the wait of `exchange`, now and in later calls.
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
    std::vector<std::size_t> instances;  // of the robots; kNoInstance: not commanded now
    Send send;
    LatePolicy policy = LatePolicy::kWait;
    Seconds timeout{1.0};
    SensorFrame frame;             // the last frame, filled on the space's thread
    std::vector<bool> is_present;  // of the robots, in `frame`
    CommandFrame answer;
    Clock::time_point sent;
    bool is_asked = false;     // in this tick
    bool is_answered = false;  // in this tick
    bool is_late = false;      // already reported as late
    bool is_new = true;        // no frame was made for it since it joined
    bool needs_frame = true;   // for this tick
    bool has_applied = false;  // its commands were applied since it joined
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
  /// Drops its previous registration, and late participants that command one of its robots. @return whether there was a
  /// previous registration
  bool replace(Participant& joined);
  void ask(Participant& participant, const Space& space, const std::vector<RobotInstance>& instances);
  /// @return participants to which a frame must be sent
  std::vector<std::shared_ptr<Participant>> askAll(const Space& space, const std::vector<RobotInstance>& instances);
  /// Stops the wait for participants that no longer command any of the robots in their frame.
  void forgetWhoHasGone(const std::vector<RobotInstance>& instances);
  void startWaiting(const Space& space);
  void finishWaiting(const Space& space);
  bool isDone() const;
  /// Time-out of its next answer: before the first one, connections need more time.
  Seconds timeoutOf(const Participant& participant) const;
  bool isAnybodyUnassigned() const;
  std::vector<std::string> unassignedRobots() const;
  Clock::time_point nextDeadline() const;
  void checkDeadlines(const Space& space);
  static void report(const Notice& notice, std::vector<Event>& events, const Robot::LogSink& log);
  void reportAll(Lock& lock, std::vector<Event>& events, const Robot::LogSink& log);
  static bool isCommandable(std::size_t instance, const std::vector<RobotInstance>& instances);
  static void apply(const Participant& participant, const ControlAccess& access, std::vector<RobotInstance>& instances);

  mutable std::mutex mutex_;  // guards all following members
  std::condition_variable changed_;
  Options options_;
  std::vector<Offered> offered_;
  std::vector<std::shared_ptr<Participant>> participants_;  // by name
  std::vector<Notice> notices_;                             // reported later on the space's thread
  std::string stop_reason_;
  std::uint64_t last_session_ = 0;
  std::uint64_t run_ = 0;
  std::uint64_t tick_ = 0;
  std::uint64_t seed_ = 1;
  Duration clocktick_{};
  Clock::time_point started_;  // start of this tick's wait, shifted by the time for which it was given up
  std::optional<Clock::time_point> given_up_;
  bool unassigned_reported_ = false;  // robots without a participant
  bool is_cancelled_ = false;
};

}  // namespace swarmanoid
