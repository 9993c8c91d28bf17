// `swarmanoid run`.
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>

#include "../command_line_observers.hpp"
#include "../commands.hpp"
#include "../experiment_options.hpp"
#include "../output/progress_bar.hpp"
#include "../output/run_summary.hpp"
#include "../output/standard_output.hpp"
#include "../processes/interruption.hpp"
#include "../processes/recorded_bag.hpp"
#include "swarmanoid_experiment_files/interventions/read_player.hpp"
#include "swarmanoid_experiment_files/without_ros.hpp"
#include "swarmanoid_interface/process/user_code_watch.hpp"
#include "swarmanoid_recording/output/run_files.hpp"
#include "swarmanoid_recording/records/record_folder.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"
#include "swarmanoid_space/suite_version.hpp"

namespace swarmanoid::program {
namespace {

struct RunOptions : ExperimentOptions {
  std::vector<std::string> overrides;  // the given options among those above, for the summary
  std::string out;
  bool force = false;
  bool write_anywhere = false;
  std::optional<std::string> bag;
  std::string record_controllers = "none";
  bool record_state = false;
  std::optional<std::string> trajectories;
  std::string record_readings = "none";
  std::optional<std::string> frames;
  std::uint64_t frames_every = 1;
  std::optional<std::string> hashes;
  bool hashes_deep = false;
  std::optional<std::string> save_interventions;
  std::string interventions;
  bool all_interventions = false;
  std::optional<std::string> record;
  bool quiet = false;
  bool profile = false;
};

/// Prints the wall time of each phase.
void printProfile(const PhaseTimes& total, const Space& space) {
  const std::pair<const char*, double> phases[] = {
      {"sense", total.sense}, {"control", total.control}, {"actuate", total.actuate},
      {"move", total.move},   {"connect", total.connect}, {"index", total.index},
      {"power", total.power}, {"rule", total.rule},       {"show", total.show}};
  const auto print = [&](const std::string& name, double seconds) {
    std::fprintf(stderr, "%-8s %10.3f ms, %8.3f us a tick\n", name.c_str(), seconds * 1e3,
                 space.tick > 0 ? seconds * 1e6 / static_cast<double>(space.tick) : 0.0);
  };
  for (const auto& [name, seconds] : phases) {
    print(name, seconds);
  }
  for (std::size_t i = 0; i < total.engines.size(); ++i) {
    print("engine '" + space.engines[i]->id() + "'", total.engines[i]);
    for (const auto& [name, count] : space.engines[i]->health().counters) {
      std::fprintf(stderr, "  %s: %s\n", name.c_str(), count.c_str());
    }
  }
}

/// Prints the summary, and writes it to the record as its result. @return whether the record was written
bool conclude(const std::string& summary, RecordFolder* record) {
  bool is_written = true;
  try {
    if (record != nullptr) {
      record->finish(summary);
    }
  } catch (...) {
    std::cerr << "swarmanoid: " << describeException() << '\n';
    is_written = false;
  }
  print(summary);
  return is_written;
}

/// Saves the files and the summary of a run that ends during a plugin's call.
void keepWhatIsThere(Simulation& simulation, const RunEnd& run_end, const RunFacts& facts, RecordFolder* record,
                     const UserCodeEnd& end) {
  simulation.giveUp(end.part);
  try {
    simulation.finish();
  } catch (...) {
    std::cerr << "swarmanoid: " << describeException() << '\n';
  }
  RunResult result = resultOf(simulation, run_end);
  if (end.exit_code == ExitCode::kControllerFailed && !end.robot.empty()) {
    result.failures.push_back({end.robot, result.ticks, end.reason});
  }
  conclude(toText(summarise(result, facts)) + "\n", record);
}

ExitCode runToEnd(Simulation& simulation, const RunOptions& options, RecordFolder* record, ProgressBar& bar,
                  UserCodeWatch& watch) {
  RunEnd run_end;
  RunFacts facts;
  facts.overrides = options.overrides;
  PhaseTimes total;
  ExitCode code = ExitCode::kFinished;
  const auto start = std::chrono::steady_clock::now();
  const auto passed = [start] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const UserCodeWatch::Closing closing(watch, [&](const UserCodeEnd& end) {
    run_end.wall_s = passed();
    keepWhatIsThere(simulation, run_end, facts, record, end);
  });
  try {
    if (options.profile) {
      simulation.timePhases();
    }
    simulation.start();
    while (!simulation.isFinished() && !isInterrupted()) {
      simulation.tick();
      total += simulation.phaseTimes();
      facts.robot_ticks += static_cast<double>(simulation.robotCount());
      bar.show(simulation.space().tick);
    }
  } catch (...) {
    bar.print("swarmanoid: stopped in tick " + std::to_string(simulation.space().tick) + ": " + describeException());
    code = ExitCode::kStopped;
  }
  run_end.wall_s = passed();
  bar.finish(simulation.space().tick);
  if (options.profile) {
    printProfile(total, simulation.space());
  }
  run_end.finished = code == ExitCode::kFinished && simulation.isFinished();
  if (code == ExitCode::kFinished && isInterrupted()) {
    code = ExitCode::kInterrupted;
  }
  const std::size_t left = simulation.interventionsLeft();
  if (code == ExitCode::kFinished && left > 0 &&
      simulation.space().tick < simulation.experiment().framework.max_clock) {
    std::cerr << "swarmanoid: warning: the run ended in tick " << simulation.space().tick << ", before " << left
              << " of the interventions\n";
  }
  try {
    simulation.finish();
  } catch (...) {
    std::cerr << "swarmanoid: " << describeException() << '\n';
    code = ExitCode::kStopped;
  }
  run_end.state_hash = simulation.stateHash();  // before destroy() can change the state
  simulation.destroyControllers();
  const RunResult result = resultOf(simulation, run_end);
  if (code == ExitCode::kFinished && !result.failures.empty()) {
    code = ExitCode::kControllerFailed;
  }
  if (!conclude(toText(summarise(result, facts)) + "\n", record)) {
    code = ExitCode::kStopped;
  }
  return code;
}

RunFiles filesOf(const RunOptions& options) {
  RunFiles files;
  files.prefix = "--";
  files.folder = options.out;
  files.rules = {options.write_anywhere, options.force};
  files.records_bag = options.bag.has_value();
  files.records_trajectories = options.trajectories.has_value();
  files.writes_frames = options.frames.has_value();
  files.reads = {options.interventions};
  return files;
}

/// Adds the observers that write the record. @return null if none is requested
std::unique_ptr<RecordFolder> startRecord(Simulation& simulation, const RunContext& context,
                                          const std::optional<std::string>& folder) {
  if (!folder) {
    return nullptr;
  }
  const std::string place = fullName(*folder);
  auto record = std::make_unique<RecordFolder>(*context.out, place, OutFolder::Writer{"--record", {}, false},
                                               recordOf(simulation.experiment(), suiteVersion()));
  addFromCommandLine(simulation, context, "--record", "hash_recorder", place + "/" + record_files::kHashes);
  addFromCommandLine(simulation, context, "--record", "intervention_recorder",
                     place + "/" + record_files::kInterventions);
  return record;
}

ExitCode run(const RunOptions& options) {
  UserCodeWatch watch({nullptr, options.watchdog});
  Experiment experiment = readExperiment(options);
  RunContext context;
  context.is_open = false;
  context.out = openOutFolder(filesOf(options), experiment);
  refuseRobotsOfOthers(experiment);
  const RecordPlace place = isBag(options.interventions) ? interventionsOfBag(options.interventions) : RecordPlace{};
  InterventionPlayer player = readPlayer(
      place.folder.empty() ? options.interventions : place.folder + "/" + record_files::kInterventions,
      options.interventions, options.all_interventions ? AskedByRules::kPlayed : AskedByRules::kLeftOut, experiment,
      [](const std::string& warning) { std::cerr << "swarmanoid: warning: " << warning << '\n'; });
  Simulation simulation(std::move(experiment), context);
  simulation.play(std::move(player));
  if (options.hashes) {
    addFromCommandLine(simulation, context, "--hashes", "hash_recorder", *options.hashes,
                       {{"deep", options.hashes_deep ? "true" : "false"}});
  }
  if (options.bag) {
    addFromCommandLine(
        simulation, context, "--bag", "rosbag_recorder", *options.bag,
        {{"controllers", options.record_controllers}, {"state", options.record_state ? "true" : "false"}});
  }
  if (options.trajectories) {
    addFromCommandLine(simulation, context, "--trajectories", "trajectory_recorder", *options.trajectories,
                       {{"readings", options.record_readings}});
  }
  if (options.frames) {
    addFrames(simulation, context, *options.frames, options.frames_every);
  }
  if (options.save_interventions) {
    addFromCommandLine(simulation, context, "--save-interventions", "intervention_recorder",
                       *options.save_interventions);
  }
  const std::unique_ptr<RecordFolder> record = startRecord(simulation, context, options.record);
  context.out->keep();
  if (record != nullptr) {
    record->begin();
  }
  // shared with the sink, which controllers may still use while the simulation is destroyed
  const FrameworkDescription& framework = simulation.experiment().framework;
  const auto bar = std::make_shared<ProgressBar>(simulation.experiment().name, framework.max_clock,
                                                 toSeconds(framework.clocktick), options.quiet);
  simulation.setLogSink([bar, &options](LogLevel level, const std::string& robot, const std::string& text) {
    if (!options.quiet || level == LogLevel::kError) {
      bar->print(robot + ": " + text);
    }
  });
  noteInterruptions();
  return runToEnd(simulation, options, record.get(), *bar, watch);
}

/// Returns the given values of the options that replace values of the file.
std::vector<std::string> overridesOf(const CLI::App& command) {
  std::vector<std::string> overrides;
  for (const char* name : {"--set", "--seed", "--ticks", "--threads"}) {
    for (const std::string& value : command.get_option(name)->results()) {
      overrides.push_back(std::string(name) + " " + value);
    }
  }
  return overrides;
}

}  // namespace

Command addRunCommand(CLI::App& app) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "run an experiment without ROS");
  addExperimentOptions(*command, *options);
  command->add_option("--threads", options->threads, "threads; results do not depend on it")
      ->check(CLI::Range(1, 1024));
  command->add_option("--out", options->out, "folder for the files that visualisations write");
  command->add_flag("--force", options->force, "replace files that are there already");
  command->add_flag("--write-anywhere", options->write_anywhere,
                    "visualisations of the experiment file may write outside the folder");
  CLI::Option* bag = command->add_option("--bag", options->bag, "record a rosbag");
  command
      ->add_option("--record-controllers", options->record_controllers,
                   "robots whose controllers can be replayed from the bag: names separated by spaces, all or none")
      ->needs(bag);
  command->add_flag("--record-state", options->record_state, "all named state in the bag, for `swarmanoid diff`")
      ->needs(bag);
  CLI::Option* trajectories = command->add_option("--trajectories", options->trajectories,
                                                  "write poses, readings and metrics as arrays (HDF5)");
  command
      ->add_option("--record-readings", options->record_readings,
                   "sensors whose readings are among them: types separated by spaces, all or none")
      ->needs(trajectories);
  CLI::Option* frames =
      command->add_option("--frames", options->frames, "a folder: write pictures of the whole arena there");
  command->add_option("--frames-every", options->frames_every, "ticks from one picture to the next; without it 1")
      ->check(CLI::Range(1, 1000000000))
      ->needs(frames);
  CLI::Option* hashes = command->add_option("--hashes", options->hashes, "write the state hash of every tick");
  command->add_flag("--deep", options->hashes_deep, "and a hash of all readings and commands, too")->needs(hashes);
  command->add_option("--record", options->record, "a folder: all that `swarmanoid rerun` makes the same run of again");
  command->add_option("--save-interventions", options->save_interventions,
                      "write what is done to the run by rules or from outside");
  CLI::Option* interventions = command->add_option("--interventions", options->interventions,
                                                   "a file of that, or a bag: do it to this run, too");
  command
      ->add_flag("--all-interventions", options->all_interventions,
                 "also what rules asked for, into a run without these rules")
      ->needs(interventions);
  command->add_flag("--profile", options->profile, "say where the wall time went");
  command->add_flag("--quiet", options->quiet, "no progress bar, no robots' logs");
  return [options, command] {
    options->overrides = overridesOf(*command);
    return run(*options);
  };
}

}  // namespace swarmanoid::program
