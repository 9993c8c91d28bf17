#include "nodelet_loader.hpp"

#include <nodelet/NodeletList.h>
#include <nodelet/NodeletLoad.h>
#include <nodelet/NodeletUnload.h>
#include <nodelet/nodelet.h>
#include <ros/param.h>
#include <ros/service.h>
#include <ros/this_node.h>
#include <pluginlib/class_loader.hpp>

#include <algorithm>

namespace swarmanoid {

NodeletLoader::NodeletLoader() {
  const std::string& manager = ros::this_node::getName();
  is_manager_ = ros::service::exists(manager + "/load_nodelet", false);
  ros::NodeHandle root;
  constexpr bool kPersistent = true;
  load_ = root.serviceClient<nodelet::NodeletLoad>(manager + "/load_nodelet", kPersistent);
  unload_ = root.serviceClient<nodelet::NodeletUnload>(manager + "/unload_nodelet", kPersistent);
  list_ = root.serviceClient<nodelet::NodeletList>(manager + "/list", kPersistent);
}

void NodeletLoader::shutdown() {
  is_shut_down_ = true;
  load_.shutdown();
  unload_.shutdown();
  list_.shutdown();
}

bool NodeletLoader::load(const std::string& name, const std::string& type, const std::string& space,
                         const std::string& id) {
  if (is_shut_down_) {
    return false;
  }
  nodelet::NodeletList list;
  if (list_.call(list)) {
    const auto& loaded = list.response.nodelets;
    if (std::find(loaded.begin(), loaded.end(), name) != loaded.end()) {
      unload(name);  // left over from a space that was unloaded
    }
  }
  ros::param::set(name + "/space", space);
  ros::param::set(name + "/id", id);
  nodelet::NodeletLoad load;
  load.request.name = name;
  load.request.type = type;
  return load_.call(load) && load.response.success != 0;
}

bool NodeletLoader::unload(const std::string& name) {
  if (is_shut_down_) {
    return false;
  }
  nodelet::NodeletUnload unload;
  unload.request.name = name;
  return unload_.call(unload) && unload.response.success != 0;
}

std::string NodeletLoader::controllerNodelet(const std::string& label) {
  if (declared_.empty()) {
    declared_ = pluginlib::ClassLoader<nodelet::Nodelet>("nodelet", "nodelet::Nodelet").getDeclaredClasses();
  }
  std::vector<std::string> matches;
  for (const std::string& type : declared_) {
    const auto slash = type.find('/');
    if (slash != std::string::npos && type.substr(slash + 1) == label) {
      matches.push_back(type);
    }
  }
  return matches.size() == 1 ? matches.front() : "swarmanoid_hosts/ControllerNodelet";
}

}  // namespace swarmanoid
