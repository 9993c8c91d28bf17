/// The subcommands of the program `swarmanoid`. Each adds itself to the command line; what it returns is the exit code.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "swarmanoid_interface/process/exit_code.hpp"

namespace swarmanoid::program {

using Command = std::function<ExitCode()>;

/// `run FILE`: runs an experiment without ROS.
Command addRunCommand(CLI::App& app);
/// `launch EXPERIMENT [ARGUMENT...]`: runs an experiment under ROS, and returns what `run` would.
Command addLaunchCommand(CLI::App& app);
/// `diff RUN1 RUN2`: the first tick in which two recorded runs differ, and the fields that differ in it.
Command addDiffCommand(CLI::App& app);
/// `validate FILE`: reads an experiment file, builds it, and says what is wrong.
Command addValidateCommand(CLI::App& app);
/// `list [KIND]`: what can be named in an experiment file.
Command addListCommand(CLI::App& app);
/// `schema`: the XSD of experiment files.
Command addSchemaCommand(CLI::App& app);

}  // namespace swarmanoid::program
