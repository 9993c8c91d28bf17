/// Signals that end a process which has done something wrong.
#pragma once

#include <signal.h>

#include <array>

namespace swarmanoid {

struct CrashSignal {
  int number;
  const char* name;
  const char* ending;  ///< for messages that are written in a handler, where texts cannot be put together
};

constexpr std::array<CrashSignal, 5> kCrashSignals{{{SIGSEGV, "SIGSEGV", "crashed: SIGSEGV"},
                                                    {SIGBUS, "SIGBUS", "crashed: SIGBUS"},
                                                    {SIGFPE, "SIGFPE", "crashed: SIGFPE"},
                                                    {SIGILL, "SIGILL", "crashed: SIGILL"},
                                                    {SIGABRT, "SIGABRT", "crashed: SIGABRT"}}};

}  // namespace swarmanoid
