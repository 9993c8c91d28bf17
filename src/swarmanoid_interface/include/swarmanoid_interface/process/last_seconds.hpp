/// What libraries do when the process ends is users' code too: static destructors, which nobody watches.
#pragma once

#include "swarmanoid_interface/process/exit_code.hpp"

namespace swarmanoid {

/// To be called when all is done and said: a process that does not end by itself ends with this exit code some seconds
/// later, and says so. Starts a thread for that, which keeps nobody from ending earlier; where there can be none,
/// nothing happens. From any thread.
void endWithinSeconds(ExitCode code);

}  // namespace swarmanoid
