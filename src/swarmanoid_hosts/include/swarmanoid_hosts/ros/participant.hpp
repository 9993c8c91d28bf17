/// A process that runs the controllers of a space's robots elsewhere: it registers with the space, answers each sensor
/// frame with a command frame, and ends its process when the space has ended or refuses it.
///
/// Private parameters: `robots`, names separated by spaces; `space`, the space's node (/space); `timeout` [s] and
/// `policy`, see swarmanoid_msgs/Register (the space's); `parameters`, which the controller reads instead of the
/// `<parameters>` of the experiment file; `library` of a controller that is not loaded in this process yet;
/// `use_topics` (false): frames use the topics of the participant even if the space is on this computer; by default
/// they then use a socket.
///
/// If it is the only nodelet in its process, the exit code is 0 when the space has ended, 4 when the space refuses it.
///
/// Time     it uses wall time only; ROS time may stand still.
/// Threads  it has a thread of its own, on which the controllers step.
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "swarmanoid_hosts/controller_host.hpp"
#include "swarmanoid_hosts/packet_socket.hpp"
#include "swarmanoid_hosts/ros/frame_messages.hpp"
#include "swarmanoid_hosts/ros/parameter_reader.hpp"

namespace swarmanoid {

class Participant {
 public:
  /// The private parameters that only a participant reads.
  struct Options {
    std::vector<std::string> robots;
    std::string space = "/space";
    double timeout = 0.0;  ///< [s] of wall time; 0: the space's
    std::string policy;    ///< "": the space's
    bool uses_topics = false;
  };
  /// @throws ConfigError
  static Options readOptions(ParameterReader& reader);

  /// @param own with the private parameters; @param name of the participant, without a leading slash
  /// @param label of the controller; "": that of the first robot in the experiment file
  Participant(const ros::NodeHandle& own, Options options, std::string name, std::string label, bool is_standalone);
  ~Participant();
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

 private:
  void run();
  /// @return false if the process ends meanwhile @throws std::runtime_error if the space refuses
  bool registerWithSpace(swarmanoid_msgs::Register::Response& response);
  Registration adapt(Registration registration);
  /// Connects to the socket of the space, if that is on this computer. @return the connection's number in the space; 0:
  /// frames use topics
  std::uint64_t connect();
  /// Answer frames until the space is gone.
  void answerMessages();
  void answerPackets();
  /// @return whether the frame is for this registration, and commands_message_ answers it
  bool answer(const swarmanoid_msgs::SensorFrame& message);
  bool isOver() const { return is_over_ || !ros::ok(); }

  ros::CallbackQueue queue_;
  ros::NodeHandle own_;
  Options options_;
  std::string name_;
  std::string label_;
  bool is_standalone_;
  std::uint64_t session_ = 0;
  std::unique_ptr<ControllerHost> host_;
  PacketSocket socket_;
  swarmanoid_msgs::CommandFrame commands_message_;
  std::atomic<bool> is_over_{false};
  std::thread thread_;
};

}  // namespace swarmanoid
