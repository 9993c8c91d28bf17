/// Watches over the calls of users' code in this process (user_code.hpp), and ends the process when one of them does
/// not return as it should:
///
///     a crash (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, a stack overflow), exit() and quick_exit(),
///     a call that takes longer than the watchdog allows        exit code 3; of an engine, a device, an observer 4
///     a call under way at the second request to end            exit code 130
///
/// A message on standard error names the robot, the controller, its library, the phase and the tick, or the plugin that
/// is no controller; then `close` has some seconds to save the results. A crash outside users' code is reported as one
/// of the simulator, and ends the process by its signal, as without a watch. A late call is reported while it lasts.
///
/// `close` runs on the watch's thread. The thread of the call that failed is blocked until the process ends, and so are
/// the threads that wait for it: their data remain as at the time of the call. If a late call returns after all, its
/// thread is blocked at the return; if the call has returned before the threads are held, the process continues, or
/// ends by itself if its end has been requested. All other threads are blocked where they next enter or leave users'
/// code. So another simulation in the process, to which the failing call does not belong, may still be in the middle of
/// a tick while its `close` runs, until it reaches the next call: its files are completed, but they may contain only a
/// part of its last tick.
///
/// Time     wall time, independent of changes of the system date; time in which the process is stopped does not count
#pragma once

#include <functional>
#include <string>

#include "swarmanoid_interface/process/exit_code.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid {

/// The reason why the process ends.
struct UserCodeEnd {
  std::string robot;   ///< "" if the call was for no robot
  std::string part;    ///< as in UserCode: `close` must not call the plugin or controller of this name
  std::string reason;  ///< "crashed: SIGSEGV in step of robot ..."
  ExitCode exit_code = ExitCode::kControllerFailed;
};

class UserCodeWatch {
 public:
  struct Options {
    std::function<void(const std::string&)> report;  ///< of a late call, on the watch's thread; empty: standard error
    double watchdog = 0.0;                           ///< limit of wall time for one call [s]; 0: none
  };

  /// Installs handlers for the signals of crashes. If several watches exist in a process, the options of the first
  /// hold.
  explicit UserCodeWatch(Options options);
  /// The destructor of the last watch restores the former handlers.
  ~UserCodeWatch();
  UserCodeWatch(const UserCodeWatch&) = delete;
  UserCodeWatch& operator=(const UserCodeWatch&) = delete;

  /// Registers, for its lifetime, an action that is run before the process ends.
  class Closing {
   public:
    Closing(UserCodeWatch& watch, std::function<void(const UserCodeEnd&)> close);
    /// Blocks if the action is running, since the process ends afterwards.
    ~Closing();
    Closing(const Closing&) = delete;
    Closing& operator=(const Closing&) = delete;

   private:
    std::uint64_t number_;
  };

  /// Requests the end once more. If a controller's call is under way the process ends with 130 after `close`; otherwise
  /// it has some seconds to end by itself, since other plugins may be completing files. A further request ends it at
  /// once. A handler of signals may call this function.
  static void askToEndNow();
};

/// Returns "step of robot 'fb_3' (...), tick 17 since 12 s" for the call that is under way for longest; "" if none
/// takes longer than 5 s, or if there is no watch.
std::string lateUserCall();

}  // namespace swarmanoid
