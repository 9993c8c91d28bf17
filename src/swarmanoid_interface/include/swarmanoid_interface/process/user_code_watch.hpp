/// Watches over the calls of users' code in this process (user_code.hpp), and ends the process when one of them does
/// not return as it should:
///
///     a crash (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, a stack overflow), exit() and quick_exit(),
///     a call that takes longer than the watchdog allows        exit code 3; of an engine, a device, an observer 4
///     a call under way when the end is asked for a second time  exit code 130
///
/// The robot, the controller, its library, the phase and the tick are named on standard error, or the plugin that is no
/// controller; then `close` has some seconds to keep what can be kept. A crash that is not in users' code is said to be
/// in the simulator, and ends the process by its signal, as if nobody watched. A call that is late is reported, while
/// it goes on.
///
/// `close` runs on the watch's thread. The thread of the call that failed stands still until the process ends, and so
/// does whoever waits for it: what they left is as at the time of the call. If a late call returns after all, it stands
/// still where it returns; if it has returned before that is made sure of, the process goes on, or ends by itself if it
/// has been asked to. All other threads stand still where they next enter or leave users' code. So a simulation that
/// the failing call is no part of, another one in the process, may still be in the middle of a tick while its `close`
/// runs, for as long as it takes to reach the next call: its files are completed, but of its last tick they may have a
/// part.
///
/// Time     wall time, whatever is done to the calendar; time in which the process is stopped does not count
#pragma once

#include <functional>
#include <string>

#include "swarmanoid_interface/process/exit_code.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid {

/// Why the process ends.
struct UserCodeEnd {
  std::string robot;   ///< "" if the call was for none
  std::string part;    ///< as UserCode has it: whoever is called so is not to be called by `close`
  std::string reason;  ///< "crashed: SIGSEGV in step of robot ..."
  ExitCode exit_code = ExitCode::kControllerFailed;
};

class UserCodeWatch {
 public:
  struct Options {
    std::function<void(const std::string&)> report;  ///< of a late call, on the watch's thread; nothing: standard error
    double watchdog = 0.0;                           ///< [s] of wall time for one call; 0: any time
  };

  /// Takes over the signals of crashes. While there are several in a process the options of the first hold.
  explicit UserCodeWatch(Options options);
  /// The last one gives them back.
  ~UserCodeWatch();
  UserCodeWatch(const UserCodeWatch&) = delete;
  UserCodeWatch& operator=(const UserCodeWatch&) = delete;

  /// While it lives, this is done before the process ends.
  class Closing {
   public:
    Closing(UserCodeWatch& watch, std::function<void(const UserCodeEnd&)> close);
    /// Waits for ever if it is being done: the process ends meanwhile.
    ~Closing();
    Closing(const Closing&) = delete;
    Closing& operator=(const Closing&) = delete;

   private:
    std::uint64_t number_;
  };

  /// The end is asked for once more. If a controller's call is under way the process ends with 130 after `close`; else
  /// it has some seconds to end by itself, for other plugins may be completing files. Asked for again, it ends at once.
  /// Can be called by a handler of signals.
  static void askToEndNow();
};

/// "step of robot 'fb_3' (...), tick 17 since 12 s", of the call that is under way for longest; "" if none takes longer
/// than 5 s, or if nobody watches.
std::string lateUserCall();

}  // namespace swarmanoid
