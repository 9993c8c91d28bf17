/// The subcommands of the program `swarmanoid`. Each function adds one to the command line; the return value of the
/// command is the exit code.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "swarmanoid_interface/process/exit_code.hpp"

namespace swarmanoid::program {

using Command = std::function<ExitCode()>;

/// `run FILE` runs an experiment without ROS.
Command addRunCommand(CLI::App& app);
/// `rerun RUN` repeats a recorded run, and compares the state of each tick.
Command addRerunCommand(CLI::App& app);
/// `launch EXPERIMENT [ARGUMENT...]` runs an experiment under ROS, with the same exit codes as `run`.
Command addLaunchCommand(CLI::App& app);
/// `diff RUN1 RUN2` finds the first tick in which two recorded runs differ, and the fields that differ in it.
Command addDiffCommand(CLI::App& app);
/// `validate FILE` reads an experiment file, builds the experiment, and reports mistakes.
Command addValidateCommand(CLI::App& app);
/// `list [KIND]` lists the names that may be used in an experiment file.
Command addListCommand(CLI::App& app);
/// `describe [DEVICE]` prints the documentation of a device in the code, as Markdown.
Command addDescribeCommand(CLI::App& app);
/// `check-robot FILE` lists all problems of a robot's description, or the capabilities of the robot.
Command addCheckRobotCommand(CLI::App& app);
/// `sample DEVICE` writes a table of a sensor's readings, for its implementation `sampled`.
Command addSampleCommand(CLI::App& app);
/// `schema` prints the XSD of experiment files, with all installed plugins.
Command addSchemaCommand(CLI::App& app);

}  // namespace swarmanoid::program
