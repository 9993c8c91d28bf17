/// Handles signals that ask the process to end.
#pragma once

namespace swarmanoid {

/// ROS handles SIGINT only. From here on SIGTERM and SIGHUP shut ROS down too, so that nodelets are unloaded and files
/// completed, unless another handler is installed, or nohup has them ignored. A file that reaches its size limit is
/// reported as an error of its writer.
void shutDownOnSignals();

/// Returns whether the shutdown of ROS has begun. From its beginning on ROS logs no more, while ros::ok() is true until
/// its end.
bool isRosEnding();

}  // namespace swarmanoid
