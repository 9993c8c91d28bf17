#include "test_world.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/orientation.hpp"
#include "swarmanoid_interface/plugin_library.hpp"

namespace swarmanoid::test {
namespace {

/// Sets the wheel speeds of its parameters [rad/s]; parameters can also make it close the gripper, set "done", throw,
/// or command NaN at a tick, and throw in `destroy`.
class TestDrive final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    wheels_ = &robot.actuator<FootbotWheels>();
    gripper_ = &robot.actuator<FootbotGripper>();
    left_ = parameters.number("left");
    right_ = parameters.number("right");
    close_at_ = parameters.integer("close_at", std::int64_t{-1});
    open_at_ = parameters.integer("open_at", std::int64_t{-1});
    say_at_ = parameters.integer("say_at", std::int64_t{-1});
    throw_at_ = parameters.integer("throw_at", std::int64_t{-1});
    nan_at_ = parameters.integer("nan_at", std::int64_t{-1});
    throws_when_it_goes_ = parameters.boolean("throws_when_it_goes", false);
    only_ = parameters.text("only", "");
    random_ = parameters.boolean("random", false);
    parameters.refuseUnread();
  }

  void step(Time, Duration) override {
    const std::int64_t tick = tick_++;
    wheels_->setAngularVelocity(left_, right_);
    if (random_) {
      wheels_->setAngularVelocity(robot_->random().uniform(-5.0, 10.0), robot_->random().uniform(-5.0, 10.0));
    }
    if (tick == close_at_) {
      gripper_->close();
    }
    if (tick == open_at_) {
      gripper_->open();
    }
    if (tick == say_at_) {
      robot_->debug("state", "done");
    }
    const bool is_meant = only_.empty() || only_ == robot_->name();
    if (is_meant && tick == throw_at_) {
      throw std::runtime_error("told to");
    }
    if (is_meant && tick == nan_at_) {
      wheels_->left = std::numeric_limits<double>::quiet_NaN();
    }
  }

  void archive(StateArchive& state) override { state(tick_); }

  void destroy() override {
    if (throws_when_it_goes_) {
      throw std::runtime_error("told to, at the end");
    }
  }

 private:
  Robot* robot_ = nullptr;
  FootbotWheels* wheels_ = nullptr;
  FootbotGripper* gripper_ = nullptr;
  double left_ = 0.0;
  double right_ = 0.0;
  std::int64_t close_at_ = -1;
  std::int64_t open_at_ = -1;
  std::int64_t say_at_ = -1;
  std::int64_t throw_at_ = -1;
  std::int64_t nan_at_ = -1;
  std::int64_t tick_ = 0;
  std::string only_;
  bool random_ = false;
  bool throws_when_it_goes_ = false;
};

}  // namespace

std::string World::xml() const {
  return "<ahss-config><framework><clocktick>100</clocktick><maxclock>" + std::to_string(ticks) + "</maxclock>" +
         framework +
         "</framework><controllers><test_drive id=\"drive\" library=\"swarmanoid_devices\"><actuators><footbot_wheels/>"
         "<footbot_gripper/><footbot_leds/></actuators><sensors><footbot_proximity/></sensors><parameters>" +
         drive + "</parameters></test_drive></controllers><arena size=\"" + size + "\"" +
         (center.empty() ? "" : " center=\"" + center + "\"") + " optimization=\"2D\" bounded=\"" +
         (bounded ? "true" : "false") + "\">" + entities + "</arena><engines><kinematics2d id=\"ground\">" +
         engine_parameters + "</kinematics2d>" + engines + "</engines><arena_physics><engine id=\"ground\">" + members +
         "</engine>" + physics + "</arena_physics><rules>" + rules + "</rules><visualisations>" + visualisations +
         "</visualisations></ahss-config>";
}

std::unique_ptr<Simulation> World::make() const {
  loadBuiltInPlugins();
  return std::make_unique<Simulation>(parseExperiment(xml(), "test.xml"));
}

std::string footbot(const std::string& id, double x, double y, double heading_deg) {
  return "<footbot id=\"" + id + "\"><position>" + std::to_string(x) + "," + std::to_string(y) +
         ",0</position><orientation>0,0," + std::to_string(heading_deg) +
         "</orientation><controller>drive</controller></footbot>";
}

std::string member(const std::string& id) { return "<entity id=\"" + id + "\"/>"; }

const Pose& poseOf(const Simulation& simulation, std::string_view name) {
  const Entities& entities = simulation.space().entities;
  return entities.pose[entities.find(std::string(name))];
}

double headingOf(const Simulation& simulation, const std::string& name) {
  return anglesFromOrientation(poseOf(simulation, name).orientation).z();
}

std::unique_ptr<Simulation> retrieval(std::uint64_t seed, int threads, const GroundEngine& ground) {
  loadBuiltInPlugins();
  Experiment experiment = readExperiment(findShared("swarmanoid_experiments", "experiments/object_retrieval.xml"));
  experiment.framework.seed = seed;
  experiment.framework.threads = threads;
  EngineDescription& engine = experiment.engines.front();
  engine.label = ground.label;
  engine.parameters = Configuration(ground.label, "", engine.location);
  engine.parameters.set("subclock", std::to_string(ground.subclock));
  auto simulation = std::make_unique<Simulation>(std::move(experiment));
  simulation->start();
  return simulation;
}

std::vector<std::uint64_t> hashesOf(Simulation& simulation, std::uint64_t ticks) {
  std::vector<std::uint64_t> hashes;
  for (std::uint64_t i = 0; i < ticks && !simulation.isFinished(); ++i) {
    simulation.tick();
    hashes.push_back(simulation.stateHash());
  }
  return hashes;
}

}  // namespace swarmanoid::test

REGISTER_CONTROLLER(swarmanoid::test::TestDrive, "test_drive")
