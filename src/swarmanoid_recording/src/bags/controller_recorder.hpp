/// Records the inputs and outputs of controllers, for `replay`: for each selected robot the topics controller/start,
/// controller/sensors and controller/commands in its namespace, one robot per frame, in session 0.
///
/// Each tick in which a controller answered, in this process or in another, has a pair of frames. A start precedes the
/// first of them and each restart of the controller. A tick has the stamp that the controller received.
#pragma once

#include <swarmanoid_msgs/CommandFrame.h>
#include <swarmanoid_msgs/ControllerStart.h>
#include <swarmanoid_msgs/SensorFrame.h>

#include <map>
#include <string>
#include <vector>

#include "bag_writer.hpp"
#include "swarmanoid_interface/frames.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

class ControllerRecorder {
 public:
  ControllerRecorder() = default;
  /// @param robots names separated by spaces, all, or none
  /// @param experiment of these robots; null: names are not checked
  /// @throws ConfigError for an unknown name
  ControllerRecorder(const std::string& robots, const Experiment* experiment);

  /// Records the tick that has just ended. @throws std::runtime_error for a device that no REGISTER_DEVICE describes
  void record(const Space& space, BagWriter& bag);

 private:
  struct Recorded {
    Registration registration;  // of this robot alone
    EntityNumber number = kNoEntity;
    std::uint32_t starts = 0;
  };

  bool isWanted(const std::string& robot) const;
  void start(const Space& space, Row row, Recorded& recorded, BagWriter& bag);
  void writeTick(const Space& space, Row row, const Recorded& recorded, BagWriter& bag);

  bool all_ = false;
  std::vector<std::string> names_;
  std::map<std::string, Recorded> recorded_;  // by robot
  SensorFrame sensors_;
  CommandFrame commands_;
  swarmanoid_msgs::SensorFrame sensors_message_;
  swarmanoid_msgs::CommandFrame commands_message_;
};

}  // namespace swarmanoid
