#include "run_summary.hpp"

#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_interface/process/math_library.hpp"
#include "swarmanoid_space/suite_version.hpp"

namespace swarmanoid::program {

using nlohmann::ordered_json;

namespace {

/// Returns the number of truncated readings for each type of device, and of affected robots.
ordered_json overflowsOf(const RunResult& result) {
  ordered_json overflows = ordered_json::object();
  for (const Overflow& overflow : result.overflows) {
    ordered_json& device = overflows[overflow.device];
    if (device.is_null()) {
      device = {{"robots", std::uint64_t{0}}, {"readings", std::uint64_t{0}}};
    }
    device["robots"] = device["robots"].get<std::uint64_t>() + 1;
    device["readings"] = device["readings"].get<std::uint64_t>() + overflow.readings;
  }
  return overflows;
}

}  // namespace

ordered_json summarise(const RunResult& result, const RunFacts& facts) {
  ordered_json metrics = ordered_json::object();
  for (const auto& [name, value] : result.metrics) {
    std::visit([&, &key = name](const auto& held) { metrics[key] = held; }, value);
  }
  ordered_json failures = ordered_json::array();
  for (const ControllerFailure& failure : result.failures) {
    failures.push_back({{"robot", failure.robot}, {"tick", failure.tick}, {"reason", failure.reason}});
  }

  ordered_json summary;
  summary["version"] = suiteVersion();
  summary["math_library"] = mathLibrary();
  summary["experiment"] = result.experiment;
  summary["overrides"] = facts.overrides;
  summary["seed"] = result.seed;
  summary["ticks"] = result.ticks;
  summary["finished"] = result.finished;
  summary["success"] = result.success ? ordered_json(*result.success) : ordered_json(nullptr);
  summary["metrics"] = metrics;
  summary["failed_controllers"] = failures;
  summary["overflows"] = overflowsOf(result);
  summary["wall_s"] = result.wall_s;
  summary["real_time_factor"] = result.wall_s > 0.0 ? result.simulated_s / result.wall_s : 0.0;
  summary["robot_ticks_per_s"] = result.wall_s > 0.0 ? facts.robot_ticks / result.wall_s : 0.0;
  summary["state_hash"] = hashText(result.state_hash);
  return summary;
}

std::string toText(const ordered_json& summary) {
  // texts from controllers may contain any bytes, but the summary is UTF-8
  return summary.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace swarmanoid::program
