/// The private parameters of the space nodelet.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_recording/messages/transforms.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"
#include "swarmanoid_space/lockstep/lockstep.hpp"

namespace ros {
class NodeHandle;
}

namespace swarmanoid {

struct SpaceOptions {
  std::string experiment;             ///< a file, or the name of an installed experiment
  std::optional<std::uint64_t> seed;  ///< instead of the file's
  std::optional<std::uint64_t> max_ticks;
  std::optional<double> real_time_factor;       ///< instead of the file's; 0: as fast as possible
  bool paused = false;                          ///< the run starts paused before the first tick
  std::string record;                           ///< the bag; "": none
  std::vector<std::string> record_controllers;  ///< robots whose controllers are in the bag; as device_topics
  bool record_state = false;                    ///< the bag contains all named state
  std::string hashes;                           ///< file of the state hash of every tick; "": none
  std::string save_interventions;               ///< file for the interventions in the run; "": none
  std::string interventions;                    ///< file of interventions to play into the run; "": none
  std::string folder;                           ///< start of relative names; "": the manager's working directory
  std::string out;                              ///< folder of the written files, made if it does not exist
  bool force = false;                           ///< existing files are replaced
  bool write_anywhere = false;                  ///< files that the experiment file names may be outside `out`
  std::vector<Override> set;                    ///< replace values of the file
  std::optional<TransformLevel> tf_level;       ///< nothing: depends on the number of robots
  double tf_rate = 100.0;                       ///< maximum rate of /tf, wall time [Hz]; 0: every tick
  double markers_rate = 30.0;                   ///< maximum rate of ~markers, wall time [Hz]; 0: every tick
  double world_state_rate = 0.0;                ///< maximum rate of ~world_state, wall time [Hz]; 0: every tick
  double clock_rate = 1000.0;                   ///< maximum rate of /clock, wall time [Hz]
  std::vector<std::string> device_topics;       ///< robots whose devices have topics; "all" alone: all of them
  std::vector<std::string> device_markers;      ///< robots whose devices are drawn, see chooseDrawnRobots
  bool stays_at_end = false;                    ///< false: the process is shut down when the run is finished
  double timeout = 20.0;                        ///< for all parts to attach [s]
  double watchdog = 0.0;                        ///< for one call of users' code, wall time [s]; 0: no limit
  Lockstep::Options lockstep;                   ///< timeouts and policy for participants
  OdometryFrames tf_odometry = OdometryFrames::kHidden;
};

/// Reads `exit_code`, the file to which the exit code of the run is written at its end; "": none. It is read
/// separately, because it is needed even if another parameter is wrong.
std::string readExitCodeFile(const ros::NodeHandle& own);

/// @throws ConfigError naming the parameter, the value found and the allowed values; also for unknown parameters
SpaceOptions readSpaceOptions(const ros::NodeHandle& own);

/// Reads the experiment with the changes of the options. @throws ConfigError
Experiment readExperiment(const SpaceOptions& options);

/// Returns the robots that `device_topics` names, and those commanded over topics. @throws ConfigError for a name that
/// is not a robot's
std::vector<std::string> robotsWithTopics(const SpaceOptions& options, const Experiment& experiment);

}  // namespace swarmanoid
