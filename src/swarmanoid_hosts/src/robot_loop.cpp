#include "swarmanoid_hosts/robot_loop.hpp"

#include <iomanip>
#include <stdexcept>

#include "swarmanoid_interface/frame_parts.hpp"
#include "swarmanoid_interface/plain_text.hpp"

namespace swarmanoid {
namespace {

const DeviceType* requireType(const RobotConfiguration::Device& device) {
  const DeviceType* type = findDeviceType(device.type);
  if (type == nullptr) {
    throw std::runtime_error("device '" + device.type + "' has no REGISTER_DEVICE, so no controller can be given it");
  }
  return type;
}

void append(std::string& text, const std::string& separator, const std::string& more) {
  text += (text.empty() ? "" : separator) + more;
}

}  // namespace

RobotLoop::RobotLoop(const std::string& robot, const std::string& label, RobotConfiguration configuration,
                     ControllerHost::Factory make, const Robot::LogSink& log, Duration now)
    : configuration_(std::move(configuration)),
      robot_(robot, configuration_.robot_type, configuration_.seed),
      began_(now) {
  RemoteRobot description{robot, configuration_.robot_type, label, label, {}, {}, configuration_.parameters};
  for (const RobotConfiguration::Device& device : configuration_.sensors) {
    const DeviceType* type = requireType(device);
    Sensor& sensor = sensors_.emplace_back(Sensor{device, type, {type->make(), {}}, {}});
    robot_.provideSensor(device.type, sensor.reading.data.get());
    description.sensors.push_back({device.type, type->layout, fieldNames(*type)});
  }
  for (const RobotConfiguration::Device& device : configuration_.actuators) {
    const DeviceType* type = requireType(device);
    actuators_.push_back(Actuator{device, type, {type->make(), {}}, {type->make(), {}}, false});
    description.actuators.push_back({device.type, type->layout, fieldNames(*type)});
  }
  registration_.seed = configuration_.seed;
  registration_.clocktick = configuration_.period;
  registration_.robots.push_back(std::move(description));
  host_ = std::make_unique<ControllerHost>(registration_, std::move(make), log);
  text_ = "waiting for " + missing(now);
}

bool RobotLoop::tick(Duration now, std::uint64_t passed) {
  has_stepped_ = false;
  if (state_ == State::kWaiting) {
    wait(now);
    passed = 1;
  }
  if (state_ == State::kRunning || state_ == State::kStopped) {
    run(now, passed);
  }
  if (state_ == State::kStopped || state_ == State::kEnding) {
    carryOnStopping(now);
    return true;
  }
  return state_ == State::kRunning;
}

void RobotLoop::wait(Duration now) {
  const std::string what = missing(now);
  text_ = "waiting for " + what;
  if (what.empty()) {
    state_ = State::kRunning;
  } else if (now - began_ >= configuration_.start_timeout) {
    state_ = State::kOver;
    end_ = End::kMissing;
    text_ = "missing: " + what;
  }
}

void RobotLoop::run(Duration now, std::uint64_t passed) {
  const std::string what = lost(now);
  if (what.empty()) {
    if (steps_ > 0) {
      constexpr std::uint64_t kStoodStill = 1;
      period_ += state_ == State::kStopped ? kStoodStill : passed;
    }
    state_ = State::kRunning;
    step(now);
    return;
  }
  if (state_ == State::kRunning) {
    ++stops_;
    beginStop(now, State::kStopped);
  }
  text_ = "stopped safely: " + what;
}

void RobotLoop::carryOnStopping(Duration now) {
  constexpr std::uint64_t kFewest = 3;  // allows the loss of one message
  const bool is_done = stop(now);
  ++stop_periods_;
  if (state_ == State::kEnding && is_done && stop_periods_ >= kFewest) {
    state_ = State::kOver;
    text_ = end_ == End::kAsked ? "ended" : text_;
  }
}

void RobotLoop::end(Duration now) {
  if (end_ != End::kNone) {
    return;
  }
  end_ = End::kAsked;
  if (steps_ == 0) {
    state_ = State::kOver;  // no command was ever given
    text_ = "ended";
  } else {
    // a stop under way continues: a descending eyebot does not hover again
    if (state_ != State::kStopped) {
      stop_began_ = now;
    }
    stop_periods_ = 0;
    state_ = State::kEnding;
    text_ = "ending: stops safely";
  }
}

/// Returns the devices that are missing at the start.
std::string RobotLoop::missing(Duration now) const {
  std::string what;
  for (const Sensor& sensor : sensors_) {
    if (isLost(sensor, now)) {
      append(what, "; ", sensor.device.type + " (nobody publishes " + sensor.device.topic + ")");
    }
  }
  for (const Actuator& actuator : actuators_) {
    if (!actuator.is_heard) {
      append(what, "; ", actuator.device.type + " (nobody subscribes to " + actuator.device.topic + ")");
    }
  }
  return what;
}

bool RobotLoop::isLost(const Sensor& sensor, Duration now) const {
  return !sensor.heard || now - *sensor.heard > configuration_.sensor_timeout;
}

std::string RobotLoop::lost(Duration now) const {
  std::string what;
  for (const Sensor& sensor : sensors_) {
    if (isLost(sensor, now)) {
      PlainTextStream text;
      text << " is silent for " << std::fixed << std::setprecision(2) << toSeconds(now - *sensor.heard) << " s";
      append(what, "; ", sensor.device.type + " (" + sensor.device.topic + ")" + text.str());
    }
  }
  return what;
}

void RobotLoop::step(Duration now) {
  makeFrame();
  has_stepped_ = true;
  ++steps_;
  text_ = "running";
  std::string failure;
  try {
    answer_ = &host_->answer(frame_);
    failure = readAnswer();
  } catch (const std::exception& error) {
    failure = error.what();
  }
  if (!failure.empty()) {
    end_ = End::kFailed;
    beginStop(now, State::kEnding);
    text_ = "the controller failed: " + failure;
  }
}

void RobotLoop::makeFrame() {
  const std::uint64_t before = frame_.stamp.tick;
  frame_.stamp = {registration_.session, registration_.run, period_};
  frame_.seed = registration_.seed;
  frame_.time = kEpoch + static_cast<Duration::rep>(period_) * configuration_.period;
  const std::uint64_t passed = steps_ == 0 ? 1 : period_ - before;
  frame_.clocktick = static_cast<Duration::rep>(passed) * configuration_.period;
  frame_.data.assign(1, std::uint8_t{1});  // the robot is present
  ByteWriter out(frame_.data);
  for (const Sensor& sensor : sensors_) {
    writeBlock(*sensor.type, sensor.reading.data.get(), out);
  }
}

std::string RobotLoop::readAnswer() {
  ByteReader in(answer_->data);
  if (static_cast<StepStatus>(in.number<std::uint8_t>()) != StepStatus::kStepped) {
    return in.text();
  }
  std::string failure;
  for (Actuator& actuator : actuators_) {
    readBlock(*actuator.type, in, actuator.received.data.get(), actuator.received.parts);
    if (!actuator.type->is_finite(actuator.received.data.get())) {
      append(failure, "; ", actuator.device.type + ": found a number that is not finite");
    } else {
      std::swap(actuator.command, actuator.received);  // the safe stop always starts from a valid command
    }
  }
  debug_values_ = readDebugValues(in);
  return failure;
}

void RobotLoop::beginStop(Duration now, State state) {
  state_ = state;
  stop_began_ = now;
  stop_periods_ = 0;
}

bool RobotLoop::stop(Duration now) {
  const SafeStopMoment moment{toSeconds(now - stop_began_), configuration_.safe_stop, robot_};
  bool is_done = true;
  for (Actuator& actuator : actuators_) {
    is_done = actuator.type->stop(actuator.command.data.get(), moment) && is_done;
  }
  return is_done;
}

}  // namespace swarmanoid
