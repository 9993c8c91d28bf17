/// Checks preconditions of functions (@pre). A violation is a mistake in the suite, not in a user's file, so it ends
/// the process.
///
/// Checked in builds without NDEBUG, and with the CMake option SWARMANOID_EXPECTATIONS, which ./test sets. In other
/// builds the condition is compiled but never evaluated, so it costs nothing.
#pragma once

#include <cstdio>
#include <cstdlib>

#if !defined(NDEBUG) || defined(SWARMANOID_EXPECTATIONS)
#define SWARMANOID_EXPECTS(condition) \
  ((condition) ? static_cast<void>(0) : ::swarmanoid::endUnexpected(#condition, __FILE__, __LINE__))
#else
#define SWARMANOID_EXPECTS(condition) static_cast<void>(sizeof((condition) ? 1 : 0))
#endif

namespace swarmanoid {

/// Reports which condition is false and where, and aborts.
[[noreturn, gnu::cold, gnu::noinline]] inline void endUnexpected(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: expected of the caller: %s\n", file, line, condition);
  std::abort();
}

}  // namespace swarmanoid
