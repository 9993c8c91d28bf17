/// The notes of user_code.hpp, for those who read them from outside: handlers of signals and the watch.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "swarmanoid_interface/process/user_code.hpp"

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

/// Of this thread; null if it has never called users' code. A handler of signals may read it: it lies at a fixed
/// offset, so no thread-local storage is made meanwhile. No thread_local, which other sources reach through a function
/// only.
extern __thread UserCallNote* own_user_call_note __attribute__((tls_model("initial-exec"), visibility("hidden")));
/// Makes the note of this thread, if one is left.
void takeUserCallNote();

/// See holdUserCalls.
extern std::atomic<bool> are_user_calls_held __attribute__((visibility("hidden")));
void standStillUnlessHolder();

/// Notes the call that the thread is in from here on; null: none. In line, for it is done twice a robot and tick.
[[gnu::always_inline]] inline void noteUserCall(UserCallNote& note, const UserCode* call) {
  constexpr auto kRelaxed = std::memory_order_relaxed;
  std::atomic_signal_fence(std::memory_order_seq_cst);
  note.call.store(call, kRelaxed);
  note.changes.store(note.changes.load(kRelaxed) + 1, std::memory_order_release);
  std::atomic_signal_fence(std::memory_order_seq_cst);  // holdUserCalls makes a whole one of it
  if (__builtin_expect(are_user_calls_held.load(kRelaxed), false)) {
    standStillUnlessHolder();
  }
}

/// @return the call that this one is in, for leaveUserCode; null: none
[[gnu::always_inline]] inline const UserCode* enterUserCode(const UserCode& code) {
  if (own_user_call_note == nullptr) {
    takeUserCallNote();
  }
  if (own_user_call_note == nullptr) {
    return nullptr;
  }
  const UserCode* outer = own_user_call_note->call.load(std::memory_order_relaxed);
  noteUserCall(*own_user_call_note, &code);
  return outer;
}
[[gnu::always_inline]] inline void leaveUserCode(const UserCode* outer) {
  if (own_user_call_note != nullptr) {
    noteUserCall(*own_user_call_note, outer);
  }
}

/// As UserCall, but in line. For the steps of controllers.
class NotedCall {
 public:
  explicit NotedCall(const UserCode& code) noexcept : outer_(enterUserCode(code)) {}
  ~NotedCall() { leaveUserCode(outer_); }
  NotedCall(const NotedCall&) = delete;
  NotedCall& operator=(const NotedCall&) = delete;

 private:
  const UserCode* outer_;
};

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
