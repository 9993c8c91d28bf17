// Every installed experiment has metrics, and rules that only measure do not change a run, with any number of threads.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "installed_experiment.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"

namespace swarmanoid::test {
namespace {

namespace fs = std::filesystem;

std::set<std::string> installedNames() {
  std::set<std::string> names;
  for (const auto& file : fs::directory_iterator(findShared("swarmanoid_experiments", "experiments"))) {
    if (file.path().extension() == ".xml") {
      names.insert(file.path().stem());
    }
  }
  return names;
}

TEST(InstalledMetricsTest, EveryInstalledExperimentHasSome) {
  const std::set<std::string> names = installedNames();
  EXPECT_GE(names.size(), 17U);
  for (const std::string& name : names) {
    const auto simulation = installed(name, 1);
    simulation->tick();
    EXPECT_FALSE(simulation->metrics().empty()) << name;
  }
}

struct Traces {
  std::vector<std::uint64_t> hashes;
  std::vector<Metrics> metrics;
};

Traces run(const std::string& name, bool is_measured, int threads) {
  loadBuiltInPlugins();
  Experiment experiment = readExperiment(findShared("swarmanoid_experiments", "experiments/" + name + ".xml"), {});
  experiment.framework.threads = threads;
  if (!is_measured) {
    experiment.rules.clear();
  }
  Simulation simulation(std::move(experiment));
  simulation.start();
  Traces traces;
  constexpr int kTicks = 60;
  for (int i = 0; i < kTicks; ++i) {
    simulation.tick();
    traces.hashes.push_back(simulation.stateHash());
    traces.metrics.push_back(simulation.metrics());
  }
  return traces;
}

/// Experiments whose rules only measure.
class MeasuredExperimentTest : public testing::TestWithParam<const char*> {};

TEST_P(MeasuredExperimentTest, RunsTheSameWithoutItsRulesAndMeasuresTheSameOnAnyNumberOfThreads) {
  const Traces measured = run(GetParam(), true, 1);
  EXPECT_NE(measured.metrics.back(), Metrics{});
  EXPECT_EQ(measured.hashes, run(GetParam(), false, 1).hashes);
  EXPECT_EQ(measured.metrics, run(GetParam(), true, 4).metrics);
}

INSTANTIATE_TEST_SUITE_P(Experiments, MeasuredExperimentTest,
                         testing::Values("diffusion", "rough_terrain", "gap", "climbing", "shelf_retrieval"),
                         [](const auto& name) { return std::string(name.param); });

/// Covers the experiments whose success can be judged, over the whole run.
TEST(InstalledMetricsTest, WhatCrossesAndClimbsSucceeds) {
  for (const char* name : {"gap", "climbing", "shelf_retrieval"}) {
    const auto simulation = installed(name, 1);
    EXPECT_EQ(simulation->success(), false) << name << " has not begun";
    finish(*simulation);
    EXPECT_EQ(simulation->success(), true) << name;
  }
}

}  // namespace
}  // namespace swarmanoid::test
