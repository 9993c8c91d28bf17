/// Limits what static destructors of libraries do to a process that ends: they are users' code too, and no watch covers
/// them.
#pragma once

#include "swarmanoid_interface/process/exit_code.hpp"

namespace swarmanoid {

/// Is called when all work and output is done, by the thread that ends the process: if it crashes, or does not end by
/// itself within some seconds, it ends with this exit code, and reports that. The function starts a thread for the
/// limit of time, which does not delay an earlier end; where no thread can be started, there is none.
void endWithinSeconds(ExitCode code);

}  // namespace swarmanoid
