/// Runs a robot's controller over the robot's topics: it subscribes to the sensors, sends the actuators' commands each
/// period (RobotLoop decides when, and which commands in case of failures), and reports to /diagnostics each second.
///
/// Private parameters: `robots`, the name of one robot; `configuration`, described in robot_configuration.hpp;
/// `controller`, its label, and `library` if it is not loaded in this process yet, both only if the nodelet has no
/// label of its own.
///
/// A status of /diagnostics warns for the second in which periods were missed; the numbers in it cover the whole run.
///
/// In the robot's namespace it has the topics of the devices that the configuration lists, no others, and, for
/// recording the input and output of the controller: controller/start (latched), controller/sensors,
/// controller/commands (swarmanoid_msgs: ControllerStart, SensorFrame, CommandFrame), which cost nothing without
/// subscribers.
///
/// If it is the only nodelet in its process it takes over SIGINT, SIGTERM and `rosnode kill`, stops the robot safely,
/// and ends the process: with 2 for bad input, 3 if the controller failed, 4 if devices were missing at the start, else
/// 0.
///
/// Time     periods and time-outs use a steady clock; ROS time is used only in stamps.
/// Threads  it has one thread of its own, which does all the work.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "swarmanoid_hosts/period_clock.hpp"
#include "swarmanoid_hosts/robot_loop.hpp"

namespace swarmanoid {

struct DeviceTopic;

class RobotHost {
 public:
  /// @param own with the private parameters; @param label of the controller, or ""
  /// @throws std::exception for mistakes in the configuration, or from the controller's init
  RobotHost(const ros::NodeHandle& own, const std::string& label, bool is_standalone);
  /// Stops the robot safely, which may take some seconds.
  ~RobotHost();
  RobotHost(const RobotHost&) = delete;
  RobotHost& operator=(const RobotHost&) = delete;

 private:
  struct Output {
    const DeviceTopic* topic = nullptr;
    ros::Publisher publisher;
  };

  void connect();
  void receive(RobotLoop::Sensor& sensor, const std::string& problem);
  void run();
  void servePeriod(PeriodClock& clock);
  void publish();
  void publishFrames();
  void say();
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);
  void leave();

  ros::CallbackQueue queue_;
  ros::NodeHandle own_;
  ros::NodeHandle in_robot_;  ///< handle in the robot's namespace
  std::string name_;
  bool is_standalone_;
  RobotConfiguration configuration_;
  std::unique_ptr<RobotLoop> loop_;
  std::vector<ros::Subscriber> inputs_;
  std::vector<Output> outputs_;  ///< in the order of loop_->actuators()
  ros::Publisher start_;
  ros::Publisher sensors_;
  ros::Publisher commands_;
  diagnostic_updater::Updater diagnostics_;

  // the following members are used by the thread
  RobotLoop::State reported_state_ = RobotLoop::State::kWaiting;
  std::uint64_t missed_ = 0;  ///< count of missed periods
  std::uint64_t reported_missed_ = 0;
  Duration longest_{};  ///< longest work in a period since the last report
  Duration reported_{};
  Duration said_waiting_{};
  std::uint64_t refused_ = 0;  ///< count of messages that were not valid for their device

  std::atomic<bool> is_to_end_{false};
  std::thread thread_;
};

}  // namespace swarmanoid
