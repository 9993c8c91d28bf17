/// What this process ends with, the same numbers as those of the program `swarmanoid`.
///
/// A nodelet manager returns 0 whatever happened in it. roslaunch is to report a run that failed.
#pragma once

namespace swarmanoid {

enum class ExitCode { kFinished = 0, kBadInput = 2, kControllerFailed = 3, kStopped = 4 };

/// Takes effect when the process ends by itself. The first one that is not kFinished counts.
void setExitCode(ExitCode code);

}  // namespace swarmanoid
