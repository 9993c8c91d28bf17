/// Signals that ask the process to end.
#pragma once

namespace swarmanoid {

/// ROS takes SIGINT alone. From here on SIGTERM and SIGHUP shut ROS down too, so that nodelets are unloaded and files
/// completed, unless somebody else takes them, or nohup has them ignored. A file at its limit is an error of its
/// writer.
void shutDownOnSignals();

/// Whether ROS ends or has ended. It logs no more from the beginning of that, while ros::ok() holds to its end.
bool isRosEnding();

}  // namespace swarmanoid
