/// Programs of the package swarmanoid_recording that read bags with ROS's library, which this program does not use.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_interface/process/exit_code.hpp"

namespace swarmanoid::program {

/// The program has ended with this code, and has reported the reason.
struct RecordingProgramFailed {
  ExitCode code;
};

/// Replaces this process by that program. @param name of the program @throws ConfigError if it cannot be started
[[noreturn]] void becomeRecordingProgram(const std::string& name, const std::vector<std::string>& arguments);

/// Runs that program and waits for its end. @throws RecordingProgramFailed if its exit code is not 0, ConfigError if it
/// cannot be started, std::runtime_error if a signal ended it
void callRecordingProgram(const std::string& name, const std::vector<std::string>& arguments);

}  // namespace swarmanoid::program
