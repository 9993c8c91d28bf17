/// Signals that ask a run to end. The first one ends it at the next tick boundary, with results, files and summary. The
/// second one, SIGINT or SIGTERM, ends it where it is (user_code_watch.hpp); a SIGHUP that is not the first changes
/// nothing.
#pragma once

namespace swarmanoid::program {

/// From here on SIGINT, SIGTERM and SIGHUP are noted instead of ending the process. SIGHUP stays ignored where it is:
/// nohup asks for that. A pipe that nobody reads any more and a file that has grown to its limit become errors of
/// whoever writes there.
void noteInterruptions();

/// Whether one of them has come.
bool isInterrupted();

}  // namespace swarmanoid::program
