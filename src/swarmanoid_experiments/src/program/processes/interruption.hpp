/// Handles signals that ask a run to end. The first one ends it at the next tick boundary, with results, files and
/// summary. A second SIGINT or SIGTERM ends it at once, even inside a call (user_code_watch.hpp); a later SIGHUP has no
/// effect.
#pragma once

namespace swarmanoid::program {

/// Makes SIGINT, SIGTERM and SIGHUP be recorded instead of ending the process. SIGHUP stays ignored if it is ignored
/// already, as under nohup. A pipe without a reader and a file at its size limit become errors of their writer.
void noteInterruptions();

/// Returns whether one of the signals has arrived.
bool isInterrupted();

}  // namespace swarmanoid::program
