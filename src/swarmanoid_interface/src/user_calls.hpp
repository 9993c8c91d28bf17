/// The notes of user_code.hpp, for those who read them from outside: handlers of signals and the watch.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "swarmanoid_interface/user_code.hpp"

namespace swarmanoid {

/// The call that one thread is in. Only that thread writes it. It lies where it is for as long as the process lives;
/// what it points to goes with the call.
struct alignas(64) UserCallNote {
  std::atomic<bool> is_taken{false};           ///< by a thread
  std::atomic<std::uint64_t> changes{0};       ///< counts calls and returns
  std::atomic<const UserCode*> call{nullptr};  ///< the innermost one; null: none
};

/// More threads than this are not watched.
constexpr std::size_t kMostUserCallNotes = 2048;
using UserCallNotes = std::array<UserCallNote, kMostUserCallNotes>;
UserCallNotes& userCallNotes();

/// Of this thread; null if it has never called users' code. Can be called by a handler of signals.
const UserCallNote* ownUserCallNote();

/// Of this thread, as it stands. Can be called by a handler of signals.
UserCode ownUserCode();

/// From when this returns every thread but this one stands still where it enters or leaves users' code, until the
/// process ends or they are released. A call that is under way goes on, and does not return. Whoever reads from a note
/// after this that its call has not changed is right for as long as they are held.
void holdUserCalls();
/// By the thread that held them.
void releaseUserCalls();

/// Called instead of ending a thread or the process in the middle of users' code: "called exit". Does not return. Null:
/// nobody watches.
using UserCodeEnder = void (*)(const char* deed);
void setUserCodeEnder(UserCodeEnder ender);

}  // namespace swarmanoid
