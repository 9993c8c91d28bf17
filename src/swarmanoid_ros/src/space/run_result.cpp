#include "run_result.hpp"

#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_interface/process/math_library.hpp"
#include "swarmanoid_recording/messages/metric_text.hpp"

namespace swarmanoid {
swarmanoid_msgs::RunResult toMessage(const RunResult& result, const std_msgs::Header& header) {
  swarmanoid_msgs::RunResult message;
  message.header = header;
  message.experiment = result.experiment;
  message.seed = result.seed;
  message.ticks = result.ticks;
  message.run = result.run;
  message.finished = result.finished;
  message.message = result.message;
  message.judged = result.success.has_value();
  message.success = result.success.value_or(false);
  message.state_hash = result.state_hash;
  message.wall_s = result.wall_s;
  message.metrics = toMessages(result.metrics);
  for (const ControllerFailure& failure : result.failures) {
    message.failed_robots.push_back(failure.robot);
  }
  return message;
}

std::string describe(const RunResult& result) {
  PlainTextStream text;
  text << result.experiment << ", seed " << result.seed << ": " << (result.finished ? "finished" : "stopped")
       << " after " << result.ticks << " ticks in " << result.wall_s << " s";
  if (!result.message.empty()) {
    text << " (" << result.message << ")";
  }
  if (result.success) {
    text << "; " << (*result.success ? "success" : "no success");
  }
  for (const auto& [name, value] : result.metrics) {
    text << "; " << name << " = " << metricText(value);
  }
  for (const ControllerFailure& failure : result.failures) {
    text << "; the controller of " << failure.robot << " failed";
  }
  if (!isMathLibraryFixed()) {
    text << "; calculated with " << mathLibrary();
  }
  return text.str();
}

}  // namespace swarmanoid
