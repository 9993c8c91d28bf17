/// Ends a process in the middle of users' code: the thread that detects the failure reports it with async-signal-safe
/// functions, and leaves the rest to the watch's thread.
#pragma once

#include <atomic>

#include "swarmanoid_interface/process/exit_code.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid::user_code_end {

/// Returns the exit code of a process that ends because this call has failed.
constexpr ExitCode exitCodeOf(const UserCode& code) {
  return code.is_controllers ? ExitCode::kControllerFailed : ExitCode::kStopped;
}

/// The task of the watch's thread. One thread writes it, once; the object that `code` points to stays valid.
struct Order {
  const char* ending = nullptr;  ///< "crashed: SIGSEGV", "called exit", ...
  UserCode code;
};

/// Detects crashes and exits from now on; `wake` is called, in a handler of signals, when there is an order.
void install(void (*wake)());
void uninstall();
/// Makes this thread the one that carries out the order.
void beWatch();

/// Returns the order; null while there is none.
const Order* order();

/// Ends the process with this code in some seconds, independent of its threads.
void endSoon(ExitCode exit_code);

}  // namespace swarmanoid::user_code_end
