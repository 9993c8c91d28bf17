/// Reads a bag tick by tick, in the order of runs and ticks. Only a few ticks are in memory. One thread may use it at a
/// time.
#pragma once

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <swarmanoid_msgs/NamedState.h>
#include <swarmanoid_msgs/WorldState.h>

#include <memory>
#include <optional>
#include <string>

#include "recorded_tick.hpp"

namespace swarmanoid::diff {

/// The topic from which the state is read.
enum class StateSource {
  kNamedState,  ///< all fields
  kWorldState   ///< poses, twists, engines, grips, colours
};

class BagReader {
 public:
  /// @throws ConfigError if it cannot be read or has no state of a space
  explicit BagReader(const std::string& file);

  bool hasNamedState() const { return has_named_state_; }
  /// Selects the source. It is called before `next`.
  void choose(StateSource source) { source_ = source; }

  /// @return nothing at the end @throws ConfigError for a message of another version
  std::optional<RecordedTick> next();
  /// Returns the descriptions that have been read so far.
  const RobotDescriptions& robots() const { return robots_; }

 private:
  void read(const rosbag::MessageInstance& instance);
  RecordedTick& tickOf(std::uint64_t run, std::uint64_t finished_ticks);
  StateFields fieldsOf(const swarmanoid_msgs::NamedState& message);

  std::string file_;
  rosbag::Bag bag_;
  rosbag::View view_;
  rosbag::View::iterator position_;
  bool has_named_state_ = false;
  StateSource source_ = StateSource::kNamedState;
  RobotDescriptions robots_;
  std::map<TickKey, RecordedTick> waiting_;  // ticks wait until messages of later ticks are read
  std::shared_ptr<const std::vector<std::string>> names_;
};

}  // namespace swarmanoid::diff
