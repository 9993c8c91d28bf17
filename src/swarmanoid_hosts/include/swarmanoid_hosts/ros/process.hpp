/// The process of a standalone nodelet, where its program does too little: it is `nodelet standalone`, which returns 0
/// whatever became of its nodelet, and roscpp's own answer to signals shuts all publishers before anybody can say a
/// last word to a robot.
#pragma once

#include <string>

#include "swarmanoid_interface/process/exit_code.hpp"

namespace swarmanoid::process {

/// Whether the process is that of this nodelet alone. @param nodelet its full name
bool isStandalone(const std::string& nodelet);

/// From now on SIGINT, SIGTERM and `rosnode kill` only say that the end is asked for. A second signal ends the process
/// at once. Once, on the main thread.
void takeOverSignals();
bool isEndAskedFor();

/// When the program is through with main, the process ends with this code. The first code stays.
void endWith(ExitCode code);

}  // namespace swarmanoid::process
