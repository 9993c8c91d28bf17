// Whole ticks of the diffusion experiment, one thread, no ROS: robots x ticks per second (items_per_second).
//
// Sparse: one footbot on each 1.6 square metres; dense: one on each 0.1. 24 proximity rays of 10 cm, tick 100 ms,
// subclock 1, collision shapes of thesis figure 3.9.
#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "swarmanoid_space/simulation.hpp"

namespace swarmanoid {
namespace {

std::string diffusionXml(int robots, double area_per_robot) {
  const double side = std::sqrt(robots * area_per_robot);
  const std::string length = std::to_string(side);
  const std::string low = std::to_string(0.15);
  const std::string high = std::to_string(side - 0.15);
  return "<ahss-config><framework><clocktick>100</clocktick><maxclock>1000000000</maxclock></framework><controllers>"
         "<diffusion id=\"dc\" library=\"diffusion\"><actuators><footbot_wheels/></actuators><sensors>"
         "<footbot_proximity><range>0.1</range></footbot_proximity></sensors></diffusion></controllers><arena size=\"" +
         length + "," + length + ",1\" optimization=\"2D\" bounded=\"true\"><distribute quantity=\"" +
         std::to_string(robots) + "\" layout=\"uniform\"><minimum>" + low + "," + low + ",0</minimum><maximum>" + high +
         "," + high +
         ",0</maximum><max_trials>100000</max_trials><footbot id=\"fb\"><controller>dc</controller></footbot>"
         "</distribute></arena><engines><kinematics2d id=\"ground\"/></engines><arena_physics><engine id=\"ground\">"
         "<entity id=\"fb\"/></engine></arena_physics></ahss-config>";
}

void diffuse(benchmark::State& state, double area_per_robot) {
  const auto robots = static_cast<int>(state.range(0));
  loadBuiltInPlugins();
  Simulation simulation(parseExperiment(diffusionXml(robots, area_per_robot), "diffusion.xml"));
  simulation.start();
  constexpr int kWarmUp = 50;
  for (int i = 0; i < kWarmUp; ++i) {
    simulation.tick();
  }
  for (auto _ : state) {
    simulation.tick();
  }
  state.SetItemsProcessed(state.iterations() * robots);
}

void BM_DiffusionSparse(benchmark::State& state) { diffuse(state, 1.6); }
void BM_DiffusionDense(benchmark::State& state) { diffuse(state, 0.1); }

BENCHMARK(BM_DiffusionSparse)->Arg(10)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_DiffusionDense)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace swarmanoid

BENCHMARK_MAIN();
