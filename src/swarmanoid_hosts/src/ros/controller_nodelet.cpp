#include "swarmanoid_hosts/ros/controller_nodelet.hpp"

#include <ros/console.h>

#include <stdexcept>

#include "swarmanoid_hosts/ros/participant.hpp"
#include "swarmanoid_hosts/ros/process.hpp"
#include "swarmanoid_hosts/ros/robot_host.hpp"
#include "swarmanoid_interface/process/user_code_watch.hpp"

namespace swarmanoid {
namespace {

/// Refuses a parameter that only the other provider reads.
void refuse(const ros::NodeHandle& own, const std::string& parameter, const std::string& instead) {
  if (own.hasParam(parameter)) {
    throw ConfigError({own.getNamespace() + "/" + parameter, 0}, "found values, allowed: " + instead);
  }
}

}  // namespace

ControllerNodelet::ControllerNodelet(std::string label)
    : PartNodelet(PluginKind::kController), label_(std::move(label)) {}

ControllerNodelet::~ControllerNodelet() = default;

bool ControllerNodelet::runAlone() {
  ros::NodeHandle& own = getPrivateNodeHandle();
  if (!own.hasParam("robots")) {
    return false;
  }
  const std::string& name = getName();
  const bool is_standalone = process::isStandalone(name);
  UserCodeWatch::Options options;
  options.report = [](const std::string& text) { ROS_WARN("%s", text.c_str()); };
  watch_ = std::make_unique<UserCodeWatch>(options);
  try {
    ParameterReader reader(own);
    const std::string provider = reader.choice("provider", {"lockstep", "topics"});
    Participant::Options options_of_participant = Participant::readOptions(reader);
    reader.text("controller", "");
    reader.text("library", "");  // marks them as read; their later reader is as strict
    reader.refuseUnread({"parameters", "configuration"});
    if (provider == "topics") {
      refuse(own, "parameters", "none with provider:=topics; the configuration has those of the controller");
      robot_host_ = std::make_unique<RobotHost>(own, label_, is_standalone);
    } else {
      refuse(own, "configuration", "none with provider:=lockstep; the experiment says what a robot has");
      participant_ = std::make_unique<Participant>(own, std::move(options_of_participant),
                                                   name.substr(name.find_first_not_of('/')), label_, is_standalone);
    }
  } catch (...) {
    const std::string reason = describeException();
    NODELET_FATAL("%s: %s", name.c_str(), reason.c_str());
    if (is_standalone) {
      process::endWith(ExitCode::kBadInput);
    }
    throw std::runtime_error(reason);  // the nodelet does not load
  }
  return true;
}

std::shared_ptr<void> ControllerNodelet::makePart(const AttachmentPoint::Request& request) {
  if (!label_.empty() && label_ != request.label) {
    throw std::runtime_error("this nodelet hosts '" + label_ + "', controller '" + request.id + "' is a '" +
                             request.label + "'");
  }
  const Registry::Entry& entry = Registry::instance().require(PluginKind::kController, request.label);
  return std::make_shared<ControllerFactory>([&entry] { return makePlugin<Controller>(entry); });
}

}  // namespace swarmanoid
