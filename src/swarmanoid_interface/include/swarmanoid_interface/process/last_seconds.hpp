/// Limits the time that the process takes to end: static destructors of libraries are users' code too, and no watch
/// covers them.
#pragma once

#include "swarmanoid_interface/process/exit_code.hpp"

namespace swarmanoid {

/// Is called when all work and output is done: a process that does not end by itself within some seconds ends with this
/// exit code, and reports it. The function starts a thread for that, which does not delay an earlier end; where no
/// thread can be started, nothing happens. It may be called from any thread.
void endWithinSeconds(ExitCode code);

}  // namespace swarmanoid
