#include "run_result.hpp"

#include <sstream>
#include <type_traits>

#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_interface/process/math_library.hpp"
#include "swarmanoid_space/ros/world_state.hpp"

namespace swarmanoid {
namespace {

std::string toText(const Metrics::mapped_type& value) {
  PlainTextStream text;
  text.precision(17);
  std::visit([&](const auto& held) { text << std::boolalpha << held; }, value);
  return text.str();
}

}  // namespace

swarmanoid_msgs::RunResult runResult(const Simulation& simulation, bool finished, const std::string& message,
                                     double wall_s) {
  const Space& space = simulation.space();
  swarmanoid_msgs::RunResult result;
  result.header = headerOf(space);
  result.experiment = simulation.experiment().name;
  result.seed = space.seed;
  result.ticks = space.tick;
  result.run = space.run;
  result.finished = finished;
  result.message = message;
  result.judged = simulation.success().has_value();
  result.success = simulation.success().value_or(false);
  result.state_hash = simulation.stateHash();
  result.wall_s = wall_s;
  for (const auto& [name, value] : simulation.metrics()) {
    swarmanoid_msgs::TextParameter metric;
    metric.name = name;
    metric.value = toText(value);
    result.metrics.push_back(metric);
  }
  for (const ControllerFailure& failure : simulation.failures()) {
    result.failed_robots.push_back(failure.robot);
  }
  return result;
}

std::string describe(const swarmanoid_msgs::RunResult& result) {
  PlainTextStream text;
  text << result.experiment << ", seed " << result.seed << ": " << (result.finished ? "finished" : "stopped")
       << " after " << result.ticks << " ticks in " << result.wall_s << " s";
  if (!result.message.empty()) {
    text << " (" << result.message << ")";
  }
  if (result.judged) {
    text << "; " << (result.success ? "success" : "no success");
  }
  for (const auto& metric : result.metrics) {
    text << "; " << metric.name << " = " << metric.value;
  }
  for (const std::string& robot : result.failed_robots) {
    text << "; the controller of " << robot << " failed";
  }
  if (!isMathLibraryFixed()) {
    text << "; calculated with " << mathLibrary();
  }
  return text.str();
}

}  // namespace swarmanoid
