/// Publishes the result of a run as the exit code of this process, and in a file.
///
/// A nodelet manager returns 0 whatever happened in it, and roslaunch returns 0 whatever its nodes return. With the
/// file the program that started roslaunch can find out whether the run failed.
#pragma once

#include <string>

#include "swarmanoid_interface/process/exit_code.hpp"

namespace swarmanoid {

/// Sets the exit code for when the process ends by itself. The first one that is not kFinished counts.
void setExitCode(ExitCode code);

/// Returns the file in which the program that started this process expects the exit code; "": none. An environment
/// variable (SWARMANOID_EXIT_CODE) names it, because other users cannot change it as they can parameters.
std::string exitCodeFileOfStarter();

/// Writes the number to a file, which is replaced as a whole or stays unchanged. Nothing happens if the name is empty.
/// @throws std::runtime_error if it cannot be written, or if an existing file contains anything else
void writeExitCode(const std::string& file, ExitCode code);

}  // namespace swarmanoid
