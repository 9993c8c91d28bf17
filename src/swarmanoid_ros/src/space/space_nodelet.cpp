// The space under ROS: reads the experiment, loads the nodelets that it needs, makes the ticks, and ends.
#include <nodelet/nodelet.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/network.h>
#include <pluginlib/class_list_macros.hpp>

#include <atomic>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "../engines/engine_parameters.hpp"
#include "../lockstep/lockstep_server.hpp"
#include "../nodelets/robot_topics.hpp"
#include "../nodelets/space_parts.hpp"
#include "../process/end_on_signals.hpp"
#include "../process/exit_code.hpp"
#include "../process/exposure.hpp"
#include "../process/roslaunch_parent.hpp"
#include "../process/second_signal.hpp"
#include "engine_diagnostics.hpp"
#include "recorder.hpp"
#include "remote_rules.hpp"
#include "run_result.hpp"
#include "space_diagnostics.hpp"
#include "space_services.hpp"
#include "swarmanoid_experiment_files/interventions/read_player.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_hosts/ros/log.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/process/math_library.hpp"
#include "swarmanoid_interface/process/user_code_watch.hpp"
#include "swarmanoid_recording/messages/world_state.hpp"
#include "swarmanoid_space/device_drawing.hpp"

namespace swarmanoid {
class SpaceNodelet final : public nodelet::Nodelet {
 public:
  ~SpaceNodelet() override;

 private:
  using State = SimulationThread::State;

  void onInit() override;
  void startUp(Experiment experiment);
  std::unique_ptr<Simulation> build(Experiment experiment);
  void onChange(State state, const std::string& stop_reason);
  void onLoss(PluginKind kind, const std::string& id);
  RemoteRules lookAround();
  void watchUsersCode();
  void keepWhatIsThere(const UserCodeEnd& end);
  void report(const RunResult& result);
  void reportExitCode(ExitCode code);
  void shutDownSoon(ExitCode code);

