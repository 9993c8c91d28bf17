#include "swarmanoid_hosts/ros/robot_host.hpp"

#include <ros/ros.h>

#include <chrono>
#include <stdexcept>

#include "robot_parameters.hpp"
#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_hosts/ros/frame_messages.hpp"
#include "swarmanoid_hosts/ros/log.hpp"
#include "swarmanoid_hosts/ros/process.hpp"

namespace swarmanoid {
namespace {

using State = RobotLoop::State;

Duration now() { return std::chrono::steady_clock::now().time_since_epoch(); }

const DeviceTopic* topicOf(const RobotConfiguration::Device& device) {
  for (const DeviceTopic* topic : topicsOf(device.type)) {
    if (topic->name == device.topic) {
      return topic;
    }
  }
  throw std::logic_error(device.type + " has no topic " + device.topic);
}

}  // namespace

RobotHost::RobotHost(const ros::NodeHandle& own, const std::string& label, bool is_standalone)
    : own_(own),
      name_(readRobotName(own)),
      is_standalone_(is_standalone),
      diagnostics_(ros::NodeHandle(), own, "/" + name_) {
  const Registry::Entry& entry = findController(own, label);  // the library of the controller may define devices
  configuration_ = readRobotConfiguration(own);
  loop_ = std::make_unique<RobotLoop>(
      name_, entry.description.label, configuration_, [&entry] { return makePlugin<Controller>(entry); }, logRobot,
      now());
  in_robot_ = ros::NodeHandle(name_);
  in_robot_.setCallbackQueue(&queue_);
  diagnostics_.setHardwareID(name_);
  diagnostics_.add("controller", this, &RobotHost::report);
  connect();
  if (is_standalone_) {
    process::takeOverSignals();
  }
  thread_ = std::thread([this] { run(); });
}

RobotHost::~RobotHost() {
  is_to_end_ = true;
  thread_.join();
}

void RobotHost::connect() {
  for (RobotLoop::Sensor& sensor : loop_->sensors()) {
    const DeviceTopic* topic = topicOf(sensor.device);
    inputs_.push_back(topic->subscribe(in_robot_, *topic, sensor.reading.data.get(), sensor.reading.parts,
                                       [this, &sensor](const std::string& problem) { receive(sensor, problem); }));
  }
  for (const RobotLoop::Actuator& actuator : loop_->actuators()) {
    const DeviceTopic* topic = topicOf(actuator.device);
    outputs_.push_back({topic, topic->advertise(in_robot_, *topic)});
  }
  constexpr bool kLatched = true;
  constexpr std::uint32_t kQueue = 100;
  start_ = in_robot_.advertise<swarmanoid_msgs::ControllerStart>("controller/start", 1, kLatched);
  sensors_ = in_robot_.advertise<swarmanoid_msgs::SensorFrame>("controller/sensors", kQueue);
  commands_ = in_robot_.advertise<swarmanoid_msgs::CommandFrame>("controller/commands", kQueue);
  swarmanoid_msgs::ControllerStart message;
  toMessage(loop_->registration(), 0, message);
  message.header.stamp = toRosTime(kEpoch);  // the controller's time, as in its frames
  start_.publish(message);
}

void RobotHost::receive(RobotLoop::Sensor& sensor, const std::string& problem) {
  if (problem.empty()) {
    sensor.heard = now();
    return;
  }
  ++refused_;
  ROS_ERROR_THROTTLE(1.0, "%s: a message on %s is refused: %s", name_.c_str(), sensor.device.topic.c_str(),
                     problem.c_str());
}

void RobotHost::run() {
  PeriodClock clock(now(), configuration_.period);
  said_waiting_ = now();
  while (loop_->state() != State::kOver && ros::ok()) {
    const Duration left = clock.next() - now();
    if (left > Duration::zero()) {
      queue_.callAvailable(ros::WallDuration(toSeconds(left)));
    } else {
      servePeriod(clock);
    }
  }
  leave();
}

void RobotHost::servePeriod(PeriodClock& clock) {
  const Duration begin = now();
  const std::uint64_t passed = clock.begin(begin);
  if (passed > 1) {
    missed_ = clock.missed();
    ROS_WARN_THROTTLE(1.0, "%s: overrun: %lu period(s) of %.3f s left out, %lu so far", name_.c_str(), passed - 1,
                      toSeconds(configuration_.period), missed_);
  }
  queue_.callAvailable();  // handles the messages that arrived while the last step took too long
  std::size_t i = 0;
  for (RobotLoop::Actuator& actuator : loop_->actuators()) {
    actuator.is_heard = outputs_[i++].publisher.getNumSubscribers() > 0;
  }
  if (is_to_end_ || (is_standalone_ && process::isEndAskedFor())) {
    loop_->end(begin);
  }
  if (loop_->tick(now(), passed)) {
    publish();
  }
  publishFrames();
  say();
  const Duration end = now();
  longest_ = std::max(longest_, end - begin);
  if (end - reported_ >= std::chrono::seconds(1)) {
    diagnostics_.force_update();
    reported_ = end;
    longest_ = Duration::zero();
  }
}

void RobotHost::publish() {
  std_msgs::Header header;
  header.stamp = ros::Time::now();
  std::size_t i = 0;
  for (const RobotLoop::Actuator& actuator : loop_->actuators()) {
    const Output& output = outputs_[i++];
    output.topic->publish(output.publisher, *output.topic, actuator.command.data.get(), header);
  }
}

void RobotHost::publishFrames() {
  if (!loop_->hasStepped()) {
    return;
  }
  if (sensors_.getNumSubscribers() > 0) {
    swarmanoid_msgs::SensorFrame message;
    toMessage(loop_->sensorFrame(), message);
    sensors_.publish(message);
  }
  if (commands_.getNumSubscribers() > 0) {
    swarmanoid_msgs::CommandFrame message;
    toMessage(loop_->commandFrame(), message);
    commands_.publish(message);
  }
}

/// Writes to the log when the state changes, and while the robot is waiting.
void RobotHost::say() {
  const State state = loop_->state();
  const char* text = loop_->text().c_str();
  // by the steady clock: simulated time stands still until there is a simulation
  constexpr std::chrono::seconds kInterval{2};
  if (state == State::kWaiting && now() - said_waiting_ >= kInterval) {
    said_waiting_ = now();
    ROS_INFO("%s: %s", name_.c_str(), text);
  }
  if (state == reported_state_) {
    return;
  }
  if (state == State::kStopped) {
    ROS_ERROR("%s: %s", name_.c_str(), text);
  } else if (loop_->whyItEnds() == RobotLoop::End::kFailed || loop_->whyItEnds() == RobotLoop::End::kMissing) {
    ROS_FATAL_COND(reported_state_ != State::kEnding, "%s: %s", name_.c_str(), text);
  } else {
    ROS_INFO("%s: %s", name_.c_str(), text);
  }
  reported_state_ = state;
}

void RobotHost::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  const State state = loop_->state();
  const bool is_good = state == State::kRunning || loop_->whyItEnds() == RobotLoop::End::kAsked;
  status.summary(is_good                    ? DiagnosticStatus::OK
                 : state == State::kWaiting ? DiagnosticStatus::WARN
                                            : DiagnosticStatus::ERROR,
                 loop_->text());
  for (const RobotLoop::Actuator& actuator : loop_->actuators()) {
    if (state == State::kRunning && !actuator.is_heard) {
      status.mergeSummary(DiagnosticStatus::ERROR, "nobody subscribes to " + actuator.device.topic);
    }
  }
  if (missed_ > reported_missed_) {
    status.mergeSummary(DiagnosticStatus::WARN, "overruns");
    reported_missed_ = missed_;
  }
  status.add("rate [Hz]", 1.0 / toSeconds(configuration_.period));
  status.add("steps", loop_->steps());
  status.add("periods left out", missed_);
  status.add("longest period's work [s]", toSeconds(longest_));
  status.add("stops", loop_->stops());
  status.add("refused messages", refused_);
  for (const auto& [key, value] : loop_->debugValues()) {
    status.add("controller: " + key, value);
  }
}

void RobotHost::leave() {
  if (ros::ok()) {
    diagnostics_.force_update();
    constexpr double kOnTheWay = 0.1;  // [s] for the last messages
    ros::WallDuration(kOnTheWay).sleep();
  }
  const RobotLoop::End why = loop_->whyItEnds();
  inputs_.clear();
  loop_.reset();  // the controller is destroyed after its robot has stopped
  if (is_standalone_) {
    process::endWith(why == RobotLoop::End::kFailed    ? ExitCode::kControllerFailed
                     : why == RobotLoop::End::kMissing ? ExitCode::kStopped
                                                       : ExitCode::kFinished);
    ros::requestShutdown();
  }
}

}  // namespace swarmanoid
