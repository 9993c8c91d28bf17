// The rule `switching_lamp`: the lamp that is lit in each tick, and the distance of robots from it. No engine moves
// anything here; with driving robots: swarmanoid_experiments/test/phototaxis_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {
namespace {

/// Ticks of 0.1 s. The lamp is lit for 0.39 of 1.3 s: in the ticks 0 to 3 of each 13.
constexpr const char* kLamps = "<lamp>a</lamp><other>b</other><period>1.3</period><duty>0.3</duty>";
constexpr std::uint64_t kPeriod = 13;  // ticks
constexpr std::uint64_t kLitFor = 4;   // ticks: 3.9 rounded up, as the beginning of a tick counts

bool isFirstLitIn(std::uint64_t tick) { return tick % kPeriod < kLitFor; }

Experiment lamps(const std::string& parameters) {
  loadPluginLibrary("swarmanoid_devices", {}, {});
  return parseExperiment(R"(<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>100000</maxclock></framework>
  <arena size="5,5,3" optimization="2D">
    <light id="a"><position>1, 1, 2</position><orientation>0, 0, 0</orientation></light>
    <light id="b"><position>4, 1, 2</position><orientation>0, 0, 0</orientation><intensity>0.25</intensity></light>
    <footbot id="fb_1"><position>1.3, 1.4, 0</position><orientation>0, 0, 0</orientation></footbot>
    <footbot id="fb_2"><position>4, 2.1, 0</position><orientation>0, 0, 0</orientation></footbot>
  </arena>
  <rules><switching_lamp id="s"><intensity>2.5</intensity>)" +
                             parameters + "</switching_lamp></rules></ahss-config>",
                         "lamps.xml");
}

class SwitchingLampTest : public testing::Test {
 protected:
  explicit SwitchingLampTest(const std::string& parameters = kLamps) : simulation(lamps(parameters)) {
    simulation.start();
  }

  double metric(const std::string& name) const { return std::get<double>(simulation.metrics().at("s." + name)); }
  double intensity(const std::string& lamp) const {
    return *simulation.space().property(simulation.space().entities.find(lamp), kIntensity);
  }

  Simulation simulation;
};

TEST_F(SwitchingLampTest, OneLampIsLitAndThenTheOther) {
  for (std::uint64_t tick = 0; tick < 5 * kPeriod; ++tick) {
    simulation.tick();
    EXPECT_EQ(intensity("a"), isFirstLitIn(tick) ? 2.5 : 0.0) << tick;
    EXPECT_EQ(intensity("b"), isFirstLitIn(tick) ? 0.0 : 2.5) << tick;
  }
  EXPECT_EQ(metric("switches"), 9.0);
}

TEST_F(SwitchingLampTest, RobotsAreMeasuredToTheLampThatIsLit) {
  simulation.tick();
  // from a: fb_1 at (0.3, 0.4), fb_2 at (3, 1.1); from b: (-2.7, 0.4) and (0, 1.1)
  const double to_a = 0.5 * (0.5 + std::sqrt(9.0 + 1.21));
  const double to_b = 0.5 * (std::sqrt(7.29 + 0.16) + 1.1);
  EXPECT_NEAR(metric("distance"), to_a, 1e-12);
  EXPECT_EQ(metric("distance_before_switch"), 0.0) << "there was none";
  for (std::uint64_t tick = 1; tick <= kLitFor; ++tick) {
    simulation.tick();
  }
  EXPECT_NEAR(metric("distance"), to_b, 1e-12);
  EXPECT_NEAR(metric("distance_before_switch"), to_a, 1e-12);
  while (simulation.space().tick <= kPeriod + kLitFor) {
    simulation.tick();
  }
  EXPECT_EQ(metric("switches"), 3.0);
  EXPECT_NEAR(metric("distance_before_switch"), (2.0 * to_a + to_b) / 3.0, 1e-12);
}

TEST_F(SwitchingLampTest, WhatSomebodyElseSwitchesIsPutRight) {
  simulation.tick();
  simulation.apply(SetProperty{"a", kIntensity, "0"});
  simulation.tick();
  EXPECT_EQ(intensity("a"), 2.5);
  EXPECT_EQ(metric("switches"), 0.0) << "of the rule";
}

TEST_F(SwitchingLampTest, ALampThatIsDeletedStaysSo) {
  simulation.tick();
  simulation.apply(DeleteEntity{"b"});
  for (std::uint64_t tick = 1; tick <= kLitFor; ++tick) {
    simulation.tick();
  }
  EXPECT_EQ(intensity("a"), 0.0);
  EXPECT_EQ(metric("distance"), 0.0) << "no lamp is lit";
}

TEST_F(SwitchingLampTest, AResetStartsAnew) {
  while (simulation.space().tick <= kLitFor) {
    simulation.tick();
  }
  simulation.reset();
  EXPECT_EQ(metric("switches"), 0.0);
  EXPECT_EQ(intensity("b"), 0.25) << "as in the file";
  simulation.tick();
  EXPECT_EQ(intensity("a"), 2.5);
  EXPECT_EQ(intensity("b"), 0.0);
  EXPECT_EQ(metric("switches"), 0.0);
}

TEST_F(SwitchingLampTest, ATickWithoutASwitchTouchesNoHeap) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  while (simulation.space().tick < 3 * kPeriod) {
    simulation.tick();
  }
  for (std::uint64_t tick = 3 * kPeriod; tick < 8 * kPeriod; ++tick) {
    const bool is_switch = isFirstLitIn(tick) != isFirstLitIn(tick - 1);
    const long before = heap_allocations;
    simulation.tick();
    const long made = heap_allocations - before;
    // the tick after a switch clears its events
    if (!is_switch && isFirstLitIn(tick) == isFirstLitIn(tick - 2)) {
      EXPECT_EQ(made, 0) << tick;
    }
  }
}

class SingleLampTest : public SwitchingLampTest {
 protected:
  SingleLampTest() : SwitchingLampTest("<lamp>a</lamp><period>1</period><duty>0</duty>") {}
};

TEST_F(SingleLampTest, ADutyOfZeroIsDarknessAndNoSwitch) {
  for (int i = 0; i < 25; ++i) {
    simulation.tick();
    EXPECT_EQ(intensity("a"), 0.0);
    EXPECT_EQ(intensity("b"), 0.25) << "not one of the rule";
  }
  EXPECT_EQ(SwitchingLampTest::metric("switches"), 0.0);
  EXPECT_EQ(SwitchingLampTest::metric("distance"), 0.0);
}

TEST(SwitchingLampMistakesTest, AreRefusedWithTheirPlace) {
  const auto refusal = [](const std::string& parameters) -> std::string {
    try {
      const Simulation simulation(lamps(parameters));
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "(accepted)";
  };
  EXPECT_EQ(
      refusal("<lamp>aa</lamp>"),
      "lamps.xml:9: lamp: found 'aa', allowed: the id of what has the property intensity (a, b); did you mean 'a'?");
  EXPECT_EQ(refusal("<lamp>a</lamp><other>fb_1</other>"),
            "lamps.xml:9: other: found 'fb_1', allowed: the id of what has the property intensity (a, b)");
  EXPECT_EQ(refusal("<lamp>a</lamp><other>a</other>"),
            "lamps.xml:9: other: found 'a', allowed: another lamp than lamp");
}

}  // namespace
}  // namespace swarmanoid::test
