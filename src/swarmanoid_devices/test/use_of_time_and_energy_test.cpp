// The rules `state_times` and `energy_use`: reported states and consumption of robots.
#include "measured_run.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

namespace swarmanoid::test {
namespace {

/// Reports "search" for 3 ticks, "go home" for 4, then an unlisted state; drives all the time.
class Speaker final : public Controller {
 public:
  void init(Robot& robot, const Configuration&) override {
    robot_ = &robot;
    robot.actuator<FootbotWheels>().setAngularVelocity(3.1, -1.7);
  }
  void step(Time, Duration) override {
    ++steps_;
    robot_->debug("state", steps_ <= 3 ? "search" : steps_ <= 7 ? "go home" : "rest");
  }

 private:
  Robot* robot_ = nullptr;
  int steps_ = 0;
};

constexpr double kDrive = 4.0 * (3.1 + 1.7) / (2.0 * 10.344827586206895);  // W, of both wheels

/// fb_1 and fb_2 with a controller, fb_2 also with the elements `of_second`, and one robot without a controller.
std::unique_ptr<Simulation> world(const std::string& rule, const std::string& of_second = "") {
  loadPluginLibrary("swarmanoid_devices", {}, {});
  const auto robot = [](const std::string& id, const std::string& place, const std::string& more) {
    return "<footbot id='" + id + "'><position>" + place + "</position><orientation>0,0,0</orientation>" + more +
           "</footbot>";
  };
  const std::string speaker = "<controller>speaker</controller>";
  auto simulation = std::make_unique<Simulation>(parseExperiment(
      "<ahss-config><framework><clocktick>100</clocktick><maxclock>1000</maxclock></framework>\n<controllers><speaker "
      "id='speaker'><actuators><footbot_wheels/></actuators></speaker></controllers>\n<arena size='10,10,3' "
      "optimization='2D'>" +
          robot("fb_1", "1,1,0", speaker) + robot("fb_2", "2,1,0", speaker + of_second) + robot("other", "3,1,0", "") +
          "</arena>\n<rules>\n" + rule + "\n</rules></ahss-config>",
      "run.xml"));
  simulation->start();
  return simulation;
}

double metricOf(const Simulation& simulation, const std::string& name) {
  return std::get<double>(simulation.metrics().at("r." + name));
}

void tick(Simulation& simulation, int count) {
  for (int i = 0; i < count; ++i) {
    simulation.tick();
  }
}

TEST(StateTimesTest, AreSumsOverTheTicksInWhichStatesAreSaid) {
  const auto simulation =
      world("<state_times id='r'><states>search, go home</states><robots>fb_</robots></state_times>");
  EXPECT_EQ(metricOf(*simulation, "other"), 0.0) << "no time has passed";
  tick(*simulation, 12);
  EXPECT_NEAR(metricOf(*simulation, "search"), 0.3, 1e-12);
  EXPECT_NEAR(metricOf(*simulation, "go home"), 0.4, 1e-12);
  EXPECT_NEAR(metricOf(*simulation, "other"), 0.5, 1e-12);
}

TEST(StateTimesTest, WhoSaysNothingIsInNoneOfThem) {
  const auto simulation = world("<state_times id='r'><states>search, go home</states></state_times>");
  tick(*simulation, 12);
  EXPECT_NEAR(metricOf(*simulation, "search"), 0.3 * 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(metricOf(*simulation, "other"), 0.5 * 2.0 / 3.0 + 1.2 / 3.0, 1e-12);
}

TEST(StateTimesTest, ASampleStandsForTheTicksBeforeIt) {
  const auto simulation =
      world("<state_times id='r'><states>search,go home</states><robots>fb_</robots><every>5</every></state_times>");
  tick(*simulation, 14);
  EXPECT_EQ(metricOf(*simulation, "search"), 0.0);
  EXPECT_NEAR(metricOf(*simulation, "go home"), 0.5, 1e-12) << "tick 5";
  EXPECT_NEAR(metricOf(*simulation, "other"), 0.5, 1e-12) << "tick 10";
}

TEST(StateTimesTest, WhatIsWrongIsNamedWithItsLine) {
  const std::string start = "<state_times id='r'>\n<states>";
  const std::string end = "</states></state_times>";
  EXPECT_EQ(refusalOfRule(start + end), "run.xml:8: states: found '', allowed: names, separated by commas");
  EXPECT_EQ(refusalOfRule(start + "a, b, a" + end),
            "run.xml:8: states: found 'a', allowed: other names than 'other', each once, separated by commas");
  EXPECT_EQ(refusalOfRule(start + "a,, b" + end),
            "run.xml:8: states: found '', allowed: other names than 'other', each once, separated by commas");
  EXPECT_EQ(refusalOfRule(start + "other" + end),
            "run.xml:8: states: found 'other', allowed: other names than 'other', each once, separated by commas");
}

/// By the law of docs/reference/battery.md, for robots with and without a battery.
TEST(EnergyUseTest, IsWhatTheLawOfBatteriesSays) {
  for (const std::string battery : {"", "<battery>true</battery>"}) {
    const auto simulation = world("<energy_use id='r'><robots>fb_</robots></energy_use>", battery);
    EXPECT_EQ(metricOf(*simulation, "used"), 0.0) << battery;
    tick(*simulation, 7);
    const double power = 3.2 + kDrive;  // W: electronics and wheels; wheels draw no power at rest
    EXPECT_NEAR(metricOf(*simulation, "power"), 2.0 * power, 1e-9) << battery;
    EXPECT_NEAR(metricOf(*simulation, "used"), 2.0 * power * 0.7, 1e-9) << battery;
    EXPECT_EQ(metricOf(*simulation, "per_metre"), 0.0) << "no engine moves them";
  }
}

TEST(EnergyUseTest, PerMetreIsByTheLengthOfTheWays) {
  const auto simulation = world("<energy_use id='r'><robots>fb_</robots></energy_use>");
  simulation->apply(MoveEntity{"fb_1", {{1.3, 1.4, 0.0}, Eigen::Quaterniond::Identity()}});
  tick(*simulation, 2);
  simulation->apply(MoveEntity{"fb_1", {{1.0, 1.0, 0.0}, Eigen::Quaterniond::Identity()}});
  tick(*simulation, 1);
  EXPECT_NEAR(metricOf(*simulation, "per_metre"), 2.0 * (3.2 + kDrive) * 0.3 / 1.0, 1e-9) << "0.5 m and back";
}

TEST(UseOfTimeAndEnergyTest, ASteadyTickAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  for (const char* rule : {"<state_times id='r'><states>search, rest</states></state_times>", "<energy_use id='r'/>"}) {
    const auto simulation = world(rule);
    tick(*simulation, 10);
    const long before = heap_allocations;
    simulation->tick();
    EXPECT_EQ(heap_allocations, before) << rule;
  }
}

}  // namespace
}  // namespace swarmanoid::test

REGISTER_CONTROLLER(swarmanoid::test::Speaker, "speaker")
