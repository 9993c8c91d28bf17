/// The boundary between the suite and users' code. Whose code is called is noted for as long as the call lasts, and
/// whatever it throws is caught: every call of a controller, the loading of every library, and the calls of a tick that
/// engines, devices and visualisations get, the suite's own included, go through here.
///
/// The notes are for whoever has to name the robot, or the plugin, when a call does not return: handlers of crashes,
/// and the watch that reports calls that take too long (user_code_watch.hpp).
///
/// Threads  all functions from any thread; each thread has its own notes.
/// Cost     a note is some stores into memory that is the thread's own, and a look at whether the process is being
///          ended: no allocation, lock or system call, but for the first one of a thread.
#pragma once

#include <cstdint>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

namespace swarmanoid {

/// A call of users' code. What it refers to outlives the call.
struct UserCode {
  static constexpr std::uint64_t kNoTick = ~std::uint64_t{0};

  const char* phase = nullptr;  ///< "step", "init", "loading", "move", ...; a literal
  std::string_view part;        ///< "controller 'drive' of libdiffusion.so", "engine 'ground' (dynamics2d)"
  std::string_view robot;       ///< its name; "" if the call is for no robot
  std::uint64_t tick = kNoTick;
  bool is_controllers = true;  ///< or a library's; else an engine's, a device's, an observer's (callPlugin)
};

/// "step of robot 'fb_3' (controller 'drive' of libdiffusion.so), tick 17", "move of engine 'ground' (dynamics2d), tick
/// 17", "loading of library 'diffusion'"
std::string describe(const UserCode& code);

/// While it lives, its thread is in users' code. They may be nested; the innermost counts.
class UserCall {
 public:
  /// @param code outlives it
  explicit UserCall(const UserCode& code) noexcept;
  explicit UserCall(UserCode&& code) = delete;
  ~UserCall();
  UserCall(const UserCall&) = delete;
  UserCall& operator=(const UserCall&) = delete;

 private:
  const UserCode* outer_;
};

/// What was thrown, for people, whether it is a std::exception or not; never empty, and of a bounded length. Only
/// inside a `catch (...)`. Does not return if the thread is being ended (pthread_exit): that ends the process, as a
/// crash does.
std::string describeException();

/// Calls users' code whose call is noted already. @return whether it threw nothing
/// @param failure what it threw; written only then
template <class Action>
bool succeeds(Action action, std::string& failure) {
  try {
    try {
      action();
      return true;
    } catch (...) {
      failure = describeException();
    }
  } catch (...) {
    failure = describeException();  // what was thrown throws when it goes
  }
  return false;
}

/// Calls users' code. @return "", or what it threw
template <class Action>
std::string failureOf(const UserCode& code, Action action) {
  const UserCall call(code);
  std::string failure;
  succeeds(action, failure);
  return failure;
}

/// Calls users' code. @return what it returns
/// @throws std::exceptions that it throws, as they are; std::runtime_error that says what else it threw
template <class Action>
auto callUserCode(const UserCode& code, Action action) {
  const UserCall call(code);
  try {
    return action();
  } catch (const std::exception&) {
    throw;
  } catch (...) {
    throw std::runtime_error(describeException());
  }
}

/// Calls a plugin that is no controller: an engine, a device, an observer. std::exceptions pass, for they say who
/// throws them. @param phase, part, tick as UserCode has them
/// @throws std::runtime_error "engine 'ground' (dynamics2d) threw the number 7, ..." for whatever else is thrown
template <class Action>
auto callPlugin(const char* phase, std::string_view part, std::uint64_t tick, Action action) {
  const UserCode code{phase, part, "", tick, false};
  const UserCall call(code);
  try {
    return action();
  } catch (const std::exception&) {
    throw;
  } catch (...) {
    throw std::runtime_error(std::string(part) + " " + describeException());
  }
}

/// File name, without folders, of the library that something of static storage duration is in, such as a function or a
/// type's description; "" if that is not known.
std::string libraryOf(const void* address);

}  // namespace swarmanoid
