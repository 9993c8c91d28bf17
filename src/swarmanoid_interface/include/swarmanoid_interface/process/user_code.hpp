/// The boundary between the suite and users' code. While a call lasts, a note names the owner of the called code, and
/// every exception is caught: every call of a controller, the loading of every library, and the calls of a tick to
/// engines, devices and observers, the suite's own included, go through here.
///
/// The notes name the robot or the plugin when a call does not return. Crash handlers read them, and so does the watch
/// that reports calls that take too long (user_code_watch.hpp).
///
/// Threads  all functions may be called from any thread; each thread has its own notes.
/// Cost     a note takes some stores to thread-local memory and a check whether the process is being ended: no
///          allocation, lock or system call, except for the first note of a thread.
#pragma once

#include <cstdint>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

namespace swarmanoid {

/// A call of users' code. The texts that it refers to outlive the call.
struct UserCode {
  static constexpr std::uint64_t kNoTick = ~std::uint64_t{0};

  const char* phase = nullptr;  ///< "step", "init", "loading", "move", ...; a literal
  std::string_view part;        ///< "controller 'drive' of libdiffusion.so", "engine 'ground' (dynamics2d)"
  std::string_view robot;       ///< the robot's name; "" if the call is for no robot
  std::uint64_t tick = kNoTick;
  bool is_controllers = true;  ///< code of a controller or a library; else of an engine, a device or an observer
};

/// Returns "step of robot 'fb_3' (controller 'drive' of libdiffusion.so), tick 17", "move of engine 'ground'
/// (dynamics2d), tick 17", "loading of library 'diffusion'"
std::string describe(const UserCode& code);

/// Marks its thread as being in users' code during its lifetime. Calls may be nested; the innermost counts.
class UserCall {
 public:
  /// @param code outlives this object
  explicit UserCall(const UserCode& code) noexcept;
  explicit UserCall(UserCode&& code) = delete;
  ~UserCall();
  UserCall(const UserCall&) = delete;
  UserCall& operator=(const UserCall&) = delete;

 private:
  const UserCode* outer_;
};

/// Describes the current exception for people, whether it is a std::exception or not; the text is never empty, and of a
/// bounded length. It may be called only inside a `catch (...)`. It does not return if the thread is being ended
/// (pthread_exit): that ends the process, as a crash does.
std::string describeException();

/// Calls users' code whose call has a note already. @return true if it threw nothing
/// @param failure description of the exception; written only if there was one
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
    failure = describeException();  // the destructor of the thrown object throws
  }
  return false;
}

/// Calls users' code. @return "", or the description of the exception
template <class Action>
std::string failureOf(const UserCode& code, Action action) {
  const UserCall call(code);
  std::string failure;
  succeeds(action, failure);
  return failure;
}

/// Calls users' code. @return its result
/// @throws std::exceptions of users' code, unchanged; std::runtime_error with a description for anything else that is
/// thrown
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

/// Calls a plugin that is no controller: an engine, a device, an observer. std::exceptions pass unchanged, since their
/// messages name the plugin. @param phase, part, tick as UserCode has them
/// @throws std::runtime_error "engine 'ground' (dynamics2d) threw the number 7, ..." for anything else that is thrown
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

/// Returns the file name, without folders, of the library that contains an object of static storage duration, such as a
/// function or a type's description; "" if that is not known.
std::string libraryOf(const void* address);

}  // namespace swarmanoid