  SpaceOptions options_;
  std::vector<std::string> exit_code_files_;  // files that may be written to
  std::unique_ptr<UserCodeWatch> watch_;      // outlives thread_, with which controllers are destroyed
  std::unique_ptr<UserCodeWatch::Closing> closing_;
  const std::shared_ptr<CommandMailbox> commands_ = std::make_shared<CommandMailbox>();
  std::vector<AttachmentPoint::Request> parts_;
  std::shared_ptr<AttachmentPoint> point_;
  std::unique_ptr<NodeletLoader> loader_;
  std::thread starter_;  // inside onInit the manager would not answer
  std::atomic<Simulation*> simulation_{nullptr};
  std::shared_ptr<SpaceDisplay> display_;
  RobotTopics::Selection with_topics_;
  std::shared_ptr<RobotTopics> robot_topics_;  // null if this process is no manager
  std::atomic<State> last_state_{State::kPaused};
  std::unique_ptr<SimulationThread> thread_;
  std::unique_ptr<SpaceServices> services_;
  std::unique_ptr<LockstepServer> lockstep_;
  std::unique_ptr<SpaceDiagnostics> diagnostics_;
  std::unique_ptr<EngineDiagnostics> engine_diagnostics_;
  std::vector<std::unique_ptr<EngineParameters>> engine_parameters_;
  ros::WallTimer end_;
};

void SpaceNodelet::onInit() {
  try {
    shutDownOnSignals();
    exit_code_files_ = {exitCodeFileOfStarter()};
    const RemoteRules rules = lookAround();
    // this parameter is read before the others, which may be wrong
    const std::string exit_code_file = readExitCodeFile(getPrivateNodeHandle());
    checkExitCodeFile(exit_code_file, rules);
    exit_code_files_.push_back(exit_code_file);
    options_ = readSpaceOptions(getPrivateNodeHandle());
    watchUsersCode();
    checkFiles(options_, rules);
    Experiment experiment = readExperiment(options_);
    for (const std::string& warning : takeExperimentWarnings()) {
      NODELET_WARN("%s", warning.c_str());
    }
    if (!isMathLibraryFixed()) {
      NODELET_WARN(
          "this process calculates with %s: on another computer, and without ROS, the run may end in another "
          "state. Start it with GLIBC_TUNABLES=%s, as setup.bash and run.launch do",
          mathLibrary().c_str(), tunablesOfFixedMathLibrary("").c_str());
    }
    const std::vector<std::string> with_topics = robotsWithTopics(options_, experiment);
    with_topics_.is_all = options_.device_topics == std::vector<std::string>{"all"};
    with_topics_.names.insert(with_topics.begin(), with_topics.end());
    parts_ = partsOf(experiment, with_topics, commands_);
    chooseRobots(options_.record_controllers, "~record_controllers", experiment);  // these two report mistakes at once
    chooseDrawnRobots(options_.device_markers, "~device_markers", experiment);
    point_ = openAttachmentPoint(getName(), parts_);
    loader_ = std::make_unique<NodeletLoader>();
    starter_ = std::thread([this, experiment = std::move(experiment)]() mutable { startUp(std::move(experiment)); });
  } catch (...) {
    const std::string reason = describeException();
    NODELET_FATAL("%s", reason.c_str());
    reportExitCode(ExitCode::kBadInput);
    throw std::runtime_error(reason);  // the manager reports the nodelet as not loaded
  }
}

/// Reports if other computers can reach this process, and restricts libraries in that case.
RemoteRules SpaceNodelet::lookAround() {
  const auto warning = exposureWarning(ros::network::getHost(), ros::master::getHost(), addressesForOthers());
  RemoteRules rules = remoteRules(warning.has_value());
  if (warning) {
    NODELET_WARN("%s", warning->c_str());
  }
  allowLibrariesByPath(rules.any_library);
  return rules;
}

void SpaceNodelet::watchUsersCode() {
  UserCodeWatch::Options options;
  options.report = [](const std::string& text) { ROS_WARN("%s", text.c_str()); };
  options.watchdog = options_.watchdog;
  watch_ = std::make_unique<UserCodeWatch>(options);
  closing_ =
      std::make_unique<UserCodeWatch::Closing>(*watch_, [this](const UserCodeEnd& end) { keepWhatIsThere(end); });
  passOnSecondSignal();
}

/// Saves the results when the process is about to end inside users' code, while the simulation's thread is blocked.
void SpaceNodelet::keepWhatIsThere(const UserCodeEnd& end) {
  NODELET_FATAL("%s", end.reason.c_str());
  reportExitCode(end.exit_code);
  Simulation* simulation = simulation_;
  if (simulation == nullptr) {
    return;
  }
  simulation->giveUp(end.part);
  try {
    simulation->finish();
  } catch (...) {
    NODELET_ERROR("%s", describeException().c_str());
  }
  const State last_state = last_state_;
  if (last_state != State::kFinished && last_state != State::kStopped) {
    RunResult result = resultOf(*simulation, {false, end.reason, display_->wallTime(), {}});
    if (end.exit_code == ExitCode::kControllerFailed && !end.robot.empty()) {
      result.failures.push_back({end.robot, result.ticks, end.reason});
    }
    display_->publish(toMessage(result, headerOf(simulation->space())));
    report(result);
    constexpr double kOnTheWay = 0.3;  // [s] for the last messages
    ros::WallDuration(kOnTheWay).sleep();
  }
}

void SpaceNodelet::startUp(Experiment experiment) {
  try {
    SimulationThread::Options pace;
    pace.paused = options_.paused;
    pace.real_time_factor = experiment.framework.real_time_factor;
    pace.on_change = [this](const Simulation&, State state, const std::string& reason) { onChange(state, reason); };
    auto simulation = build(std::move(experiment));
    Lockstep& lockstep = simulation->lockstep();
    lockstep.setOptions(options_.lockstep);
    // before the first tick, which may wait for participants
    lockstep_ = std::make_unique<LockstepServer>(getMTPrivateNodeHandle(), simulation->experiment().name, lockstep);
    simulation_ = simulation.get();  // from here on the only possible failure is that the thread cannot be started
    thread_ = std::make_unique<SimulationThread>(std::move(simulation), pace);
    point_->setLossHandler([this](PluginKind kind, const std::string& id) { onLoss(kind, id); });
    display_->serveNewcomers(thread_.get());
    diagnostics_ = std::make_unique<SpaceDiagnostics>(getMTPrivateNodeHandle(), simulation_.load()->experiment().name,
                                                      *display_, *thread_);
    engine_diagnostics_ = std::make_unique<EngineDiagnostics>(getMTPrivateNodeHandle(),
                                                              simulation_.load()->experiment(), *display_, *thread_);
    for (auto& [engine, live] : liveParameters(simulation_.load()->experiment())) {
      engine_parameters_.push_back(std::make_unique<EngineParameters>(
          ros::NodeHandle(getMTPrivateNodeHandle(), "engines/" + engine), engine, std::move(live), *thread_));
    }
    if (robot_topics_ != nullptr) {
      robot_topics_->start(*thread_);
    }
    services_ = std::make_unique<SpaceServices>(getMTPrivateNodeHandle(), *thread_);
  } catch (...) {
    if (thread_ == nullptr) {
      simulation_ = nullptr;
    }
    if (!isRosEnding()) {
      NODELET_FATAL("%s", describeException().c_str());
      reportExitCode(ExitCode::kBadInput);
      shutDownSoon(ExitCode::kBadInput);  // even if ~on_end is stay: there is nothing to show
    } else if (thread_ == nullptr) {
      std::fprintf(stderr, "swarmanoid: interrupted before the first tick\n");  // ROS logs no more
      reportExitCode(ExitCode::kInterrupted);
    }
  }
}

std::unique_ptr<Simulation> SpaceNodelet::build(Experiment experiment) {
  SuppliedParts supplied;
  if (loader_->isManager()) {
    loadParts(*loader_, getName(), *point_, parts_, options_.timeout);
    supplied = takeParts(*point_, parts_);
  } else {
    NODELET_WARN("this process is no nodelet manager: engines and controllers run without nodelets of their own");
  }
  supplied.commands = commands_;
  RunContext context;
  context.out = openOutFolder(options_, experiment);
  context.headless = false;
  auto simulation = std::make_unique<Simulation>(std::move(experiment), context, std::move(supplied));
  display_ = std::make_shared<SpaceDisplay>(
      getMTPrivateNodeHandle(), options_,
      chooseDrawnRobots(options_.device_markers, "~device_markers", simulation->experiment()));
  display_->follow(*simulation);
  simulation->addObserver(display_);
  if (loader_->isManager()) {
    robot_topics_ = std::make_shared<RobotTopics>(getName(), with_topics_, *loader_, *point_, commands_);
    robot_topics_->adopt(parts_);
    simulation->addObserver(robot_topics_);
  }
  for (const std::string& line : addRecorders(*simulation, context, options_, getName())) {
    NODELET_INFO("%s", line.c_str());
  }
  simulation->play(readPlayer(options_.interventions, options_.interventions, AskedByRules::kLeftOut,
                              simulation->experiment(),
                              [this](const std::string& warning) { NODELET_WARN("%s", warning.c_str()); }));
  NODELET_INFO("files go to %s, unless their names say otherwise",
               (std::filesystem::current_path() / options_.out).lexically_normal().c_str());
  context.out->keep();
  simulation->setLogSink(logRobot);
  return simulation;
}

void SpaceNodelet::onChange(State state, const std::string& stop_reason) {
  const State last_state = last_state_;
  const bool is_news = state != last_state;
  if (last_state == State::kFinished && state == State::kStopped) {
    return;  // a finished run stays finished
  }
  last_state_ = state;
  display_->publishAll();
  if (robot_topics_ != nullptr) {
    robot_topics_->follow(simulation_.load()->space());
  }
  if (!is_news || (state != State::kFinished && state != State::kStopped)) {
    return;
  }
  const Simulation& simulation = *simulation_.load();
  const RunResult result = resultOf(simulation, {state == State::kFinished, stop_reason, display_->wallTime(), {}});
  display_->publish(toMessage(result, headerOf(simulation.space())));
  report(result);
  const ExitCode at_end = result.failures.empty() ? ExitCode::kFinished : ExitCode::kControllerFailed;
  const ExitCode if_stopped = isRosEnding() ? ExitCode::kInterrupted : ExitCode::kStopped;
  const ExitCode code = state == State::kFinished ? at_end : if_stopped;
  reportExitCode(code);
  if (isRosEnding()) {
    return;  // the process is ending already
  }
  if (!options_.stays_at_end) {
    shutDownSoon(code);
  }
}

void SpaceNodelet::onLoss(PluginKind kind, const std::string& id) {
  if (kind == PluginKind::kObserver) {
    return;  // the run does not depend on its observers
  }
  thread_->stop(isRosEnding() ? "shut down" : std::string(toString(kind)) + " '" + id + "': its nodelet was unloaded");
}

void SpaceNodelet::report(const RunResult& result) {
  const std::string text = describe(result);
  if (isRosEnding()) {
    std::printf("%s\n", text.c_str());  // ROS logs no more
  } else if (result.finished) {
    NODELET_INFO("%s", text.c_str());
  } else {
    NODELET_ERROR("%s", text.c_str());
  }
  std::fflush(stdout);  // the process may end without flushing, or much later
}

void SpaceNodelet::reportExitCode(ExitCode code) {
  for (const std::string& file : exit_code_files_) {
    try {
      writeExitCode(file, code);
    } catch (const std::exception& error) {
      NODELET_ERROR("%s", error.what());
    }
  }
}

void SpaceNodelet::shutDownSoon(ExitCode code) {
  setExitCode(code);
  // the last messages are still being sent
  constexpr double kDelay = 0.5;  // [s]
  constexpr int kPatience = 20;   // in delays: the time that roslaunch has to interrupt this process
  end_ = getMTPrivateNodeHandle().createWallTimer(
      ros::WallDuration(kDelay), [code, waited = 0](const ros::WallTimerEvent&) mutable {
        const bool is_interrupted_soon = code == ExitCode::kFinished && (waited > 0 || interruptRoslaunch());
        if (!is_interrupted_soon || ++waited > kPatience) {
          ros::requestShutdown();
        }
      });
}

SpaceNodelet::~SpaceNodelet() {
  if (loader_ != nullptr) {
    loader_->shutdown();
  }
  if (starter_.joinable()) {
    starter_.join();
  }
  if (point_ != nullptr) {
    point_->setLossHandler(nullptr);
  }
  // first calls into the simulation are ended, then its clients, then the simulation itself
  if (thread_ != nullptr) {
    thread_->stop(isRosEnding() ? "shut down" : "the space was unloaded");
  }
  if (robot_topics_ != nullptr) {
    robot_topics_->stop();
  }
  services_.reset();
  lockstep_.reset();
  engine_parameters_.clear();
  engine_diagnostics_.reset();
  diagnostics_.reset();
  if (display_ != nullptr) {
    display_->shutdown();
  }
  thread_.reset();
  closing_.reset();  // it refers to destroyed objects otherwise
}

}  // namespace swarmanoid

PLUGINLIB_EXPORT_CLASS(swarmanoid::SpaceNodelet, nodelet::Nodelet)
