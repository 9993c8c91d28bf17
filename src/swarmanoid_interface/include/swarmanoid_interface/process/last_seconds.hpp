/// Ends a process whose static destructors crash or hang: those of libraries are users' code too, and no watch covers
/// them.
#pragma once

#include "swarmanoid_interface/process/exit_code.hpp"

namespace swarmanoid {

/// The thread that ends the process calls this function when all work and output is done. If the process then crashes,
/// or does not end by itself within some seconds, it ends with this exit code and reports that. The time limit runs in
/// a thread of its own, which does not delay an earlier end; if no thread can be started, there is no time limit.
void endWithinSeconds(ExitCode code);

}  // namespace swarmanoid
