/// Exit codes of the processes of the suite: the program `swarmanoid`, the space's nodelet, which writes the code to a
/// file as well, and hosts of controllers. Scripts depend on the numbers, so they do not change
/// (docs/reference/program.md).
#pragma once

namespace swarmanoid {

enum class ExitCode : int {
  kFinished = 0,          ///< the run was completed, whether or not the experiment was a success
  kDiffers = 1,           ///< compared results differ: a repeated run, two records, replayed commands
  kBadInput = 2,          ///< a mistake in a file, a parameter or on the command line: nothing was run
  kControllerFailed = 3,  ///< it threw, crashed or took too long: the run went on without it, or ended in that call
  kStopped = 4,           ///< an engine, a device, an observer, another participant or a full disk stopped the run
  kInterrupted = 130      ///< a signal ended the run; 128 + SIGINT, as in shells
};

/// Converts the code for main, exit and files.
constexpr int toNumber(ExitCode code) { return static_cast<int>(code); }

}  // namespace swarmanoid
