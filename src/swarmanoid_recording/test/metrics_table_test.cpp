// The table of metrics: a header with their names, and rows of values that can be read back.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>

#include "swarmanoid_experiment_files/testing/scripted_rule.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"

namespace swarmanoid::test {
namespace {

/// Metric of rule a after a tick: numbers without a short text, large and small ones, and infinity.
double valueAfter(std::uint64_t tick) {
  switch (tick) {
    case 2:
      return 0.1 + 0.2;
    case 3:
      return -1e-300 / 3.0;
    case 4:
      return 12345678901234567.0;
    case 5:
      return std::numeric_limits<double>::infinity();
    default:
      return 0.0;
  }
}

class MetricsTableTest : public testing::Test {
 protected:
  MetricsTableTest() {
    loadPluginLibrary("swarmanoid_visualisations", {}, {});
    scripts()["a"].after = [](ScriptedRule& rule, const Space& space, InterventionQueue&) {
      rule.count->value = valueAfter(space.tick);
    };
    scripts()["b"].after = [](ScriptedRule& rule, const Space& space, InterventionQueue&) {
      rule.count->value = 2.0 * static_cast<double>(space.tick);
    };
  }

  /// Starts a run whose table has this value of `every`.
  std::unique_ptr<Simulation> start(const std::string& every) const {
    const auto table = makePlugin<Observer>(*Registry::instance().find(PluginKind::kObserver, "metrics_table"));
    Configuration parameters("metrics_table", "", {});
    parameters.set("file", file);
    parameters.set("every", every);
    table->configure("table", parameters, {});
    auto simulation = ruledWorld();
    simulation->addObserver(table);
    simulation->start();
    return simulation;
  }

  static void run(Simulation& simulation, int ticks) {
    for (int i = 0; i < ticks; ++i) {
      simulation.tick();
    }
  }

  std::string written() const {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  const TemporaryFolder folder{"metrics_table_test"};
  const std::string file = folder.path() / "metrics.csv";
};

TEST_F(MetricsTableTest, HasAHeaderAndARowForTheStartAndEachTick) {
  const auto simulation = start("1");
  run(*simulation, 2);
  simulation->finish();
  EXPECT_EQ(written(), "tick,time,a.count,b.count\n0,0,0,0\n1,0.1,0,2\n2,0.2,0.30000000000000004,4\n");
}

TEST_F(MetricsTableTest, NumbersAreReadBackAsTheyWere) {
  const auto simulation = start("1");
  run(*simulation, 5);
  simulation->finish();
  std::istringstream lines(written());
  std::string line;
  std::getline(lines, line);
  for (std::uint64_t tick = 0; tick <= 5; ++tick) {
    ASSERT_TRUE(std::getline(lines, line));
    std::istringstream cells(line);
    std::string cell;
    std::getline(cells, cell, ',');
    std::getline(cells, cell, ',');
    std::getline(cells, cell, ',');
    EXPECT_EQ(std::strtod(cell.c_str(), nullptr), valueAfter(tick)) << cell;
  }
}

TEST_F(MetricsTableTest, HasARowEveryFewTicks) {
  const auto simulation = start("3");
  run(*simulation, 7);
  simulation->finish();
  EXPECT_EQ(written(), "tick,time,a.count,b.count\n0,0,0,0\n3,0.3," + numberText(valueAfter(3)) + ",6\n6,0.6,0,12\n");
}

TEST_F(MetricsTableTest, IsThatOfTheLastRunAlone) {
  const auto simulation = start("1");
  run(*simulation, 4);
  simulation->flush();
  simulation->reset();
  run(*simulation, 1);
  simulation->finish();
  EXPECT_EQ(written(), "tick,time,a.count,b.count\n0,0,0,0\n1,0.1,0,2\n");
}

TEST_F(MetricsTableTest, WhatWasWrittenIsThereBeforeTheEnd) {
  const auto simulation = start("1");
  run(*simulation, 1);
  simulation->flush();
  EXPECT_EQ(written(), "tick,time,a.count,b.count\n0,0,0,0\n1,0.1,0,2\n");
}

}  // namespace
}  // namespace swarmanoid::test

REGISTER_RULE(swarmanoid::test::ScriptedRule)
REGISTER_CONTROLLER(swarmanoid::test::NotingController, "noting_controller")
