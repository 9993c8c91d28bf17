#include "swarmanoid_hosts/controller_host.hpp"

#include <stdexcept>

#include "swarmanoid_interface/frame_parts.hpp"
#include "swarmanoid_interface/step_controller.hpp"

namespace swarmanoid {
namespace {

const DeviceType* requireType(const DeviceLayout& device, const std::string& robot) {
  const DeviceType* type = findDeviceType(device.type);
  const std::string title = "device '" + device.type + "' of robot '" + robot + "'";
  if (type == nullptr) {
    std::vector<std::string> known;
    for (const DeviceType* candidate : deviceTypes()) {
      known.push_back(candidate->type);
    }
    throw std::runtime_error(title + " is not registered in this process, so its bytes cannot be read; there are: " +
                             joinNames(known) + didYouMean(device.type, known));
  }
  if (type->layout != device.layout) {
    throw std::runtime_error(title + " has the fields '" + device.layout + "' in the space, and '" + type->layout +
                             "' here; build both from the same version");
  }
  if (!device.names.empty() && fieldNames(*type) != device.names) {  // such as two swapped fields of one type
    throw std::runtime_error(title + " has the fields '" + device.names + "' in the space, and '" + fieldNames(*type) +
                             "' here; build both from the same version");
  }
  return type;
}

}  // namespace

ControllerHost::ControllerHost(Registration registration, Factory make, Robot::LogSink log)
    : registration_(std::move(registration)),
      make_(std::move(make)),
      log_(std::move(log)),
      run_(registration_.run),
      seed_(registration_.seed),
      hosted_(registration_.robots.size()) {
  for (std::size_t i = 0; i < hosted_.size(); ++i) {
    const RemoteRobot& description = registration_.robots[i];
    hosted_[i].part = controllerPart(description.controller, description.label);
    for (const DeviceLayout& device : description.sensors) {
      hosted_[i].sensors.push_back({requireType(device, description.name), nullptr, {}});
    }
    for (const DeviceLayout& device : description.actuators) {
      hosted_[i].actuators.push_back({requireType(device, description.name), nullptr, {}});
    }
    give(hosted_[i], description);
  }
}

ControllerHost::~ControllerHost() {
  for (Hosted& hosted : hosted_) {
    take(hosted);
  }
}

void ControllerHost::give(Hosted& hosted, const RemoteRobot& description) {
  take(hosted);
  auto robot = std::make_unique<Robot>(description.name, description.type, seed_);
  robot->setLogSink(log_);
  for (Device& device : hosted.sensors) {
    device.data = device.type->make();
    robot->provideSensor(device.type->type, device.data.get());
  }
  for (Device& device : hosted.actuators) {
    device.data = device.type->make();
    robot->provideActuator(device.type->type, device.data.get());
  }
  hosted.controller = startController(make_, hosted.part, *robot, description.parameters);
  hosted.step = {"step", hosted.part, robot->name()};
  hosted.robot = std::move(robot);
}

void ControllerHost::take(Hosted& hosted) {
  const std::string failure =
      hosted.robot == nullptr ? "" : endController(hosted.controller, hosted.part, *hosted.robot);
  if (!failure.empty() && log_) {
    log_(LogLevel::kError, hosted.robot->name(), "controller failed: " + failure);
  }
  hosted.robot.reset();
  hosted.failure.clear();
}

const CommandFrame& ControllerHost::answer(const SensorFrame& frame) {
  if (has_answered_ && frame.stamp == answer_.stamp) {
    return answer_;
  }
  if (frame.stamp.run != run_ || frame.seed != seed_) {
    run_ = frame.stamp.run;
    seed_ = frame.seed;
    for (Hosted& hosted : hosted_) {
      take(hosted);
    }
  }
  read(frame);
  answer_.stamp = frame.stamp;
  answer_.data.clear();
  ByteWriter out(answer_.data);
  for (Hosted& hosted : hosted_) {
    if (hosted.is_present && hosted.failure.empty()) {
      stepController(*hosted.controller, hosted.step, *hosted.robot, frame.stamp.tick, frame.time, frame.clocktick,
                     hosted.failure);
    }
    write(hosted, out);
  }
  has_answered_ = true;
  return answer_;
}

void ControllerHost::read(const SensorFrame& frame) {
  ByteReader in(frame.data);
  for (std::size_t i = 0; i < hosted_.size(); ++i) {
    Hosted& hosted = hosted_[i];
    hosted.is_present = in.number<std::uint8_t>() != 0;
    if (!hosted.is_present) {
      take(hosted);
      continue;
    }
    if (hosted.robot == nullptr && hosted.failure.empty()) {
      try {
        give(hosted, registration_.robots[i]);
      } catch (const std::exception& error) {
        take(hosted);
        hosted.failure = std::string("does not start: ") + error.what();
      }
    }
    for (Device& device : hosted.sensors) {
      try {
        if (hosted.failure.empty()) {
          readBlock(*device.type, in, device.data.get(), device.parts);
        } else {
          in.block();
        }
      } catch (const ByteError& error) {
        throw ByteError(registration_.robots[i].name + ", " + device.type->type + ": " + error.what());
      }
    }
  }
}

void ControllerHost::write(const Hosted& hosted, ByteWriter& out) const {
  const StepStatus status = !hosted.is_present        ? StepStatus::kNothing
                            : !hosted.failure.empty() ? StepStatus::kFailed
                                                      : StepStatus::kStepped;
  out.number(static_cast<std::uint8_t>(status));
  if (status == StepStatus::kFailed) {
    out.text(hosted.failure);
  }
  if (status != StepStatus::kStepped) {
    return;
  }
  for (const Device& device : hosted.actuators) {
    writeBlock(*device.type, device.data.get(), out);
  }
  writeDebugValues(hosted.robot->debugValues(), out);
}

}  // namespace swarmanoid
