// Combined errors of a device: their order, repeated ticks, bounds of fields, lists, and allocations.
#include "swarmanoid_space/error_models/error_chain.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

#include "error_probe.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

namespace swarmanoid::test {
namespace {

TEST(ErrorChainTest, ErrorsActInTheirOrder) {
  ErrorChain chain(probeType());
  chain.add(error("bias", "free", {{"offset", "1"}}));
  chain.add(error("saturation", "free", {{"minimum", "-5"}, {"maximum", "5"}}));
  chain.add(error("factor", "free", {{"mean", "2"}}));
  ErrorState state = chain.makeState(1, "robot", 0);
  Probe probe;
  probe.free = 4.5;
  chain.apply(&probe, state, 0);
  EXPECT_EQ(probe.free, 10.0);
}

TEST(ErrorChainTest, ATickThatIsMadeAgainHasTheSameErrors) {
  ErrorChain chain(probeType());
  chain.add(error("random_walk", "free", {{"deviation", "0.5"}}));
  chain.add(error("drop_out", "free", {{"probability", "0.5"}}));
  chain.add(error("latency", "free", {{"ticks", "2"}}));
  ErrorState once = chain.makeState(1, "robot", 0);
  ErrorState often = chain.makeState(1, "robot", 0);
  for (std::uint64_t tick = 0; tick < 200; ++tick) {
    Probe expected;
    expected.free = ramp(tick);
    chain.apply(&expected, once, tick);
    Probe probe;
    for (int i = 0; i < 3; ++i) {
      probe.free = i < 2 ? -9.0 : ramp(tick);  // the reading differs before an intervention
      chain.apply(&probe, often, tick);
    }
    ASSERT_EQ(expected.free, probe.free) << "tick " << tick;
  }
}

TEST(ErrorChainTest, AnErrorDrawsTheSameWhateverStandsBesideIt) {
  const ErrorModelDescription noise = error("gaussian", "free", {{"deviation", "1"}});
  const auto alone = overTicks(noise, constant, 50);
  ErrorChain chain(probeType());
  chain.add(error("uniform", "value", {{"half_width", "0.1"}}));
  chain.add(noise);
  chain.add(error("gaussian", "heading", {{"deviation", "1"}}));
  ErrorState state = chain.makeState(7, "robot", 0);
  ErrorChain twice(probeType());
  twice.add(noise);
  twice.add(noise);
  ErrorState of_twice = twice.makeState(7, "robot", 0);
  for (std::size_t tick = 0; tick < 50; ++tick) {
    Probe probe;
    probe.free = constant(tick);
    chain.apply(&probe, state, tick);
    EXPECT_EQ(probe.free, alone[tick]);
    EXPECT_GT(std::abs(probe.heading - wrapAngle(probe.free - 3.0)), 1e-9) << "two fields draw different numbers";
    probe.free = constant(tick);
    twice.apply(&probe, of_twice, tick);
    EXPECT_GT(std::abs(probe.free - alone[tick] - (alone[tick] - 3.0)), 1e-9)
        << "two of one kind and field draw different numbers";
  }
}

TEST(ErrorChainTest, ReadingsStayInTheirRangeAndAnglesWrap) {
  ErrorChain chain(probeType());
  chain.add(error("gaussian", "", {{"deviation", "2"}}));
  ErrorState state = chain.makeState(1, "robot", 4);
  int wrapped = 0;
  int at_bounds = 0;
  for (std::uint64_t tick = 0; tick < 1000; ++tick) {
    Probe probe;
    probe.heading = 3.0;
    chain.apply(&probe, state, tick);
    for (const float value : probe.value) {
      ASSERT_TRUE(value >= 0.0F && value <= 1.0F);
      at_bounds += value == 0.0F || value == 1.0F ? 1 : 0;
    }
    ASSERT_LE(std::abs(probe.heading), M_PI);
    wrapped += probe.heading < -2.0 ? 1 : 0;
    ASSERT_FALSE(probe.on);
  }
  EXPECT_GT(at_bounds, 1000);
  EXPECT_GT(wrapped, 100);
}

TEST(ErrorChainTest, CommandsAreLeftToTheLimitsOfTheirActuator) {
  ErrorChain chain(*findDeviceType(ProbeCommand::kType));
  chain.add(error("bias", "amount", {{"offset", "5"}}));
  ErrorState state = chain.makeState(1, "robot", 0);
  ProbeCommand command;
  chain.apply(&command, state, 0);
  EXPECT_EQ(command.amount, 5.0);
}

TEST(ErrorChainTest, WholeNumbersAreRoundedAndNothingOverflows) {
  ErrorChain chain(probeType());
  chain.add(error("factor", "level", {{"mean", "1.5"}}));
  chain.add(error("factor", "free", {{"mean", "1000"}}));
  ErrorState state = chain.makeState(1, "robot", 0);
  for (const auto& [level, expected] : {std::pair(3, 4), std::pair(5, 8), std::pair(255, 255)}) {
    Probe probe;
    probe.level = static_cast<std::uint8_t>(level);
    probe.free = 1e308;
    chain.apply(&probe, state, 0);
    EXPECT_EQ(probe.level, expected);
    EXPECT_TRUE(std::isfinite(probe.free));
  }
}

TEST(ErrorChainTest, ElementsOfAListAreDisturbedInAPlaceOfTheirOwn) {
  ErrorChain chain(probeType());
  chain.add(error("factor_spread", "echoes[].distance", {{"deviation", "0.5"}}));
  chain.add(error("gaussian", "echoes[].strength", {{"deviation", "1"}}));
  ErrorState state = chain.makeState(1, "robot", 4);
  std::vector<Echo> echoes{{1.0F, 0.5F}, {2.0F, 0.5F}, {4.0F, 0.5F}};
  Probe probe;
  probe.echoes = echoes;
  chain.apply(&probe, state, 0);
  ASSERT_EQ(probe.echoes.size(), 3U);
  EXPECT_NE(probe.echoes[0].distance, 1.0F);
  EXPECT_FLOAT_EQ(probe.echoes[2].distance, 4.0F * probe.echoes[0].distance) << "one factor for the robot";
  EXPECT_NE(probe.echoes[0].strength, probe.echoes[1].strength) << "a draw for each element";
  EXPECT_EQ(echoes[0].distance, 1.0F);
}

TEST(ErrorChainTest, AWholeListIsLateLostOrGone) {
  for (const char* kind : {"latency", "stuck", "dead"}) {
    ErrorChain chain(probeType());
    chain.add(kind[0] == 'l' ? error(kind, "echoes", {{"ticks", "2"}}) : error(kind, "echoes", {}));
    ErrorState state = chain.makeState(1, "robot", 2);
    for (std::size_t tick = 0; tick < 20; ++tick) {
      std::vector<Echo> echoes(tick % 5 + 1, Echo{static_cast<float>(tick), 0.0F});
      Probe probe;
      probe.echoes = echoes;
      chain.apply(&probe, state, tick);
      const std::size_t source = kind[0] == 'l' ? tick - 2 : 0;
      const bool is_empty = kind[0] == 'd' || (kind[0] == 'l' && tick < 2);
      ASSERT_EQ(probe.echoes.size(), is_empty ? 0 : source % 5 + 1) << kind << " in tick " << tick;
      if (!is_empty) {
        EXPECT_EQ(probe.echoes[source % 5].distance, static_cast<float>(source));
      }
    }
  }
}

TEST(ErrorChainTest, WhatIsStoredLiesWithinBoundsThatTheTypeDoesNotHave) {
  for (const bool is_above : {false, true}) {
    ErrorChain chain(*findDeviceType(ProbeBounds::kType));
    chain.add(error("bias", "", {{"offset", is_above ? "20" : "-20"}}));
    ErrorState state = chain.makeState(1, "robot", 0);
    ProbeBounds probe;
    chain.apply(&probe, state, 0);
    // the nearest single-precision numbers to 0.7 and 0.8 lie outside
    EXPECT_EQ(probe.positive, is_above ? std::nextafter(0.8F, 0.0F) : std::nextafter(0.7F, 1.0F));
    EXPECT_EQ(probe.negative, is_above ? std::nextafter(-0.7F, -1.0F) : std::nextafter(-0.8F, 0.0F));
    EXPECT_GE(static_cast<double>(probe.positive), 0.7);
    EXPECT_LE(static_cast<double>(probe.positive), 0.8);
    EXPECT_GE(static_cast<double>(probe.negative), -0.8);
    EXPECT_LE(static_cast<double>(probe.negative), -0.7);
    EXPECT_EQ(probe.whole, is_above ? 7 : 3);
  }
}

TEST(ErrorChainTest, AllFieldsOfADeviceAreLateTogether) {
  ErrorChain chain(probeType());
  chain.add(error("latency", "", {{"ticks", "2"}}));
  ErrorState state = chain.makeState(1, "robot", 0);
  const auto at = [](std::uint64_t tick) {
    Probe probe;
    probe.free = 0.5 * static_cast<double>(tick);
    for (std::size_t i = 0; i < probe.value.size(); ++i) {
      probe.value[i] = 0.01F * static_cast<float>(tick + 10 * i);
    }
    probe.heading = 0.1 * static_cast<double>(tick);
    probe.level = static_cast<std::uint8_t>(tick + 1);
    probe.on = tick % 2 == 1;
    probe.mode = tick % 3 == 1 ? Probe::Mode::kOn : Probe::Mode::kOff;
    return probe;
  };
  for (std::uint64_t tick = 0; tick < 12; ++tick) {
    Probe probe = at(tick);
    chain.apply(&probe, state, tick);
    const Probe expected = tick < 2 ? Probe() : at(tick - 2);
    EXPECT_EQ(probe.free, expected.free);
    EXPECT_EQ(probe.value, expected.value);
    EXPECT_EQ(probe.heading, expected.heading);
    EXPECT_EQ(probe.level, expected.level);
    EXPECT_EQ(probe.on, expected.on);
    EXPECT_EQ(probe.mode, expected.mode);
  }
}

TEST(ErrorChainTest, AWholeFieldErrorLeavesTheFieldsBesideIt) {
  ErrorChain chain(probeType());
  chain.add(error("dead", "value[1]", {}));
  chain.add(error("dead", "value[2]", {}));
  ErrorState state = chain.makeState(1, "robot", 0);
  Probe probe;
  probe.value = {0.1F, 0.2F, 0.3F, 0.4F};
  probe.heading = 1.0;
  chain.apply(&probe, state, 0);
  EXPECT_EQ(probe.value, (std::array<float, 4>{0.1F, 0.5F, 0.5F, 0.4F}));
  EXPECT_EQ(probe.heading, 1.0);
  EXPECT_EQ(probe.free, -1.0);
}

TEST(ErrorChainTest, TicksAllocateNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  ErrorChain chain(probeType());
  for (const ErrorKind* kind : errorKinds()) {
    std::map<std::string, std::string> parameters;
    for (const Parameter& parameter : kind->description.parameters) {
      parameters[parameter.name] = "1";
    }
    chain.add(error(kind->description.name, "", parameters));
  }
  ErrorState state = chain.makeState(1, "robot", 8);
  const std::vector<Echo> echoes(8);
  const long before = heap_allocations;
  for (std::uint64_t tick = 0; tick < 100; ++tick) {
    Probe probe;
    probe.echoes = Span<const Echo>(echoes.data(), tick % 9);
    chain.apply(&probe, state, tick);
  }
  EXPECT_EQ(heap_allocations - before, 0);
}

}  // namespace
}  // namespace swarmanoid::test
