/// Messages with which the run of a bag can be repeated: the record of the run, and its result.
///
/// Threads  one at a time.
#pragma once

#include <swarmanoid_msgs/RunRecord.h>
#include <swarmanoid_msgs/RunResult.h>
#include <swarmanoid_msgs/WorldState.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "bag_writer.hpp"
#include "swarmanoid_recording/records/run_record.hpp"
#include "swarmanoid_space/observer.hpp"

namespace swarmanoid {

class RunMessages {
 public:
  RunMessages() = default;
  /// @param every ticks from one state hash in the bag to the next
  /// @throws ConfigError if a file that the experiment names cannot be read
  RunMessages(const RunContext& context, std::uint64_t every);

  /// Writes the record at the beginning of a run. @param topics "/space/" @throws std::runtime_error
  void begin(const Space& space, const std::string& topics, BagWriter& bag);
  /// Writes the result. @param last_state last recorded state @throws std::runtime_error
  void finish(const std::string& topics, const swarmanoid_msgs::WorldState& last_state, BagWriter& bag);

  /// Updates the result with the present state of the run. Allocates nothing.
  void follow(const Space& space);

 private:
  std::optional<RunRecord> record_;  // empty: the experiment is not known
  std::function<RunOutcome()> outcome_;
  std::optional<std::uint64_t> run_;   // the run whose record is in the bag
  swarmanoid_msgs::RunResult result_;  // of that run, up to its present state
  const Space* space_ = nullptr;       // space of the last follow(); the owner of the observer owns it, too
};

}  // namespace swarmanoid
