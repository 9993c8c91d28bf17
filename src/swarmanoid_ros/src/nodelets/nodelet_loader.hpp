/// Loads nodelets into the manager of this process, by the manager's service.
///
/// Threads  it is called from a separate thread: inside onInit the manager is busy, and the call would wait for ever.
#pragma once

#include <ros/node_handle.h>

#include <atomic>
#include <string>
#include <vector>

namespace swarmanoid {

class NodeletLoader {
 public:
  NodeletLoader();

  /// Returns whether this process is a manager; a nodelet may also run without one.
  bool isManager() const { return is_manager_; }

  /// Loads a nodelet for part `id` of a space. It replaces a loaded one of that name.
  /// @return false if the manager could not load it; the manager's log gives the reason
  bool load(const std::string& name, const std::string& type, const std::string& space, const std::string& id);

  /// @return false if the manager has no such nodelet
  bool unload(const std::string& name);

  /// Returns the nodelet made for a controller, <package>/<label>; swarmanoid_hosts/ControllerNodelet if there is none,
  /// or more than one.
  std::string controllerNodelet(const std::string& label);

  /// Ends a call that is under way; later calls do nothing, because a manager that is ending would not answer.
  void shutdown();

 private:
  ros::ServiceClient load_;
  ros::ServiceClient unload_;
  ros::ServiceClient list_;
  bool is_manager_ = false;
  std::atomic<bool> is_shut_down_{false};
  std::vector<std::string> declared_;
};

}  // namespace swarmanoid
