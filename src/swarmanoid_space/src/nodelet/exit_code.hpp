/// What a run ends with: as the exit code of this process, and in a file.
///
/// A nodelet manager returns 0 whatever happened in it, and roslaunch returns 0 whatever its nodes return. roslaunch is
/// to report a run that failed, and whoever started roslaunch is to find out.
#pragma once

#include <string>

#include "swarmanoid_interface/process/exit_code.hpp"

namespace swarmanoid {

/// Takes effect when the process ends by itself. The first one that is not kFinished counts.
void setExitCode(ExitCode code);

/// The file that whoever started this process wants the exit code in; "": none. It is named by the environment
/// (SWARMANOID_EXIT_CODE), which others cannot change as they can parameters.
std::string exitCodeFileOfStarter();

/// Writes the number to a file, which is replaced as a whole, or stays as it was. Nothing happens if the name is empty.
/// @throws std::runtime_error if it cannot be written, or a file is there that holds anything else
void writeExitCode(const std::string& file, ExitCode code);

}  // namespace swarmanoid
