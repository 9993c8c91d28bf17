// `swarmanoid rerun`.
#include <chrono>
#include <iostream>
#include <memory>

#include "../command_line_observers.hpp"
#include "../commands.hpp"
#include "../experiment_options.hpp"
#include "../output/run_summary.hpp"
#include "../output/standard_output.hpp"
#include "../processes/interruption.hpp"
#include "../processes/recorded_bag.hpp"
#include "../rerun.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/process/user_code_watch.hpp"
#include "swarmanoid_recording/output/run_files.hpp"
#include "swarmanoid_space/suite_version.hpp"

namespace swarmanoid::program {
namespace {

struct RerunOptions {
  std::string run;
  std::optional<std::uint64_t> number;
  std::optional<std::uint64_t> until;
  std::vector<std::string> settings;
  std::optional<std::uint64_t> seed;
  std::optional<int> threads;
  std::string out;
  bool force = false;
  bool write_anywhere = false;
  std::optional<std::string> bag;
  bool record_state = false;
  std::optional<std::string> hashes;
  std::optional<std::string> save_interventions;
};

void warn(const std::string& text) { std::cerr << "swarmanoid: warning: " << text << '\n'; }

/// Commands from other processes are not in the record.
void refuseRobotsOfOthers(const std::vector<std::string>& robots, const std::string& run) {
  if (!robots.empty()) {
    throw ConfigError({run, 0}, "found robots that other processes commanded (" + joinNames(robots) +
                                    "), whose commands are not in the record; allowed: robots with controllers in the "
                                    "simulator's process");
  }
}

std::uint64_t readUntil(const RerunOptions& options, const RecordedRun& run) {
  if (options.until && *options.until > run.ticks()) {
    throw ConfigError({"--until", 0}, "found " + std::to_string(*options.until) + ", allowed: from 0 to " +
                                          std::to_string(run.ticks()) + ", where the record ends");
  }
  if (!options.until && (options.seed || !options.settings.empty())) {
    throw ConfigError({options.seed ? "--seed" : "--set", 0},
                      "found no --until, allowed: --until TICK, from which on it holds");
  }
  return options.until.value_or(run.ticks());
}

/// Extends or shortens the run as the fork requests. @throws ConfigError
void changeLength(Experiment& experiment, const Fork& fork, std::uint64_t until) {
  if (fork.max_clock && *fork.max_clock < until) {
    throw ConfigError({"--set framework.maxclock", 0}, "found " + std::to_string(*fork.max_clock) + ", allowed: from " +
                                                           std::to_string(until) + " on, which --until says");
  }
  experiment.framework.max_clock = fork.max_clock.value_or(experiment.framework.max_clock);
}

void addRecorders(Simulation& simulation, const RunContext& context, const RerunOptions& options) {
  if (options.hashes) {
    addFromCommandLine(simulation, context, "--hashes", "hash_recorder", *options.hashes);
  }
  if (options.bag) {
    addFromCommandLine(simulation, context, "--bag", "rosbag_recorder", *options.bag,
                       {{"state", options.record_state ? "true" : "false"}});
  }
  if (options.save_interventions) {
    addFromCommandLine(simulation, context, "--save-interventions", "intervention_recorder",
                       *options.save_interventions);
  }
}

/// @return false if a file is incomplete; the reason is printed
bool finish(Simulation& simulation) {
  try {
    simulation.finish();
    return true;
  } catch (...) {
    std::cerr << "swarmanoid: " << describeException() << '\n';
    return false;
  }
}

/// Continues from the fork, and prints the summary.
ExitCode runFork(Simulation& simulation, const Fork& fork, RunFacts& facts, const std::function<bool()>& after_tick) {
  ExitCode code = ExitCode::kFinished;
  const auto start = std::chrono::steady_clock::now();
  RunEnd run_end;
  try {
    part(simulation, fork);
    while (!simulation.isFinished() && !isInterrupted()) {
      simulation.tick();
      after_tick();
    }
  } catch (...) {
    std::cerr << "swarmanoid: stopped in tick " << simulation.space().tick << ": " << describeException() << '\n';
    code = ExitCode::kStopped;
  }
  run_end.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  run_end.finished = code == ExitCode::kFinished && simulation.isFinished();
  if (code == ExitCode::kFinished && isInterrupted()) {
    code = ExitCode::kInterrupted;
  }
  code = finish(simulation) ? code : ExitCode::kStopped;
  run_end.state_hash = simulation.stateHash();  // before destroy() can change the state
  simulation.destroyControllers();
  const RunResult result = resultOf(simulation, run_end);
  print(toText(summarise(result, facts)) + "\n");
  return code == ExitCode::kFinished && !result.failures.empty() ? ExitCode::kControllerFailed : code;
}

/// The experiment's visualisations write their files again: to a temporary folder, unless the options name one.
RunFiles filesOf(const RerunOptions& options, const RecordPlace& place, const TemporaryFolder& nowhere) {
  RunFiles files;
  files.prefix = "--";
  files.folder = options.out.empty() ? nowhere.path().string() : options.out;
  files.rules = {options.write_anywhere, options.force};
  files.records_bag = options.bag.has_value();
  files.reads = place.files;
  return files;
}

RunFacts factsOf(const RerunOptions& options) {
  RunFacts facts;
  facts.overrides.push_back("--until " + std::to_string(options.until.value_or(0)));
  for (const std::string& setting : options.settings) {
    facts.overrides.push_back("--set " + setting);
  }
  if (options.seed) {
    facts.overrides.push_back("--seed " + std::to_string(*options.seed));
  }
  return facts;
}

ExitCode makeAgain(Simulation& simulation, const RecordedRun& run, std::uint64_t until, const Fork& fork,
                   const RerunOptions& options) {
  RunFacts facts = factsOf(options);
  const auto after_tick = [&] {
    facts.robot_ticks += static_cast<double>(simulation.robotCount());
    return !isInterrupted();
  };
  Verdict verdict;
  try {
    verdict = compareTicks(simulation, run, until, after_tick);
  } catch (...) {
    std::cerr << "swarmanoid: stopped in tick " << simulation.space().tick << ", up to which each has the state of the "
              << "recorded run: " << describeException() << '\n';
    finish(simulation);
    return ExitCode::kStopped;
  }
  print(verdict.text + "\n");
  if (verdict.is_equal && !fork.isNone()) {
    facts.robot_ticks = 0.0;  // the summary covers the fork only
    return runFork(simulation, fork, facts, after_tick);
  }
  if (!finish(simulation)) {
    return ExitCode::kStopped;
  }
  return verdict.is_interrupted ? ExitCode::kInterrupted
                                : (verdict.is_equal ? ExitCode::kFinished : ExitCode::kDiffers);
}

ExitCode rerun(const RerunOptions& options) {
  UserCodeWatch watch({});
  loadBuiltInPlugins();
  const RecordPlace place = findRecord(options.run, options.number);
  const RecordedRun run = readRecordedRun(place.folder);
  refuseOtherResult(run);
  for (const std::string& missing : run.missing) {
    warn(missing);
  }
  Experiment experiment = experimentOf(run);
  for (const std::string& warning : takeExperimentWarnings()) {
    warn(warning);
  }
  for (const std::string& difference : differences(run.record, recordOf(experiment, suiteVersion()))) {
    warn(difference);
  }
  InterventionFile interventions = interventionsOf(run, experiment);
  refuseRobotsOfOthers(robotsOfOthers(run, experiment, interventions), options.run);
  const std::uint64_t until = readUntil(options, run);
  const Fork fork = parseFork(options.settings, options.seed, experiment);
  changeLength(experiment, fork, until);
  experiment.framework.threads = options.threads.value_or(experiment.framework.threads);
  const TemporaryFolder nowhere("rerun");
  RunContext context;
  context.is_open = false;
  context.out = openOutFolder(filesOf(options, place, nowhere), experiment);
  context.is_fork = fork.seed.has_value();
  experiment.overrides = run.record.overrides;  // already applied in its text; given here for the tables that it writes
  Simulation simulation(std::move(experiment), context);
  simulation.play(InterventionPlayer(
      withoutThoseOfRules(std::move(interventions), simulation.experiment()).interventions, AskedByRules::kPlayed));
  addRecorders(simulation, context, options);
  context.out->keep();
  simulation.setLogSink([](LogLevel level, const std::string& robot, const std::string& text) {
    if (level >= LogLevel::kWarning) {
      std::cerr << robot << ": " << text << '\n';
    }
  });
  noteInterruptions();
  const UserCodeWatch::Closing closing(watch, [&](const UserCodeEnd& end) {
    simulation.giveUp(end.part);
    finish(simulation);
  });
  return makeAgain(simulation, run, until, fork, options);
}

}  // namespace

Command addRerunCommand(CLI::App& app) {
  auto options = std::make_shared<RerunOptions>();
  CLI::App* command = app.add_subcommand("rerun", "make a recorded run again, and compare the state of each tick");
  command->footer("Exit code: 0 equal, 1 different, 2 bad input; of a fork those of `run`.");
  command->add_option("RUN", options->run, "a folder of `run --record`, a bag, or a folder with one bag")->required();
  command
      ->add_option("--run", options->number,
                   "which run of the bag, as resets count them; else the last one that made a tick")
      ->check(refuseWrappedNumber);
  command->add_option("--until", options->until, "so many ticks, and no more of the recorded run")
      ->check(refuseWrappedNumber);
  command->add_option("--set", options->settings, "path=value that holds from there on (can be given again)");
  command->add_option("--seed", options->seed, "random seed from there on")->check(refuseWrappedNumber);
  command->add_option("--threads", options->threads, "threads; results do not depend on it")
      ->check(CLI::Range(1, 1024));
  command->add_option("--out", options->out, "folder for the files that visualisations write; else they are removed");
  command->add_flag("--force", options->force, "replace files that are there already");
  command->add_flag("--write-anywhere", options->write_anywhere,
                    "visualisations of the experiment file may write outside the folder");
  CLI::Option* bag = command->add_option("--bag", options->bag, "record a rosbag");
  command->add_flag("--record-state", options->record_state, "all named state in the bag, for `swarmanoid diff`")
      ->needs(bag);
  command->add_option("--hashes", options->hashes, "write the state hash of every tick");
  command->add_option("--save-interventions", options->save_interventions,
                      "write what is done to the run by rules or from outside");
  return [options] { return rerun(*options); };
}

}  // namespace swarmanoid::program
