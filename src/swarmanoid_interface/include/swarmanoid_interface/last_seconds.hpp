/// What libraries do when the process ends is users' code too: static destructors, which nobody watches.
#pragma once

namespace swarmanoid {

/// To be called when all is done and said: a process that does not end by itself ends with this exit code some seconds
/// later, and says so.
void endWithinSeconds(int exit_code);

}  // namespace swarmanoid
