/// How a process ends in the middle of users' code: whoever notices it says what has happened, in a way that is allowed
/// in a handler of signals, and leaves the rest to the watch's thread.
#pragma once

#include <atomic>

#include "swarmanoid_interface/user_code.hpp"

namespace swarmanoid::user_code_end {

constexpr int kControllerFailed = 3;  ///< exit codes, as those of the program
constexpr int kStopped = 4;
constexpr int kInterrupted = 130;

/// Of a process that ends because this call has failed.
constexpr int exitCodeOf(const UserCode& code) { return code.is_controllers ? kControllerFailed : kStopped; }

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
void endSoon(int exit_code);

}  // namespace swarmanoid::user_code_end
