#include "controller_recorder.hpp"

#include <sstream>

#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_hosts/ros/frame_messages.hpp"
#include "swarmanoid_interface/contains.hpp"
#include "swarmanoid_interface/frame_parts.hpp"
#include "swarmanoid_space/lockstep/controller_frames.hpp"

namespace swarmanoid {
namespace {

/// Stamp of the tick that has just ended, not of the next one.
FrameStamp tickOf(const Space& space) { return {0, space.run, space.tick - 1}; }

Time timeOf(const Space& space) { return space.time - space.clocktick; }

ros::Time bagTimeOf(const Space& space) { return toRosTime(timeOf(space) + space.time_before_reset); }

std::string topicOf(const std::string& robot, const char* what) { return "/" + robot + "/controller/" + what; }

/// @return the reason for which the robot's controller failed in this tick
const std::string& failureOf(const std::string& robot, const Space& space) {
  static const std::string kUnknown = "failed";
  for (const Event& event : space.events) {
    if (event.kind == Event::Kind::kControllerFailed && event.entity == robot) {
      return event.text;
    }
  }
  return kUnknown;
}

}  // namespace

ControllerRecorder::ControllerRecorder(const std::string& robots, const Experiment* experiment) {
  std::istringstream words(robots);
  for (std::string word; words >> word;) {
    names_.push_back(word);
  }
  all_ = names_ == std::vector<std::string>{"all"};
  if (names_ == std::vector<std::string>{"none"}) {
    names_.clear();
  }
  if (experiment != nullptr) {
    chooseRobots(names_, "controllers of rosbag_recorder", *experiment);
  }
}

bool ControllerRecorder::isWanted(const std::string& robot) const { return all_ || contains(names_, robot); }

void ControllerRecorder::record(const Space& space, BagWriter& bag) {
  if (names_.empty()) {
    return;
  }
  for (const Row row : space.entities.order) {
    const ControllerState& controller = space.controllers[row];
    if (controller.status == StepStatus::kNothing || !isWanted(space.entities.name[row])) {
      continue;
    }
    Recorded& recorded = recorded_[space.entities.name[row]];
    const bool is_new = recorded.number != space.entities.number[row] || recorded.starts != controller.starts ||
                        recorded.registration.run != space.run;
    if (is_new) {
      start(space, row, recorded, bag);
    }
    writeTick(space, row, recorded, bag);
  }
}

void ControllerRecorder::start(const Space& space, Row row, Recorded& recorded, BagWriter& bag) {
  const ControllerState& controller = space.controllers[row];
  recorded.number = space.entities.number[row];
  recorded.starts = controller.starts;
  recorded.registration.run = space.run;
  recorded.registration.seed = space.seed;
  recorded.registration.clocktick = space.clocktick;
  recorded.registration.robots = {describeRobot(*space.robots[row], *controller.description)};
  swarmanoid_msgs::ControllerStart message;
  message.header.stamp = toRosTime(timeOf(space));
  toMessage(recorded.registration, 0, message);
  bag.writeLatched(topicOf(space.entities.name[row], "start"), bagTimeOf(space), message);
}

void ControllerRecorder::writeTick(const Space& space, Row row, const Recorded& recorded, BagWriter& bag) {
  const std::string& name = space.entities.name[row];
  const RemoteRobot& robot = recorded.registration.robots.front();
  sensors_.stamp = tickOf(space);
  sensors_.seed = space.seed;
  sensors_.time = timeOf(space);
  sensors_.clocktick = space.clocktick;
  sensors_.data.clear();
  ByteWriter sensors(sensors_.data);
  sensors.number(std::uint8_t{1});
  writeReadings(space, row, robot.sensors, sensors);

  const StepStatus status = space.controllers[row].status;
  commands_.stamp = sensors_.stamp;
  commands_.data.clear();
  ByteWriter commands(commands_.data);
  commands.number(static_cast<std::uint8_t>(status));
  if (status == StepStatus::kFailed) {
    commands.text(failureOf(name, space));
  } else {
    writeCommands(space, row, robot.actuators, commands);
    writeDebugValues(space.robots[row]->debugValues(), commands);
  }
  toMessage(sensors_, sensors_message_);
  toMessage(commands_, commands_message_);
  bag.write(topicOf(name, "sensors"), bagTimeOf(space), sensors_message_);
  bag.write(topicOf(name, "commands"), bagTimeOf(space), commands_message_);
}

}  // namespace swarmanoid
