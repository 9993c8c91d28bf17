#include "dynamics3d/ode.hpp"

#include <stdexcept>

namespace swarmanoid::dynamics3d {
namespace {

std::mutex& processMutex() {
  static std::mutex mutex;
  return mutex;
}

/// @pre the process's mutex is held
void startLibrary() {
  // never closed: worlds of static lifetime may outlive anything that could close it
  static const bool is_started = dInitODE2(0) != 0;
  thread_local const bool has_thread_data = is_started && dAllocateODEDataForThread(dAllocateMaskAll) != 0;
  if (!has_thread_data) {
    throw std::runtime_error("the ODE library does not start");
  }
}

}  // namespace

Turn::Turn(unsigned long& seed) : lock_(processMutex()), seed_(seed) {
  startLibrary();
  dRandSetSeed(seed_);
}

Turn::~Turn() { seed_ = dRandGetSeed(); }

}  // namespace swarmanoid::dynamics3d
