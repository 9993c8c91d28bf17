#include "dynamics3d/ode.hpp"

#include <cstdarg>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid::dynamics3d {
namespace {

std::mutex& processMutex() {
  static std::mutex mutex;
  return mutex;
}

long solver_failures = 0;  // guarded by processMutex
thread_local bool is_held = false;

void takeMessage(int number, const char* text, va_list values) {
  if (number == d_ERR_LCP) {
    ++solver_failures;
    return;
  }
  std::fprintf(stderr, "ODE message %d: ", number);
  std::vfprintf(stderr, text, values);
  std::fputc('\n', stderr);
}

/// ODE would end the process after these messages. After the exception, the world must not be stepped again: the run
/// stops.
[[noreturn]] void throwMessage(int number, const char* text, va_list values) {
  constexpr std::size_t kLongest = 500;
  char message[kLongest];
  std::vsnprintf(message, kLongest, text, values);
  throw std::runtime_error("the ODE library gives up (" + std::to_string(number) + "): " + message);
}

/// @pre the process's mutex is held
void startLibrary() {
  // never closed: worlds of static lifetime may outlive any owner of the library
  static const bool is_started = dInitODE2(0) != 0;
  dSetMessageHandler(&takeMessage);
  dSetErrorHandler(&throwMessage);
  dSetDebugHandler(&throwMessage);
  thread_local const bool has_thread_data = is_started && dAllocateODEDataForThread(dAllocateMaskAll) != 0;
  if (!has_thread_data) {
    throw std::runtime_error("the ODE library does not start");
  }
}

}  // namespace

OdeLock::OdeLock(unsigned long& seed) : lock_(processMutex()), seed_(seed) {
  startLibrary();  // may throw, so it comes before is_held is set
  is_held = true;
  dRandSetSeed(seed_);
}

OdeLock::~OdeLock() {
  seed_ = dRandGetSeed();
  is_held = false;
}

bool OdeLock::isHeld() { return is_held; }

long solverFailures() {
  SWARMANOID_EXPECTS(OdeLock::isHeld());
  return solver_failures;
}

}  // namespace swarmanoid::dynamics3d
