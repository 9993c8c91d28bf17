/// Accesses the roslaunch process that has started this process.
///
/// roslaunch ends when a required process does, but reports that as a failure whatever the process returned. When it is
/// interrupted it ends without an error message and interrupts its processes: a run that ends normally ends so.
#pragma once

namespace swarmanoid {

/// Interrupts roslaunch, as Ctrl-C does. @return false if this process is no child of a roslaunch (such as in a
/// debugger, or of another program that uses roslaunch's modules, which may have more to do)
bool interruptRoslaunch();

}  // namespace swarmanoid
