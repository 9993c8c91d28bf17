/// Transports frames between a simulation and its participants: the service ~register; the topics ~participants/<name>/
/// sensors and commands, or for those on this computer the socket ~lockstep_socket; and a status in /diagnostics that
/// names the late participants.
///
/// Threads  it has a queue and a thread of its own, so that it answers while a tick waits.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <swarmanoid_msgs/CommandFrame.h>
#include <swarmanoid_msgs/Register.h>

#include <map>
#include <memory>
#include <string>

#include "local_participants.hpp"
#include "swarmanoid_space/lockstep/lockstep.hpp"

namespace swarmanoid {

class LockstepServer {
 public:
  /// @param lockstep of a simulation, outlives this object
  LockstepServer(const ros::NodeHandle& own, const std::string& experiment, Lockstep& lockstep);
  ~LockstepServer();

 private:
  struct Channel;

  bool join(swarmanoid_msgs::Register::Request& request, swarmanoid_msgs::Register::Response& response);
  /// On topics.
  std::shared_ptr<Channel> open(const std::string& participant);
  /// On this computer. @throws std::runtime_error if no connection has that number
  Lockstep::Send sendTo(std::uint64_t connection) const;
  void answer(const swarmanoid_msgs::CommandFrame& message);
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  Lockstep& lockstep_;
  ros::CallbackQueue queue_;
  ros::NodeHandle own_;
  std::map<std::string, std::shared_ptr<Channel>> channels_;  // maps a participant to its channel
  swarmanoid_msgs::CommandFrame local_message_;               // used on the thread of local_
  std::unique_ptr<LocalParticipants> local_;
  ros::ServiceServer server_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
  ros::AsyncSpinner spinner_;
};

}  // namespace swarmanoid
