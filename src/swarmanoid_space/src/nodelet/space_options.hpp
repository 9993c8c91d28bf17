/// The private parameters of the space nodelet.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_space/experiment_file/experiment.hpp"
#include "swarmanoid_space/lockstep/lockstep.hpp"
#include "swarmanoid_space/ros/transforms.hpp"

namespace ros {
class NodeHandle;
}

namespace swarmanoid {

struct SpaceOptions {
  std::string experiment;             ///< a file, or the name of an installed experiment
  std::optional<std::uint64_t> seed;  ///< instead of the file's
  std::optional<std::uint64_t> max_ticks;
  std::optional<double> real_time_factor;       ///< instead of the file's; 0: as fast as possible
  bool paused = false;                          ///< before the first tick
  std::string record;                           ///< the bag; "": none
  std::vector<std::string> record_controllers;  ///< robots whose controllers are in the bag; as device_topics
  bool record_state = false;                    ///< all named state is in the bag
  std::string hashes;                           ///< file of the state hash of every tick; "": none
  std::string folder;                           ///< where relative names begin; "": where the manager works
  std::string out;                              ///< folder of the files that are written, made if it is not there
  bool force = false;                           ///< files that are there already are replaced
  bool write_anywhere = false;                  ///< what the experiment file names may be outside `out`
  std::vector<Override> set;                    ///< instead of what the file says
  std::optional<TransformLevel> tf_level;       ///< nothing: by the number of robots
  double tf_rate = 100.0;                       ///< of /tf at most, wall time [Hz]; 0: every tick
  double markers_rate = 30.0;                   ///< of ~markers likewise
  double world_state_rate = 0.0;                ///< of ~world_state likewise
  double clock_rate = 1000.0;                   ///< of /clock at most, wall time [Hz]
  std::vector<std::string> device_topics;       ///< robots whose devices have topics; "all" alone: all of them
  bool stays_at_end = false;                    ///< false: the process is shut down when the run is over
  double timeout = 20.0;                        ///< for all parts to attach [s]
  double watchdog = 0.0;                        ///< for one call of users' code, wall time [s]; 0: any time
  Lockstep::Options lockstep;                   ///< how long participants may take
};

/// `exit_code`, the file that gets the exit code of the run when it is over; "": none. It is read by itself, for it is
/// of use even if another parameter is bad.
std::string readExitCodeFile(const ros::NodeHandle& own);

/// @throws ConfigError naming the parameter, what was found and what is allowed; unknown parameters too
SpaceOptions readSpaceOptions(const ros::NodeHandle& own);

/// The experiment with what the options change in it. @throws ConfigError
Experiment readExperiment(const SpaceOptions& options);

/// The robots that `device_topics` means, and those commanded over topics. @throws ConfigError for one that is none
std::vector<std::string> robotsWithTopics(const SpaceOptions& options, const Experiment& experiment);

}  // namespace swarmanoid
