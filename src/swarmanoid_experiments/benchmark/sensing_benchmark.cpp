// Cost of sensing: whole ticks of 10,000 footbots on the sparse floor of simulation_benchmark.cpp, one thread, no ROS.
// They turn on the spot, each with one device, with all of them or with none: robots x ticks per second
// (items_per_second), and sensing's part of a tick (`sense_share`).
//
// All robots send by range and bearing, with about 18 others within 3 m; with a camera all twelve LEDs of each robot
// are lit. Ten bulbs hang 2 m above the floor with a range of 5 m. LEDs have a range of 0.5 m, at which they are as
// bright as a bulb, which is a hundred times stronger, at 5 m. The floor has a nest of 4 m in its centre.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/testing/diffusion_experiment.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_scanner.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/leds.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {
namespace {

constexpr int kRobots = 10000;
constexpr double kArea = 1.6;  // m2 per robot

class Turner final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    auto& wheels = robot.actuator<FootbotWheels>();
    wheels.left = -2.0;
    wheels.right = 2.0;
    if (robot.hasActuator(RangeAndBearing::kType)) {
      robot.actuator<RangeAndBearing>().send({1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
    }
    if (robot.hasActuator(FootbotLeds::kType)) {
      robot.actuator<FootbotLeds>().setAll(colors::kRed);
    }
    if (robot.hasActuator(FootbotScanner::kType)) {
      robot.actuator<FootbotScanner>().turnAt(4.0);
    }
    parameters.refuseUnread();
  }
  void step(Time, Duration) override {}
};

struct Devices {
  std::string actuators;
  std::string sensors;
};

const Devices kProximity{"", "<footbot_proximity><range>0.1</range></footbot_proximity>"};
const Devices kScanner{"<footbot_scanner/>", "<footbot_scanner_readings/>"};  // range of 1.5 m
const Devices kGround{"", "<footbot_ground/>"};
const Devices kMessages{"<range_and_bearing/>",
                        "<range_and_bearing_received><range>3</range></range_and_bearing_received>"};

/// @param led_range [m]
Devices light(double led_range) {
  return {"", "<light><range>5</range><led_range>" + std::to_string(led_range) + "</led_range></light>"};
}

Devices camera(double range) {
  return {"<footbot_leds/>", "<footbot_camera><range>" + std::to_string(range) + "</range></footbot_camera>"};
}

Devices operator+(const Devices& a, const Devices& b) { return {a.actuators + b.actuators, a.sensors + b.sensors}; }

void replace(std::string& text, const std::string& from, const std::string& to, const std::string& by) {
  const std::size_t first = text.find(from);
  text.replace(first, text.find(to, first) + to.size() - first, by);
}

std::string experiment(const Devices& devices) {
  std::string text = diffusionExperiment(kRobots, kArea, "<kinematics2d id='ground'/>");
  replace(text, "<diffusion", "</diffusion>",
          "<turner id='dc' library='swarmanoid_devices'><actuators><footbot_wheels/>" + devices.actuators +
              "</actuators><sensors>" + devices.sensors + "</sensors></turner>");
  replace(text, ",1'", " ", ",3' ");
  const double side = std::sqrt(kRobots * kArea);
  std::string things;
  for (int i = 0; i < 10; ++i) {
    const double angle = 0.2 * M_PI * i;
    things += "<light id='bulb_" + std::to_string(i) + "'><position>" +
              std::to_string(side * (0.5 + 0.3 * std::cos(angle))) + "," +
              std::to_string(side * (0.5 + 0.3 * std::sin(angle))) +
              ",2</position><orientation>0,0,0</orientation><intensity>100</intensity></light>";
  }
  const std::string middle = std::to_string(0.5 * side);
  things +=
      "<floor_patch id='nest'><position>" + middle + "," + middle + ",0</position><radius>4</radius></floor_patch>";
  return text.insert(text.find("<distribute"), things);
}

void run(benchmark::State& state, const Devices& devices) {
  loadBuiltInPlugins();
  Simulation simulation(parseExperiment(experiment(devices), "benchmark.xml"));
  simulation.timePhases();
  simulation.start();
  constexpr int kWarmUp = 5;
  for (int i = 0; i < kWarmUp; ++i) {
    simulation.tick();
  }
  double of_sensing = 0.0;
  double of_all = 0.0;
  for (auto _ : state) {
    simulation.tick();
    const PhaseTimes& times = simulation.phaseTimes();
    of_sensing += times.sense;
    of_all += times.sense + times.control + times.actuate + times.move + times.connect + times.index + times.power +
              times.rule + times.show;
  }
  state.counters["sense_share"] = of_sensing / of_all;
  state.SetItemsProcessed(state.iterations() * kRobots);
}

void BM_Nothing(benchmark::State& state) { run(state, {}); }
void BM_Proximity(benchmark::State& state) { run(state, kProximity); }
void BM_Light(benchmark::State& state) { run(state, light(0.5)); }
void BM_Scanner(benchmark::State& state) { run(state, kScanner); }
void BM_Ground(benchmark::State& state) { run(state, kGround); }
void BM_Messages(benchmark::State& state) { run(state, kMessages); }
/// @param range in cm
void BM_Camera(benchmark::State& state) { run(state, camera(0.01 * static_cast<double>(state.range(0)))); }
/// @param range of LEDs for the light sensors, in cm
void BM_All(benchmark::State& state) {
  const Devices of_light = light(0.01 * static_cast<double>(state.range(0)));
  run(state, kProximity + of_light + kGround + kScanner + kMessages + camera(1.5));
}

BENCHMARK(BM_Nothing)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Proximity)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Light)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Scanner)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Ground)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Messages)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_Camera)->Arg(100)->Arg(150)->Arg(300)->Arg(500)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_All)->Arg(50)->Arg(100)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::Turner, "turner")

BENCHMARK_MAIN();
