/// The roslaunch that has started this process.
///
/// roslaunch ends when a required process does, but tells of it as of an accident, whatever that returned. It ends
/// without alarm when it is interrupted, and then interrupts its processes: a run that is over as it should be ends so.
#pragma once

namespace swarmanoid {

/// Interrupts it, as Ctrl-C does. @return false if this process is no child of a roslaunch (such as in a debugger, or
/// of another program that uses roslaunch's modules, which may have more to do)
bool interruptRoslaunch();

}  // namespace swarmanoid
