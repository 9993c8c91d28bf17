// Cost of an active world: a rule that reads every robot after each tick, and a painted floor that fades.
//
// Rule: sparse diffusion of simulation_benchmark.cpp; `rule_share` is the rule's part of a tick, `rule_us` its
// duration. Measure: the same with the measuring rules of the suite, and for contacts in a crowd.
// Floor: 100 footbots that read it, on 10 m x 10 m; all of its 1,000 x 1,000 cells are painted, and fade. The benchmark
// measures a tick with its state hash on the clean floor, on the painted one, and while 100 discs of about 50 cells are
// painted before each tick.
#include <benchmark/benchmark.h>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/testing/diffusion_experiment.hpp"
#include "swarmanoid_space/rule.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {
namespace {

/// Computes the mean position of all robots, and the number of robots within a metre of the origin.
class Watcher final : public Rule {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "watcher";
    return description;
  }
  void configure(const Configuration&) override {
    middle_ = &addMetric("middle", "m", "Distance of the mean place from the origin.");
    near_ = &addMetric("near", "", "Robots within a metre of the origin.");
  }
  void afterTick(const Space& space, InterventionQueue&) override {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double near = 0.0;
    for (const Row row : space.entities.order) {
      if (space.entities.model[row]->is_robot) {
        const Eigen::Vector3d& position = space.entities.pose[row].position;
        sum += position;
        near += position.squaredNorm() < 1.0 ? 1.0 : 0.0;
      }
    }
    middle_->value = sum.norm() / static_cast<double>(space.entities.order.size());
    near_->value = near;
  }

 private:
  Metric* middle_ = nullptr;
  Metric* near_ = nullptr;
};

std::string with(std::string text, const std::string& before, const std::string& added) {
  return text.insert(text.find(before), added);
}

std::unique_ptr<Simulation> start(const std::string& text) {
  loadBuiltInPlugins();
  auto simulation = std::make_unique<Simulation>(parseExperiment(text, "benchmark.xml"));
  simulation->timePhases();
  simulation->start();
  constexpr int kWarmUp = 50;
  for (int i = 0; i < kWarmUp; ++i) {
    simulation->tick();
  }
  return simulation;
}

void measureRule(benchmark::State& state, const std::string& rule, double area_each) {
  const auto simulation =
      start(with(diffusionExperiment(static_cast<int>(state.range(0)), area_each, "<kinematics2d id='ground'/>"),
                 "</ahss-config>", "<rules>" + rule + "</rules>"));
  double of_rule = 0.0;
  double of_all = 0.0;
  for (auto _ : state) {
    simulation->tick();
    const PhaseTimes& times = simulation->phaseTimes();
    of_rule += times.rule;
    of_all += times.sense + times.control + times.actuate + times.move + times.connect + times.index + times.power +
              times.rule + times.show;
  }
  state.counters["rule_share"] = of_rule / of_all;
  state.counters["rule_us"] = 1e6 * of_rule / static_cast<double>(state.iterations());
}

constexpr double kSparse = 1.6;  // m2 per robot

void BM_Rule(benchmark::State& state) { measureRule(state, "<watcher id='w'/>", kSparse); }
void BM_Measure(benchmark::State& state, const char* rule) { measureRule(state, rule, kSparse); }
void BM_MeasureCrowd(benchmark::State& state, const char* rule) {
  constexpr double kCrowded = 0.2;  // m2
  measureRule(state, rule, kCrowded);
}

enum class Paint { kNone, kAll, kAnew };

void BM_Floor(benchmark::State& state) {
  const auto paint = static_cast<Paint>(state.range(0));
  std::string text = diffusionExperiment(100, 1.0, "<kinematics2d id='ground'/>");
  text = with(text, "<footbot_proximity>", "<footbot_ground/>");
  text = with(text, "<distribute", "<floor_paint><cell>0.01</cell><half_life>1000000</half_life></floor_paint>");
  const auto simulation = start(text);
  if (paint != Paint::kNone) {
    simulation->apply(PaintFloor{{{{5.0, 5.0}, 8.0, colors::kBlack, 1.0}}});
  }
  PaintFloor anew;
  for (int i = 0; i < 100; ++i) {
    anew.discs.push_back({{0.5 + i % 10, 0.5 + i / 10}, 0.04, colors::kRed, 0.3});
  }
  for (auto _ : state) {
    if (paint == Paint::kAnew) {
      simulation->apply(anew);
    }
    simulation->tick();
    benchmark::DoNotOptimize(simulation->stateHash());
  }
  state.counters["cells"] = static_cast<double>(simulation->space().floor.paint.spotCount());
}

BENCHMARK(BM_Rule)->Arg(10000)->Unit(benchmark::kMicrosecond);
#define SWARMANOID_MEASURE(function, name, rule) \
  BENCHMARK_CAPTURE(function, name, rule)->Arg(10000)->Unit(benchmark::kMicrosecond)
SWARMANOID_MEASURE(BM_Measure, distance_to_place, "<distance_to id='r'><to>1, 2</to></distance_to>");
SWARMANOID_MEASURE(BM_Measure, distance_to_line, "<distance_to id='r'><to>1, 2, 30, 40</to></distance_to>");
SWARMANOID_MEASURE(BM_Measure, distance_to_nearest, "<distance_to id='r'><to>footbot</to></distance_to>");
SWARMANOID_MEASURE(BM_Measure, distance_to_nearest_every_10,
                   "<distance_to id='r'><to>footbot</to><every>10</every></distance_to>");
SWARMANOID_MEASURE(BM_Measure, robot_clusters, "<robot_clusters id='r'/>");
SWARMANOID_MEASURE(BM_Measure, area_coverage, "<area_coverage id='r'/>");
SWARMANOID_MEASURE(BM_Measure, square_displacement, "<square_displacement id='r'/>");
SWARMANOID_MEASURE(BM_Measure, swarm_order, "<swarm_order id='r'/>");
SWARMANOID_MEASURE(BM_Measure, state_times, "<state_times id='r'><states>a, b</states></state_times>");
SWARMANOID_MEASURE(BM_Measure, region_count,
                   "<region_count id='r'><minimum>0, 0, 0</minimum><maximum>9, 9, 0</maximum></region_count>");
SWARMANOID_MEASURE(BM_Measure, contact_count, "<contact_count id='r'/>");
SWARMANOID_MEASURE(BM_MeasureCrowd, contact_count, "<contact_count id='r'/>");
SWARMANOID_MEASURE(BM_MeasureCrowd, distance_to_nearest, "<distance_to id='r'><to>footbot</to></distance_to>");
SWARMANOID_MEASURE(BM_Measure, energy_use, "<energy_use id='r'/>");
BENCHMARK(BM_Floor)
    ->Arg(static_cast<int>(Paint::kNone))
    ->Arg(static_cast<int>(Paint::kAll))
    ->Arg(static_cast<int>(Paint::kAnew))
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace swarmanoid

REGISTER_RULE(swarmanoid::Watcher)

BENCHMARK_MAIN();
