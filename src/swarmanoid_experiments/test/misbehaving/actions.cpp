#include "actions.hpp"

#include <cxxabi.h>
#include <pthread.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cfenv>
#include <chrono>
#include <clocale>
#include <cstdlib>
#include <exception>
#include <limits>
#include <locale>
#include <map>
#include <mutex>
#include <new>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_space/space.hpp"

// called by assert(); its header hides it in builds without assertions, but libraries use it
extern "C" [[noreturn]] void __assert_fail(const char* assertion, const char* file, unsigned line,
                                           const char* function) noexcept;

namespace swarmanoid::test {
namespace {

// exceptions

struct Thing {
  int number = 7;
};

struct Derived : std::runtime_error {
  Derived() : std::runtime_error("a derived exception") {}
};

struct WithoutText : std::exception {
  const char* what() const noexcept override { return ""; }
};

struct WithNullText : std::exception {
  const char* what() const noexcept override { return nullptr; }
};

struct WithLongText : std::runtime_error {
  WithLongText() : std::runtime_error(std::string(1000000, 'x')) {}
};

struct ThrowsWhenItGoes {
  ThrowsWhenItGoes() = default;
  ThrowsWhenItGoes(const ThrowsWhenItGoes&) = default;
  ~ThrowsWhenItGoes() noexcept(false) {
    if (std::uncaught_exceptions() == 0) {
      throw 8;
    }
  }
};

void throwNested() {
  try {
    throw std::runtime_error("the inner one");
  } catch (...) {
    std::throw_with_nested(std::logic_error("the outer one"));
  }
}

void throwIt() { throw std::runtime_error("out of a function that throws nothing"); }

void throwThroughNoexcept() noexcept { throwIt(); }

// crashes: volatile variables hide them from the compiler

volatile int zero = 0;
int* volatile null = nullptr;

void readNowhere() { zero = *null; }

void writeNowhere() { *null = 1; }

void callNowhere() {
  using Function = void (*)();
  const volatile Function function = nullptr;
  function();
}

void divideByZero() {
  const volatile int number = 12;
  zero = number / zero;
}

void readBeyondTheEndOfAFile() {
  const int file = memfd_create("misbehaving", 0);  // an empty file
  void* page = mmap(nullptr, 1, PROT_READ, MAP_SHARED, file, 0);
  zero = *static_cast<volatile char*>(page);
}

[[gnu::noinline]] int recurse(int depth) {
  volatile char frame[4096];
  frame[static_cast<std::size_t>(depth) % sizeof frame] = 1;
  return zero == 12345 ? 0 : recurse(depth + 1) + frame[0];
}

void freeTwice() {
  char* volatile memory = static_cast<char*>(std::malloc(2000));
  char* volatile same = memory;
  std::free(memory);
  std::free(same);
}

/// Overwrites std::malloc's bookkeeping beside its blocks; the next allocation crashes.
void spoilTheHeap() {
  volatile char* memory = static_cast<char*>(std::malloc(24));
  for (int i = 0; i < 4096; ++i) {
    memory[i] = static_cast<char>(0xee);
  }
  for (std::size_t size = 16; size < 4096; size += 16) {
    std::free(std::malloc(size));
  }
}

Space* exposed = nullptr;

/// Saved data of the run must date from before this call.
void spoilTheStateAndCrash() {
  if (exposed != nullptr) {
    exposed->entities.pose[rowAt(0)].position.x() += 1.0;
  }
  raise(SIGSEGV);
}

// endless calls

void loop() {
  for (;;) {
    zero = zero + 1;
  }
}

void sleepForEver() {
  for (;;) {
    std::this_thread::sleep_for(std::chrono::hours(1));
  }
}

void waitForItself() {
  std::timed_mutex mutex;
  mutex.lock();
  while (!mutex.try_lock_for(std::chrono::hours(1))) {
  }
}

void loopDeafToSignals() {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, nullptr);
  loop();
}

// changes of the process

void crashOnAnotherThread() {
  std::thread(writeNowhere).detach();
  std::this_thread::sleep_for(std::chrono::seconds(1));
}

void throwOnAnotherThread() {
  std::thread([] { throw 5; }).detach();
  std::this_thread::sleep_for(std::chrono::seconds(1));
}

void setCommaLocale() {
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) {
    if (std::setlocale(LC_ALL, name) != nullptr) {
      return;
    }
  }
}

/// Digits in groups and a decimal comma, independent of the installed locales.
struct Commas : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

void forkAndGoOn() {
  const pid_t child = fork();
  if (child == 0) {
    _exit(0);
  }
  waitpid(child, nullptr, 0);
}

void takeAllMemory() {
  // more than any machine has: the attempt fails without side effects
  const std::size_t volatile size = std::numeric_limits<std::size_t>::max() / 4;
  ::operator delete(::operator new(size));
}

using Action = void (*)();

