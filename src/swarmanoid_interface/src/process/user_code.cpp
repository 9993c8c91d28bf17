#include "swarmanoid_interface/process/user_code.hpp"

#include <cxxabi.h>
#include <dlfcn.h>
#include <linux/membarrier.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <typeinfo>

#include "user_calls.hpp"

namespace swarmanoid {
namespace {

UserCallNotes notes;
std::atomic<UserCodeEnder> ender{nullptr};

/// A stack for handlers of signals, since the thread's own is not usable after an overflow.
class HandlerStack {
 public:
  HandlerStack() {
    stack_t current{};
    if (sigaltstack(nullptr, &current) != 0 || (current.ss_flags & SS_DISABLE) == 0) {
      return;  // the thread has one already
    }
    void* memory = mmap(nullptr, kSize, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory != MAP_FAILED) {
      stack_t stack{};
      stack.ss_sp = memory;
      stack.ss_size = kSize;
      memory_ = sigaltstack(&stack, nullptr) == 0 ? memory : nullptr;
    }
  }
  ~HandlerStack() {
    if (memory_ == nullptr) {
      return;
    }
    stack_t current{};
    if (sigaltstack(nullptr, &current) == 0 && current.ss_sp == memory_) {  // the thread may have got another one since
      stack_t none{};
      none.ss_flags = SS_DISABLE;
      sigaltstack(&none, nullptr);
    }
    munmap(memory_, kSize);
  }
  HandlerStack(const HandlerStack&) = delete;
  HandlerStack& operator=(const HandlerStack&) = delete;

 private:
  static constexpr std::size_t kSize = 64 * 1024;
  void* memory_ = nullptr;
};

/// Holds a thread's note, from its first call to the thread's end.
class OwnNote {
 public:
  OwnNote() {
    for (UserCallNote& note : notes) {
      bool is_taken = false;
      if (note.is_taken.compare_exchange_strong(is_taken, true)) {
        own_user_call_note = &note;
        return;
      }
    }
  }
  ~OwnNote() {
    if (own_user_call_note == nullptr) {
      return;
    }
    // exit() destroys thread-local objects first; a thread that ends otherwise has left its calls
    const UserCodeEnder end = ender;
    if (own_user_call_note->call.load(std::memory_order_relaxed) != nullptr && end != nullptr) {
      end("called exit");
    }
    own_user_call_note->call = nullptr;
    own_user_call_note->is_taken = false;
    own_user_call_note = nullptr;
  }
  OwnNote(const OwnNote&) = delete;
  OwnNote& operator=(const OwnNote&) = delete;

 private:
  HandlerStack stack_;
};

thread_local bool is_holder = false;

/// Makes every other thread pass a full fence before it returns, so that threads that call users' code need none.
void fenceAllThreads() {
  std::atomic_thread_fence(std::memory_order_seq_cst);
  if (syscall(SYS_membarrier, MEMBARRIER_CMD_GLOBAL, 0, 0) != 0) {  // some containers refuse the call
    constexpr timespec kLong{0, 50'000'000};                        // longer than any store takes to become visible
    nanosleep(&kLong, nullptr);
  }
}

std::string nameOf(const std::type_info& type) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(abi::__cxa_demangle(type.name(), nullptr, nullptr, &status),
                                                         &std::free);
  return status == 0 ? name.get() : type.name();
}

std::string bounded(std::string text) {
  constexpr std::size_t kMost = 1000;
  if (text.size() > kMost) {
    text.resize(kMost);
    text += " ...";
  }
  return text;
}

std::string otherThing(const std::string& what) { return "threw " + what + ", which is no std::exception"; }

}  // namespace

UserCallNotes& userCallNotes() { return notes; }

// the attribute is repeated: a definition without it would override the declaration
__thread UserCallNote* own_user_call_note __attribute__((tls_model("initial-exec"))) = nullptr;

[[gnu::noinline]] void takeUserCallNote() { thread_local OwnNote own; }

std::atomic<bool> are_user_calls_held{false};

[[gnu::noinline, gnu::cold]] void standStillUnlessHolder() {
  while (!is_holder && are_user_calls_held.load(std::memory_order_acquire)) {
    constexpr timespec kPause{0, 1'000'000};
    nanosleep(&kPause, nullptr);
  }
}

UserCode ownUserCode() {
  const UserCode* call =
      own_user_call_note == nullptr ? nullptr : own_user_call_note->call.load(std::memory_order_relaxed);
  return call == nullptr ? UserCode{} : *call;
}

void holdUserCalls() {
  is_holder = true;
  are_user_calls_held = true;
  fenceAllThreads();
}

void releaseUserCalls() {
  are_user_calls_held = false;
  is_holder = false;
}

void setUserCodeEnder(UserCodeEnder new_ender) { ender = new_ender; }

std::string describe(const UserCode& code) {
  std::string text = std::string(code.phase) + " of ";
  if (code.robot.empty()) {
    text += code.part;
  } else {
    text.append("robot '").append(code.robot).append("' (").append(code.part).append(")");
  }
  if (code.tick != UserCode::kNoTick) {
    text += ", tick " + std::to_string(code.tick);
  }
  return text;
}

UserCall::UserCall(const UserCode& code) noexcept : outer_(enterUserCode(code)) {}

UserCall::~UserCall() { leaveUserCode(outer_); }

std::string describeException() {
  try {
    throw;
  } catch (const std::exception& error) {
    const char* text = error.what();
    return text == nullptr || *text == '\0' ? "threw an exception without a text" : bounded(text);
  } catch (abi::__forced_unwind&) {
    if (const UserCodeEnder end = ender) {
      end("called pthread_exit");
    }
    throw;
  } catch (const char* text) {
    return otherThing(text == nullptr ? "a null pointer" : "the text '" + bounded(text) + "'");
  } catch (const std::string& text) {
    return otherThing("the text '" + bounded(text) + "'");
  } catch (int number) {
    return otherThing("the number " + std::to_string(number));
  } catch (...) {
    return otherThing("a '" + nameOf(*abi::__cxa_current_exception_type()) + "'");
  }
}

std::string libraryOf(const void* address) {
  Dl_info info;
  if (dladdr(address, &info) == 0 || info.dli_fname == nullptr) {
    return "";
  }
  return std::filesystem::path(info.dli_fname).filename().string();
}

}  // namespace swarmanoid
