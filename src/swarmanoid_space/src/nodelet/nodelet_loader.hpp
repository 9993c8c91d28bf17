/// Has the manager of this process load nodelets, by its own service.
///
/// Threads  from a thread of its own: inside onInit the manager is busy, and the call would wait for ever.
#pragma once

#include <ros/node_handle.h>

#include <atomic>
#include <string>
#include <vector>

namespace swarmanoid {

class NodeletLoader {
 public:
  NodeletLoader();

  /// Whether this process is a manager; a nodelet may also run alone.
  bool isManager() const { return is_manager_; }

  /// Loads a nodelet that is to bring part `id` to a space. One of that name that is there already is replaced.
  /// @return false if the manager could not; its log says why
  bool load(const std::string& name, const std::string& type, const std::string& space, const std::string& id);

  /// @return false if the manager has no such nodelet
  bool unload(const std::string& name);

  /// The nodelet made for a controller, <package>/<label>; swarmanoid_hosts/ControllerNodelet if there is none, or
  /// more than one.
  std::string controllerNodelet(const std::string& label);

  /// Ends a call that is under way; later ones do nothing, for a manager that is ending would not answer.
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
