/// What processes of the suite end with: the program `swarmanoid`, the space's nodelet, which writes it to a file as
/// well, hosts of controllers, mock drivers. Scripts go by the numbers, so they stay (docs/reference/program.md).
#pragma once

namespace swarmanoid {

enum class ExitCode : int {
  kFinished = 0,          ///< done, whether or not the experiment was a success
  kBadInput = 2,          ///< a mistake in a file, a parameter or on the command line: nothing was run
  kControllerFailed = 3,  ///< it threw, crashed or took too long: the run went on without it, or ended in that call
  kStopped = 4,           ///< by an engine, a device, an observer or another participant, or by a disk that is full
  kInterrupted = 130      ///< by a signal; 128 + SIGINT, as shells have it
};

/// For main, exit and files.
constexpr int toNumber(ExitCode code) { return static_cast<int>(code); }

}  // namespace swarmanoid
