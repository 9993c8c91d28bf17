/// The notes of user_code.hpp, for their readers in other threads: handlers of signals and the watch.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid {

/// The current call of one thread. Only that thread writes it. The note stays at its address for as long as the process
/// lives; the texts that it points to are valid during the call.
struct alignas(64) UserCallNote {
  std::atomic<bool> is_taken{false};           ///< a thread owns this note
  std::atomic<std::uint64_t> changes{0};       ///< counts calls and returns
  std::atomic<const UserCode*> call{nullptr};  ///< the innermost call; null: none
};

/// More threads than this are not watched.
constexpr std::size_t kMostUserCallNotes = 2048;
using UserCallNotes = std::array<UserCallNote, kMostUserCallNotes>;
UserCallNotes& userCallNotes();

/// The note of this thread; null if the thread has never called users' code. A handler of signals may read it: it lies
/// at a fixed offset, so reading it allocates no thread-local storage. It is __thread because other sources access a
/// thread_local variable through a function only.
extern __thread UserCallNote* own_user_call_note __attribute__((tls_model("initial-exec"), visibility("hidden")));
/// Makes the note of this thread, if one is left.
void takeUserCallNote();

/// True while threads are held, see holdUserCalls.
extern std::atomic<bool> are_user_calls_held __attribute__((visibility("hidden")));
void standStillUnlessHolder();

/// Sets the current call of the thread; null: none. It is inline because it runs twice per robot and tick.
[[gnu::always_inline]] inline void noteUserCall(UserCallNote& note, const UserCode* call) {
  constexpr auto kRelaxed = std::memory_order_relaxed;
  std::atomic_signal_fence(std::memory_order_seq_cst);
  note.call.store(call, kRelaxed);
  note.changes.store(note.changes.load(kRelaxed) + 1, std::memory_order_release);
  std::atomic_signal_fence(std::memory_order_seq_cst);  // holdUserCalls turns this into a full fence
  if (__builtin_expect(are_user_calls_held.load(kRelaxed), false)) {
    standStillUnlessHolder();
  }
}

/// @return the call that encloses this one, for leaveUserCode; null: none
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

/// Does the same as UserCall, but inline, for the steps of controllers.
class NotedCall {
 public:
  explicit NotedCall(const UserCode& code) noexcept : outer_(enterUserCode(code)) {}
  ~NotedCall() { leaveUserCode(outer_); }
  NotedCall(const NotedCall&) = delete;
  NotedCall& operator=(const NotedCall&) = delete;

 private:
  const UserCode* outer_;
};

/// Returns the current call of this thread. A handler of signals may call it.
UserCode ownUserCode();

/// After this returns every other thread is blocked where it enters or leaves users' code, until the process ends or
/// they are released. A call that is under way continues, but does not return. A note that is read unchanged after this
/// stays valid for as long as the threads are held.
void holdUserCalls();
/// Releases the threads. Only the thread that held them may call it.
void releaseUserCalls();

/// Called when a thread or the process would end in the middle of users' code: "called exit". It does not return. Null:
/// there is no watch.
using UserCodeEnder = void (*)(const char* ending);
void setUserCodeEnder(UserCodeEnder ender);

}  // namespace swarmanoid
