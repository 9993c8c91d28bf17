// Whole ticks of the diffusion experiment, one thread, no ROS: robots x ticks per second (items_per_second).
//
// Sparse: one footbot on each 1.6 square metres; dense: one on each 0.1. 24 proximity rays of 10 cm, tick 100 ms,
// subclock 1, collision shapes of thesis figure 3.9.
//
// Messages: the sparse footbots stand still and send ten bytes by range and bearing in each tick; each has about 18
// others in range, with lines of sight.
#include <benchmark/benchmark.h>

#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"
#include "swarmanoid_space/testing/diffusion_experiment.hpp"

namespace swarmanoid {
namespace {

constexpr double kSparse = 1.6;  // m2 a robot
constexpr double kDense = 0.1;   // likewise

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

/// The same with other robots.
std::string talking(const benchmark::State& state) {
  std::string text = diffusion(state, kSparse);
  const std::string end = "</diffusion>";
  const std::size_t first = text.find("<diffusion");
  return text.replace(first, text.find(end) + end.size() - first,
                      "<talker id='dc' library='swarmanoid_devices'><actuators><range_and_bearing/></actuators>"
                      "<sensors><range_and_bearing_received/></sensors></talker>");
}

void run(benchmark::State& state, const std::string& experiment) {
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
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void BM_DiffusionSparse(benchmark::State& state) { run(state, diffusion(state, kSparse)); }
void BM_DiffusionDense(benchmark::State& state) { run(state, diffusion(state, kDense)); }
void BM_MessagesSparse(benchmark::State& state) { run(state, talking(state)); }

BENCHMARK(BM_DiffusionSparse)->Arg(10)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_DiffusionDense)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_MessagesSparse)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace swarmanoid

REGISTER_CONTROLLER(swarmanoid::Talker, "talker")

BENCHMARK_MAIN();
