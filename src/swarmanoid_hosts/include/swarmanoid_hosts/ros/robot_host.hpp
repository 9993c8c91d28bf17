/// Runs a robot's controller over the robot's topics: hears its sensors, sends its actuators' commands each period
/// (RobotLoop says when, and what when something is wrong), and reports to /diagnostics each second.
///
/// Private parameters: `robots`, the name of one robot; `configuration`, what robot_configuration.hpp says;
/// `controller`, its label, and `library` if it is not in this process yet, both only where the nodelet has no label of
/// its own.
///
/// A status of /diagnostics warns for the second in which periods were missed; the numbers in it are of the whole time.
///
/// In the robot's namespace it has the topics of the devices that the configuration lists, no others, and, for whoever
/// wants to record what the controller saw and did: controller/start (latched), controller/sensors, controller/commands
/// (swarmanoid_msgs: ControllerStart, SensorFrame, CommandFrame), which cost nothing without subscribers.
///
/// Alone in its process it takes over SIGINT, SIGTERM and `rosnode kill`, stops the robot safely, and ends the process:
/// with 2 for bad input, 3 if the controller failed, 4 if devices were missing at the start, else 0.
///
/// Time     periods and time-outs go by a steady clock; ROS time is only in stamps.
/// Threads  one of its own, on which everything is done.
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
  /// @throws std::exception what is wrong with the configuration, or what the controller does not like
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
  ros::NodeHandle in_robot_;  ///< its namespace
  std::string name_;
  bool is_standalone_;
  RobotConfiguration configuration_;
  std::unique_ptr<RobotLoop> loop_;
  std::vector<ros::Subscriber> inputs_;
  std::vector<Output> outputs_;  ///< as loop_->actuators()
  ros::Publisher start_;
  ros::Publisher sensors_;
  ros::Publisher commands_;
  diagnostic_updater::Updater diagnostics_;

  // of the thread
  RobotLoop::State reported_state_ = RobotLoop::State::kWaiting;
  std::uint64_t missed_ = 0;  ///< periods
  std::uint64_t reported_missed_ = 0;
  Duration longest_{};  ///< work in a period since the last report
  Duration reported_{};
  std::uint64_t refused_ = 0;  ///< messages that were no such device

  std::atomic<bool> is_to_end_{false};
  std::thread thread_;
};

}  // namespace swarmanoid
