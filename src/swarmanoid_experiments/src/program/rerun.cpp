#include "rerun.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "swarmanoid_experiment_files/override_text.hpp"
#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_interface/process/user_code.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid::program {
namespace {

constexpr const char* kWhatCanChange =
    "allowed in the middle of a run: framework.maxclock, engines.ENGINE.PARAMETER of a parameter that may change while "
    "it runs, arena.ENTITY.PROPERTY, arena.ROBOT.controller.source";

[[noreturn]] void refuse(const Override& setting, const std::string& problem) {
  throw ConfigError({"--set " + setting.path, 0}, problem + ", " + kWhatCanChange);
}

std::vector<std::string> wordsOf(const std::string& path) {
  std::vector<std::string> words{""};
  for (const char c : path) {
    if (c == '.') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

/// A parameter that cannot change during a run is rejected before the run starts.
SetEngineParameters engineParameter(const Override& setting, const std::vector<std::string>& words,
                                    const Experiment& experiment) {
  const auto engine = std::find_if(experiment.engines.begin(), experiment.engines.end(),
                                   [&](const EngineDescription& candidate) { return candidate.id == words[1]; });
  if (engine == experiment.engines.end()) {
    refuse(setting, "found no engine '" + words[1] + "'");
  }
  const Registry::Entry& entry = Registry::instance().require(PluginKind::kEngine, engine->label);
  const auto parameter =
      std::find_if(entry.description.parameters.begin(), entry.description.parameters.end(),
                   [&](const Parameter& candidate) { return candidate.name == words[2] && candidate.is_live; });
  if (parameter == entry.description.parameters.end()) {
    refuse(setting, "found '" + words[2] + "', which is no parameter of " + engine->label + " that may change");
  }
  if (parameter->type == Parameter::Type::kNumber) {
    parseNumber(setting.value, words[2], {"--set " + setting.path, 0}, parameter->range);
  }
  return {words[1], {{words[2], setting.value}}};
}

SetCommandSource commandSource(const Override& setting, const std::string& robot) {
  const auto source = parseCommandSource(setting.value);
  if (!source || isOfOthers(*source)) {
    throw ConfigError({"--set " + setting.path, 0}, "found '" + setting.value + "', allowed: controller, none");
  }
  return {robot, *source};
}

std::uint64_t maxClock(const Override& setting) {
  return static_cast<std::uint64_t>(
      parseInteger(setting.value, "maxclock", {"--set " + setting.path, 0}, limits::kTicks));
}

/// The name that diff uses.
std::string nameOfTick(std::uint64_t finished_ticks) {
  return finished_ticks == 0 ? "before the first tick" : "tick " + std::to_string(finished_ticks - 1);
}

/// @param compared number of compared states @param last one of them, in finished ticks
std::string describeEqual(std::uint64_t compared, std::uint64_t last, std::uint64_t every) {
  if (last == 0) {
    return "the state before the first tick is that of the recorded run";
  }
  if (every == 1) {
    return "each of " + std::to_string(last) + " ticks has the state of the recorded run";
  }
  return std::to_string(compared) + " states, one in " + std::to_string(every) + " ticks and the last after " +
         std::to_string(last) + ", are those of the recorded run";
}

enum class Advance { kReached, kOver, kInterrupted };

/// Runs ticks until that many are finished.
Advance advance(Simulation& simulation, std::uint64_t ticks, const std::function<bool()>& after_tick) {
  while (simulation.space().tick < ticks) {
    if (simulation.isFinished()) {
      return Advance::kOver;
    }
    simulation.tick();
    if (!after_tick() && simulation.space().tick < ticks) {
      return Advance::kInterrupted;
    }
  }
  return Advance::kReached;
}

}  // namespace

Fork parseFork(const std::vector<std::string>& settings, std::optional<std::uint64_t> seed,
               const Experiment& experiment) {
  Fork fork;
  fork.seed = seed;
  for (const std::string& text : settings) {
    const Override setting = parseOverride(text, "--set");
    const std::vector<std::string> words = wordsOf(setting.path);
    if (setting.path == "framework.maxclock") {
      fork.max_clock = maxClock(setting);
    } else if (words.size() == 3 && words[0] == "engines") {
      fork.changes.emplace_back("--set " + setting.path, engineParameter(setting, words, experiment));
    } else if (words.size() == 4 && words[0] == "arena" && words[2] == "controller" && words[3] == "source") {
      fork.changes.emplace_back("--set " + setting.path, commandSource(setting, words[1]));
    } else if (words.size() == 3 && words[0] == "arena") {
      fork.changes.emplace_back("--set " + setting.path, SetProperty{words[1], words[2], setting.value});
    } else {
      refuse(setting, "found a value that is read when a run begins");
    }
  }
  return fork;
}

void part(Simulation& simulation, const Fork& fork) {
  if (fork.seed) {
    simulation.reseed(*fork.seed);
  }
  for (const auto& [option, change] : fork.changes) {
    try {
      simulation.apply(change);
    } catch (const ConfigError& error) {
      throw ConfigError({option, 0}, std::string(error.what()) + "; " + kWhatCanChange);
    }
  }
}

void refuseOtherResult(const RecordedRun& run) {
  if (!run.hasResult()) {
    return;
  }
  const std::string file = (std::filesystem::path(run.folder) / record_files::kResult).string();
  const auto result = nlohmann::json::parse(run.result, nullptr, false);
  if (!result.is_object() || !result.contains("ticks") || !result["ticks"].is_number_unsigned()) {
    throw ConfigError({file, 0}, "found no JSON object with 'ticks', allowed: the summary of the run");
  }
  // the call that ended the run may have been in the middle of a tick
  const auto ticks = result["ticks"].get<std::uint64_t>();
  if (ticks < run.ticks() || ticks > run.ticks() + run.record.every) {
    throw ConfigError({(std::filesystem::path(run.folder) / record_files::kHashes).string(), 0},
                      "found state hashes up to tick " + std::to_string(run.ticks()) + ", allowed: up to tick " +
                          std::to_string(ticks) + ", as " + record_files::kResult + " has it");
  }
}

Verdict compareTicks(Simulation& simulation, const RecordedRun& run, std::uint64_t until,
                     const std::function<bool()>& after_tick) {
  std::string stopped;
  std::uint64_t compared = 0;
  std::uint64_t last = 0;
  simulation.start();
  for (const RecordedHash& recorded : run.hashes) {
    if (recorded.tick > until) {
      break;
    }
    try {
      if (const Advance way = advance(simulation, recorded.tick, after_tick); way != Advance::kReached) {
        const bool is_over = way == Advance::kOver;
        const std::string made = std::to_string(simulation.space().tick);
        return {false, !is_over,
                is_over ? "first difference: the run ends after " + made + " ticks, the recorded one has " +
                              std::to_string(run.ticks())
                        : "interrupted after " + made + " ticks, which have the states of the recorded run"};
      }
    } catch (...) {
      // a rule that throws does so after the tick is over and its state is recorded
      if (simulation.space().tick != recorded.tick || recorded.tick != run.ticks()) {
        throw;
      }
      stopped = "; both are stopped there: " + describeException();
    }
    if (const std::uint64_t hash = simulation.stateHash(); hash != recorded.hash) {
      return {false, false,
              "first difference: " + nameOfTick(recorded.tick) + ", state hash " + hashText(recorded.hash) + " | " +
                  hashText(hash)};
    }
    ++compared;
    last = recorded.tick;
  }
  if (const Advance way = advance(simulation, until, after_tick); way != Advance::kReached) {
    return {false, way == Advance::kInterrupted, "ended after " + std::to_string(simulation.space().tick) + " ticks"};
  }
  return {true, false, describeEqual(compared, last, run.record.every) + stopped};
}

}  // namespace swarmanoid::program
