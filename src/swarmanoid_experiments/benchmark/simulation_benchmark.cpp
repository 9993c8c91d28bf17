// Whole ticks of the diffusion experiment, one thread, no ROS: robots x ticks per second (items_per_second).
//
// Sparse: one footbot per 1.6 square metres; dense: one per 0.1. 24 proximity rays of 10 cm, tick 100 ms, subclock 1,
// collision shapes of thesis figure 3.9.
//
// Messages: the sparse footbots stand still and send ten bytes by range and bearing in each tick; each has about 18
// others in range, with lines of sight.
//
// Bare: the same diffusion as the shortest possible program. Threads: sparse, with one or two. Maze: a thousand
// footbots among walls.
#include <benchmark/benchmark.h>

#include <random>
#include <string>

#include "bare_diffusion.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/testing/diffusion_experiment.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {
namespace {

constexpr double kSparse = 1.6;  // m2 per robot
constexpr double kDense = 0.1;   // m2 per robot

class Talker final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot.actuator<RangeAndBearing>().send({1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
    parameters.refuseUnread();
  }
  void step(Time, Duration) override {}
};

std::string diffusion(const benchmark::State& state, double area_per_robot) {
  return diffusionExperiment(static_cast<int>(state.range(0)), area_per_robot, "<kinematics2d id='ground'/>");
}

/// The same arena with talking robots.
std::string talking(const benchmark::State& state) {
  std::string text = diffusion(state, kSparse);
  const std::string end = "</diffusion>";
  const std::size_t first = text.find("<diffusion");
  return text.replace(first, text.find(end) + end.size() - first,
                      "<talker id='dc' library='swarmanoid_devices'><actuators><range_and_bearing/></actuators>"
                      "<sensors><range_and_bearing_received/></sensors></talker>");
}

/// A thousand footbots in an arena of 128 m with scattered walls of 1.2 m; the arena's own four walls always exist.
/// @param walls number of scattered walls @param are_held whether the engine has them; otherwise only sensors detect
/// them
std::string maze(int walls, bool are_held) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> aside(-0.5, 0.5);
  constexpr int kPerLine = 32;
  constexpr double kApart = 4.0;  // m
  std::string blocks;
  std::string members;
  for (int i = 0; i < walls; ++i) {
    const double x = (i % kPerLine + 0.5) * kApart + aside(random);
    const double y = (i / kPerLine + 0.5) * kApart + aside(random);
    const std::string name = "id='wall_" + std::to_string(i) + "'";
    members += are_held ? "<entity " + name + "/>" : "";
    blocks += "<block " + name + "><size>1.2,0.05,0.3</size><position>" + std::to_string(x) + "," + std::to_string(y) +
              ",0</position><orientation>" + (random() % 2 == 0 ? "0" : "90") + ",0,0</orientation></block>";
  }
  std::string text =
      diffusionExperiment(1000, kApart * kApart * kPerLine * kPerLine / 1000.0, "<kinematics2d id='ground'/>");
  text.insert(text.find("<distribute"), blocks);
  text.insert(text.find("<entity id='fb'/>"), members);
  return text;
}

/// Duration of the phases, measured over some more ticks [ns per robot and tick].
void reportPhases(benchmark::State& state, Simulation& simulation, std::int64_t robots) {
  constexpr int kTicks = 50;
  PhaseTimes sum;
  simulation.timePhases();
  for (int i = 0; i < kTicks; ++i) {
    simulation.tick();
    sum += simulation.phaseTimes();
  }
  const auto report = [&](const char* phase, double seconds) {
    state.counters[phase] = 1e9 * seconds / static_cast<double>(kTicks * robots);
  };
  report("sense_ns", sum.sense);
  report("control_ns", sum.control);
  report("actuate_ns", sum.actuate);
  report("move_ns", sum.move);
  report("index_ns", sum.index);
}

void run(benchmark::State& state, const std::string& experiment, std::int64_t robots) {
  loadBuiltInPlugins();
  Simulation simulation(parseExperiment(experiment, "benchmark.xml"));
  simulation.start();
  constexpr int kWarmUp = 50;
  for (int i = 0; i < kWarmUp; ++i) {
    simulation.tick();
  }
  for (auto _ : state) {
    simulation.tick();
  }
  state.SetItemsProcessed(state.iterations() * robots);
  reportPhases(state, simulation, robots);
}

void runBare(benchmark::State& state, double area_per_robot) {
  BareDiffusion bare(static_cast<int>(state.range(0)), area_per_robot);
  constexpr int kWarmUp = 50;
  for (int i = 0; i < kWarmUp; ++i) {
    bare.tick();
  }
  for (auto _ : state) {
    bare.tick();
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void BM_DiffusionSparse(benchmark::State& state) { run(state, diffusion(state, kSparse), state.range(0)); }
void BM_DiffusionDense(benchmark::State& state) { run(state, diffusion(state, kDense), state.range(0)); }
void BM_BareSparse(benchmark::State& state) { runBare(state, kSparse); }
void BM_BareDense(benchmark::State& state) { runBare(state, kDense); }
void BM_MessagesSparse(benchmark::State& state) { run(state, talking(state), state.range(0)); }

/// The second argument is the number of threads.
void BM_DiffusionThreads(benchmark::State& state) {
  std::string text = diffusion(state, kSparse);
  const std::string threads = "<threads>" + std::to_string(state.range(1)) + "</threads>";
  text.insert(text.find("</framework>"), threads);
  run(state, text, state.range(0));
}

/// The first argument is the number of walls, the second whether the engine has them.
void BM_Maze(benchmark::State& state) { run(state, maze(static_cast<int>(state.range(0)), state.range(1) != 0), 1000); }

BENCHMARK(BM_Maze)->Args({0, 1})->Args({1000, 0})->Args({1000, 1})->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_DiffusionSparse)->Arg(10)->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_BareSparse)->Arg(10)->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_BareDense)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_DiffusionDense)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_DiffusionThreads)->ArgsProduct({{10000, 100000}, {1, 2}})->UseRealTime()->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_MessagesSparse)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::Talker, "talker")

BENCHMARK_MAIN();
