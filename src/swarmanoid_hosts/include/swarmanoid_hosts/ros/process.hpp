/// Controls the exit code and the signals of the process of a standalone nodelet. Its program, `nodelet standalone`,
/// always returns 0, and roscpp's own handling of signals shuts down all publishers before a last command can be sent
/// to a robot.
#pragma once

#include <string>

#include "swarmanoid_interface/process/exit_code.hpp"

namespace swarmanoid::process {

/// Returns whether this nodelet is the only one in the process. @param nodelet its full name
bool isStandalone(const std::string& nodelet);

/// From now on SIGINT, SIGTERM and `rosnode kill` only request the end. A second signal ends the process at once. Call
/// it once, on the main thread.
void takeOverSignals();
bool isEndAskedFor();

/// Sets the exit code with which the process ends after the program returns from main. The first code stays.
void endWith(ExitCode code);

}  // namespace swarmanoid::process
