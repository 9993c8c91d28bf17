/// Signals that ask this process to end: the first is answered as it was before, by roscpp or by the system; from the
/// second on the process is to end where it is (user_code_watch.hpp).
#pragma once

namespace swarmanoid {

/// For SIGINT and SIGTERM. Once in a process; later calls do nothing.
void passOnSecondSignal();

}  // namespace swarmanoid
