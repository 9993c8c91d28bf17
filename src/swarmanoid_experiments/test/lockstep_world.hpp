/// Robots with controllers in another process: a participant in this process simulates it, and answers as configured by
/// the test.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_hosts/controller_host.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_space/lockstep/lockstep.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {

/// Runs controllers as another process would, and answers at once by default.
class FakeParticipant {
 public:
  FakeParticipant(Simulation& simulation, std::string name, std::vector<std::string> robots)
      : lockstep_(simulation.lockstep()), name_(std::move(name)), robots_(std::move(robots)) {}

  Registration join() {
    const std::lock_guard<std::mutex> lock(mutex_);  // a frame may arrive before the controllers exist
    const Registration registration =
        lockstep_.join({name_, robots_, policy, timeout}, [this](const SensorFrame& frame) {
          const std::lock_guard<std::mutex> frame_lock(mutex_);
          ++frames;
          last_frame_ = frame;
          if (!is_mute) {
            refusals.push_back(lockstep_.answer(answerTo(frame)));
          }
          for (int i = 0; i < more_answers; ++i) {
            CommandFrame frame_again = host_->answer(frame);
            frame_again.stamp.tick += tick_error;
            refusals.push_back(lockstep_.answer(frame_again));
          }
        });
    const std::string label = registration.robots.front().label;
    host_ = std::make_unique<ControllerHost>(
        registration,
        [label] { return makePlugin<Controller>(*Registry::instance().find(PluginKind::kController, label)); },
        nullptr);
    return registration;
  }

  /// Sends the answer to the last frame that a mute participant has not answered.
  void answerLate() {
    const std::lock_guard<std::mutex> lock(mutex_);
    refusals.push_back(lockstep_.answer(answerTo(last_frame_)));
  }

  CommandFrame answerTo(const SensorFrame& frame) {
    CommandFrame answer = host_->answer(frame);
    if (cuts_short) {
      answer.data.pop_back();
    }
    if (mutate) {
      mutate(answer);
    }
    return answer;
  }

  const SensorFrame& lastFrame() const { return last_frame_; }

  std::function<void(CommandFrame&)> mutate;  // changes an answer before it is sent
  std::optional<LatePolicy> policy;
  std::optional<Lockstep::Seconds> timeout;
  bool is_mute = false;
  bool cuts_short = false;
  int more_answers = 0;
  std::uint64_t tick_error = 0;
  int frames = 0;
  std::vector<std::string> refusals;

 private:
  std::mutex mutex_;
  Lockstep& lockstep_;
  std::string name_;
  std::vector<std::string> robots_;
  std::unique_ptr<ControllerHost> host_;
  SensorFrame last_frame_;
};

inline std::vector<std::string> textsOf(const Simulation& simulation, Event::Kind kind) {
  std::vector<std::string> texts;
  for (const Event& event : simulation.space().events) {
    if (event.kind == kind) {
      texts.push_back(event.entity + ": " + event.text);
    }
  }
  return texts;
}

/// The retrieval experiment, with the given robots commanded by another process.
inline std::unique_ptr<Simulation> remoteRetrieval(const std::vector<Override>& remote, int threads = 1,
                                                   std::uint64_t seed = 7) {
  loadBuiltInPlugins();
  Experiment experiment =
      readExperiment(findShared("swarmanoid_experiments", "experiments/object_retrieval.xml"), remote);
  experiment.framework.seed = seed;
  experiment.framework.threads = threads;
  auto simulation = std::make_unique<Simulation>(std::move(experiment));
  simulation->start();
  return simulation;
}

inline const Override kFootbots{"arena.distribute.fb.controller.source", "remote"};
inline const Override kEyebot{"arena.eb.controller.source", "remote"};

/// One footbot that drives straight ahead, commanded by another process; not started.
inline std::unique_ptr<Simulation> oneRobotBeforeStart(const std::string& source = "remote",
                                                       const std::string& drive = "", const std::string& rules = "") {
  World world;
  world.rules = rules;
  std::string robot = footbot("fb", 1, 1, 0);
  robot.replace(robot.find("<controller>"), 12, "<controller source=\"" + source + "\">");
  world.entities = robot;
  world.members = member("fb");
  world.drive = "<left>5</left><right>5</right>" + drive;
  return world.make();
}

inline std::unique_ptr<Simulation> oneRobot(const std::string& source = "remote", const std::string& drive = "") {
  auto simulation = oneRobotBeforeStart(source, drive);
  simulation->start();
  return simulation;
}

}  // namespace swarmanoid::test
