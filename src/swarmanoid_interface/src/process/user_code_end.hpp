/// How a process ends in the middle of users' code: whoever notices it says what has happened, in a way that is allowed
/// in a handler of signals, and leaves the rest to the watch's thread.
#pragma once

#include <atomic>

#include "swarmanoid_interface/process/exit_code.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid::user_code_end {

/// Of a process that ends because this call has failed.
constexpr ExitCode exitCodeOf(const UserCode& code) {
  return code.is_controllers ? ExitCode::kControllerFailed : ExitCode::kStopped;
}

/// What the watch's thread is to do. Written by one thread, once; what `code` points to stays.
struct Order {
  const char* deed = nullptr;  ///< "crashed: SIGSEGV", "called exit", ...
  UserCode code;
};

/// From now on crashes and exits are noticed; `wake` is called, in a handler of signals, when there is an order.
void install(void (*wake)());
void uninstall();
/// This thread is the one that carries out the order.
void beWatch();

/// Null while there is none.
const Order* order();

/// The process ends with this code in some seconds, whatever its threads do.
void endSoon(ExitCode exit_code);

}  // namespace swarmanoid::user_code_end
