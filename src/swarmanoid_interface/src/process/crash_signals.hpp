/// The signals of crashes.
#pragma once

#include <signal.h>

#include <array>

namespace swarmanoid {

struct CrashSignal {
  int number;
  const char* name;
  const char* ending;  ///< for messages of signal handlers, which cannot concatenate texts
};

constexpr std::array<CrashSignal, 5> kCrashSignals{{{SIGSEGV, "SIGSEGV", "crashed: SIGSEGV"},
                                                    {SIGBUS, "SIGBUS", "crashed: SIGBUS"},
                                                    {SIGFPE, "SIGFPE", "crashed: SIGFPE"},
                                                    {SIGILL, "SIGILL", "crashed: SIGILL"},
                                                    {SIGABRT, "SIGABRT", "crashed: SIGABRT"}}};

}  // namespace swarmanoid
