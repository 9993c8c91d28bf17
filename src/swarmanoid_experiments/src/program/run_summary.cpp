#include "run_summary.hpp"

#include <cstdio>

namespace swarmanoid::program {

using nlohmann::ordered_json;

ordered_json summarise(const Simulation& simulation, bool finished, double wall_s, double robot_ticks) {
  const Space& space = simulation.space();
  ordered_json metrics = ordered_json::object();
  for (const auto& [name, value] : simulation.metrics()) {
    std::visit([&, &key = name](const auto& held) { metrics[key] = held; }, value);
  }
  ordered_json failures = ordered_json::array();
  for (const ControllerFailure& failure : simulation.failures()) {
    failures.push_back({{"robot", failure.robot}, {"tick", failure.tick}, {"reason", failure.reason}});
  }
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(simulation.stateHash()));

  ordered_json summary;
  summary["experiment"] = simulation.experiment().name;
  summary["seed"] = space.seed;
  summary["ticks"] = space.tick;
  summary["finished"] = finished;
  const std::optional<bool> success = simulation.success();
  summary["success"] = success ? ordered_json(*success) : ordered_json(nullptr);
  summary["metrics"] = metrics;
  summary["failed_controllers"] = failures;
  summary["wall_s"] = wall_s;
  const double simulated_s = toSeconds(space.time - kEpoch);
  summary["real_time_factor"] = wall_s > 0.0 ? simulated_s / wall_s : 0.0;
  summary["robot_ticks_per_s"] = wall_s > 0.0 ? robot_ticks / wall_s : 0.0;
  summary["state_hash"] = hash;
  return summary;
}

std::string toText(const ordered_json& summary) {
  // texts from controllers may be anything, the summary is UTF-8
  return summary.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace swarmanoid::program
