#include "run_messages.hpp"

#include "swarmanoid_recording/messages/metric_text.hpp"
#include "swarmanoid_recording/messages/world_state.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"
#include "swarmanoid_space/suite_version.hpp"

namespace swarmanoid {

RunMessages::RunMessages(const RunContext& context, std::uint64_t every) : outcome_(context.outcome) {
  if (context.experiment != nullptr && !context.experiment->text.empty() && !context.is_fork) {
    record_ = recordOf(*context.experiment, suiteVersion());
    record_->every = every;
    record_->is_open = context.is_open;
    result_.experiment = record_->experiment;
  }
}

void RunMessages::begin(const Space& space, const std::string& topics, BagWriter& bag) {
  if (!record_ || run_ == space.run) {
    return;
  }
  run_ = space.run;
  record_->seed = space.seed;  // a reset may change the seed
  swarmanoid_msgs::RunRecord message;
  message.header = headerOf(space);
  message.run = space.run;
  for (const RecordedFile& file : documentsOf(*record_)) {
    swarmanoid_msgs::RecordedFile part;
    part.name = file.name;
    part.content.assign(file.content.begin(), file.content.end());
    message.files.push_back(std::move(part));
  }
  bag.writeLatched(topics + "record", message.header.stamp, message);
}

void RunMessages::follow(const Space& space) {
  result_.header.stamp = stampOf(space);
  result_.ticks = space.tick;
  result_.run = space.run;
  result_.seed = space.seed;
  space_ = &space;
}

void RunMessages::finish(const std::string& topics, const swarmanoid_msgs::WorldState& last_state, BagWriter& bag) {
  if (!outcome_ || !run_) {
    return;
  }
  const RunOutcome outcome = outcome_();
  result_.finished = outcome.is_finished;
  result_.judged = outcome.success.has_value();
  result_.success = outcome.success.value_or(false);
  result_.failed_robots = outcome.failed_robots;
  const bool is_last = last_state.tick == result_.ticks && last_state.run == result_.run;
  result_.state_hash = is_last ? last_state.state_hash : stateHash(*space_);
  result_.metrics = toMessages(outcome.metrics);
  bag.writeLatched(topics + "result", result_.header.stamp, result_);
}

}  // namespace swarmanoid