const std::map<std::string, Action>& table() {
  // never destroyed: the library's own static destructor uses it
  static const auto& actions = *new const std::map<std::string, Action>{
      {"nothing", [] {}},
      {"throw_runtime_error", [] { throw std::runtime_error("told to"); }},
      {"throw_derived", [] { throw Derived(); }},
      {"throw_config_error", [] { throw ConfigError({}, "told to, as a configuration error"); }},
      {"throw_bad_alloc", [] { throw std::bad_alloc(); }},
      {"throw_system_error", [] { throw std::system_error(std::make_error_code(std::errc::io_error)); }},
      {"throw_int", [] { throw 7; }},
      {"throw_string", [] { throw std::string("a string"); }},
      {"throw_text", [] { throw "a text"; }},
      {"throw_null", [] { throw static_cast<const char*>(nullptr); }},
      {"throw_nullptr", [] { throw nullptr; }},
      {"throw_thing", [] { throw Thing(); }},
      {"throw_pointer", [] { throw new std::runtime_error("on the heap"); }},
      {"throw_without_text", [] { throw WithoutText(); }},
      {"throw_null_text", [] { throw WithNullText(); }},
      {"throw_long_text", [] { throw WithLongText(); }},
      {"throw_nested", throwNested},
      {"throw_that_throws", [] { throw ThrowsWhenItGoes(); }},
      {"throw_through_noexcept", throwThroughNoexcept},
      {"terminate", [] { std::terminate(); }},
      {"segv_read", readNowhere},
      {"segv_write", writeNowhere},
      {"segv_call", callNowhere},
      {"segv_raise", [] { raise(SIGSEGV); }},
      {"segv_on_another_thread", crashOnAnotherThread},
      {"throw_on_another_thread", throwOnAnotherThread},
      {"stack_overflow", [] { zero = recurse(0); }},
      {"bus", readBeyondTheEndOfAFile},
      {"fpe", divideByZero},
      {"ill", [] { __builtin_trap(); }},
      {"abort", [] { std::abort(); }},
      {"assert", [] { __assert_fail("area > b2_epsilon", "b2_polygon_shape.cpp", 123, "ComputeMass"); }},
      {"spoil_state", spoilTheStateAndCrash},
      {"free_twice", freeTwice},
      {"spoil_heap", spoilTheHeap},
      {"pure_virtual", [] { abi::__cxa_pure_virtual(); }},
      {"exit_0", [] { std::exit(0); }},
      {"exit_7", [] { std::exit(7); }},
      {"quick_exit_0", [] { std::quick_exit(0); }},
      {"underscore_exit_0", [] { _exit(0); }},
      {"thread_exit", [] { pthread_exit(nullptr); }},
      {"raise_int", [] { raise(SIGINT); }},
      {"raise_term", [] { raise(SIGTERM); }},
      {"raise_pipe", [] { raise(SIGPIPE); }},
      {"raise_kill", [] { raise(SIGKILL); }},
      {"loop", loop},
      {"loop_deaf", loopDeafToSignals},
      {"sleep_for_ever", sleepForEver},
      {"wait_for_itself", waitForItself},
      {"sleep_1", [] { std::this_thread::sleep_for(std::chrono::seconds(1)); }},
      {"sleep_7", [] { std::this_thread::sleep_for(std::chrono::seconds(7)); }},
      {"setlocale", setCommaLocale},
      {"global_locale", [] { std::locale::global(std::locale(std::locale::classic(), new Commas)); }},
      {"close_output", [] { close(STDOUT_FILENO); }},
      {"change_folder", [] { zero = chdir("/"); }},
      {"default_signals",
       [] {
         for (const int number : {SIGINT, SIGTERM, SIGSEGV, SIGABRT}) {
           signal(number, SIG_DFL);
         }
       }},
      {"fork", forkAndGoOn},
      {"all_memory", takeAllMemory},
      {"clear_environment", [] { clearenv(); }}};
  return actions;
}

}  // namespace

std::vector<std::string> actions() {
  std::vector<std::string> names;
  for (const auto& entry : table()) {
    names.push_back(entry.first);
  }
  return names;
}

// bypasses the const interface, as faulty code could
void expose(const Space& space) { exposed = const_cast<Space*>(&space); }

void perform(const std::string& action) {
  const auto found = table().find(action);
  if (found == table().end()) {
    throw std::runtime_error("no such action as '" + action + "'; there are: " + joinNames(actions()));
  }
  found->second();
}

PluginDescription Misbehaviour::describe(const std::string& label) {
  PluginDescription description;
  description.label = label;
  description.summary = "Misbehaves.";
  for (const char* name : {"phase", "action"}) {
    description.parameters.push_back(
        makeParameter(name, Parameter::Type::kText, "", std::nullopt, {}, "What it does, and when."));
  }
  return description;
}

void Misbehaviour::configure(const Configuration& parameters) {
  phase_ = parameters.text("phase");
  action_ = parameters.text("action");
  tryIn("configure");
}

void Misbehaviour::tryIn(const std::string& phase) const {
  if (phase_ == phase) {
    perform(action_);
  }
}

void Misbehaviour::tryIn(const std::string& phase, std::uint64_t tick) const {
  if (tick == kTick) {
    tryIn(phase);
  }
}

}  // namespace swarmanoid::test
