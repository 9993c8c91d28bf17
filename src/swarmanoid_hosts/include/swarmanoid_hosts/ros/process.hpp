/// Controls the process of a standalone nodelet, because its program does too little: the program is `nodelet
/// standalone`, which returns 0 whatever the result of its nodelet is, and roscpp's own handling of signals shuts all
/// publishers down before a last command can be sent to a robot.
#pragma once

#include <string>

#include "swarmanoid_interface/process/exit_code.hpp"

namespace swarmanoid::process {

/// Returns whether this nodelet is the only one in the process. @param nodelet its full name
bool isStandalone(const std::string& nodelet);

/// From now on SIGINT, SIGTERM and `rosnode kill` only request the end. A second signal ends the process at once. It is
/// called once, on the main thread.
void takeOverSignals();
bool isEndAskedFor();

/// Sets the exit code with which the process ends after the program returns from main. The first code stays.
void endWith(ExitCode code);

}  // namespace swarmanoid::process
