/// Handles signals that ask this process to end: the first one is handled as before, by roscpp or by the system; from
/// the second on the process ends at once, even inside a call (user_code_watch.hpp).
#pragma once

namespace swarmanoid {

/// Installs the handlers for SIGINT and SIGTERM, once in a process; later calls do nothing.
void passOnSecondSignal();

}  // namespace swarmanoid
