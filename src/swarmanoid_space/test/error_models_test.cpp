// Each kind of error on a chosen field: mean, spread and shape of 10^5 draws, or the exact values.
#include "swarmanoid_space/error_models/error_chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "error_probe.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

namespace swarmanoid::test {
namespace {

constexpr std::size_t kDraws = 100000;
const double kRoot = std::sqrt(static_cast<double>(kDraws));

/// Readings of `free` in tick after tick, of one robot whose ideal reading is `ideal(tick)`.
template <class Ideal>
std::vector<double> overTicks(const ErrorModelDescription& error, Ideal ideal, std::size_t ticks = kDraws) {
  ErrorChain chain(probeType());
  chain.add(error);
  ErrorState state = chain.makeState(7, "robot", 0);
  std::vector<double> delivered;
  for (std::size_t tick = 0; tick < ticks; ++tick) {
    Probe probe;
    probe.free = ideal(tick);
    chain.apply(&probe, state, tick);
    delivered.push_back(probe.free);
  }
  return delivered;
}

/// Readings of `free` of as many robots in one tick.
std::vector<double> overRobots(const ErrorModelDescription& error, double ideal) {
  ErrorChain chain(probeType());
  chain.add(error);
  std::vector<double> delivered;
  for (std::size_t robot = 0; robot < kDraws; ++robot) {
    ErrorState state = chain.makeState(7, "fb_" + std::to_string(robot), 0);
    for (const std::uint64_t tick : {0, 1}) {
      Probe probe;
      probe.free = ideal;
      chain.apply(&probe, state, tick);
      if (tick == 0) {
        delivered.push_back(probe.free);
      }
      EXPECT_EQ(delivered.back(), probe.free) << "it stays for the whole run";
    }
  }
  return delivered;
}

double normal(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

/// The test of Kolmogorov and Smirnov at the level 0.001, and mean and deviation within four standard errors.
template <class Distribution>
void expectDistribution(std::vector<double> values, double mean, double deviation, Distribution distribution) {
  const auto count = static_cast<double>(values.size());
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  double squares = 0.0;
  for (const double value : values) {
    squares += (value - sum / count) * (value - sum / count);
  }
  EXPECT_NEAR(sum / count, mean, 4.0 * deviation / kRoot);
  // the standard error of a deviation is at most that of normal numbers for the shapes here
  EXPECT_NEAR(std::sqrt(squares / count), deviation, 4.0 * deviation / (std::sqrt(2.0) * kRoot));
  std::sort(values.begin(), values.end());
  double distance = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double expected = distribution(values[i]);
    distance =
        std::max({distance, expected - static_cast<double>(i) / count, static_cast<double>(i + 1) / count - expected});
  }
  EXPECT_LT(distance, 1.95 / kRoot);
}

void expectNormal(const std::vector<double>& values, double mean, double deviation) {
  expectDistribution(values, mean, deviation, [&](double x) { return normal((x - mean) / deviation); });
}

double constant(std::size_t /*tick*/) { return 3.0; }
double ramp(std::size_t tick) { return 0.25 * static_cast<double>(tick) + 1.0; }

TEST(ErrorModelTest, GaussianIsNormalAroundTheIdealValue) {
  expectNormal(overTicks(error("gaussian", "free", {{"deviation", "0.2"}}), constant), 3.0, 0.2);
}

TEST(ErrorModelTest, UniformStaysWithinItsHalfWidth) {
  const auto values = overTicks(error("uniform", "free", {{"half_width", "0.5"}}), constant);
  expectDistribution(values, 3.0, 0.5 / std::sqrt(3.0), [](double x) { return std::clamp(x - 2.5, 0.0, 1.0); });
}

TEST(ErrorModelTest, FactorMultipliesWithANormalNumber) {
  expectNormal(overTicks(error("factor", "free", {{"mean", "1.1"}, {"deviation", "0.2"}}), constant), 3.3, 0.6);
  const auto standing = overTicks(
      error("factor", "free", {{"mean", "1.1"}, {"deviation", "0.2"}}), [](std::size_t) { return 0.0; }, 1000);
  EXPECT_EQ(standing, std::vector<double>(1000, 0.0));
}

TEST(ErrorModelTest, BiasSaturationAndQuantisationAreExact) {
  const auto biased = overTicks(error("bias", "free", {{"offset", "-0.5"}}), ramp);
  const auto limited = overTicks(error("saturation", "free", {{"minimum", "10"}, {"maximum", "100"}}), ramp);
  const auto rounded = overTicks(error("quantisation", "free", {{"step", "0.75"}}), ramp);
  for (std::size_t i = 0; i < kDraws; ++i) {
    ASSERT_EQ(biased[i], ramp(i) - 0.5);
    ASSERT_EQ(limited[i], std::min(std::max(ramp(i), 10.0), 100.0));
    ASSERT_LE(std::abs(rounded[i] - ramp(i)), 0.375);
    ASSERT_EQ(std::remainder(rounded[i], 0.75), 0.0);
  }
}

TEST(ErrorModelTest, QuantisationHasAUniformErrorOfItsStep) {
  std::vector<double> errors;
  const auto fine = [](std::size_t tick) { return std::fmod(0.6180339887498949 * static_cast<double>(tick), 1.0); };
  const auto rounded = overTicks(error("quantisation", "free", {{"step", "0.1"}}), fine);
  for (std::size_t i = 0; i < kDraws; ++i) {
    errors.push_back(rounded[i] - fine(i));
  }
  expectDistribution(errors, 0.0, 0.1 / std::sqrt(12.0), [](double x) { return (x + 0.05) / 0.1; });
}

TEST(ErrorModelTest, ARandomWalkHasNormalSteps) {
  const auto walk = overTicks(error("random_walk", "free", {{"deviation", "0.01"}}), constant);
  std::vector<double> steps{walk[0] - 3.0};
  for (std::size_t i = 1; i < kDraws; ++i) {
    steps.push_back(walk[i] - walk[i - 1]);
  }
  expectNormal(steps, 0.0, 0.01);
}

TEST(ErrorModelTest, SpreadsAreNormalBetweenRobots) {
  expectNormal(overRobots(error("offset_spread", "free", {{"deviation", "0.3"}}), 2.0), 2.0, 0.3);
  expectNormal(overRobots(error("factor_spread", "free", {{"deviation", "0.1"}}), 2.0), 2.0, 0.2);
}

TEST(ErrorModelTest, ADropOutRepeatsWhatCameLast) {
  const double probability = 0.3;
  const auto delivered = overTicks(error("drop_out", "free", {{"probability", "0.3"}}), ramp);
  double drops = 0.0;
  double pairs = 0.0;
  bool was_dropped = false;
  for (std::size_t i = 0; i < kDraws; ++i) {
    const bool is_dropped = delivered[i] != ramp(i);
    if (is_dropped) {
      ASSERT_EQ(delivered[i], i == 0 ? Probe().free : delivered[i - 1]);
    }
    drops += is_dropped ? 1.0 : 0.0;
    pairs += is_dropped && was_dropped ? 1.0 : 0.0;
    was_dropped = is_dropped;
  }
  EXPECT_NEAR(drops / kDraws, probability, 4.0 * std::sqrt(probability * (1.0 - probability)) / kRoot);
  // draws of neighbouring ticks are independent; neighbouring pairs share a tick
  const double pair = probability * probability;
  const double variance = pair * (1.0 - pair) + 2.0 * (pair * probability - pair * pair);
  EXPECT_NEAR(pairs / kDraws, pair, 4.0 * std::sqrt(variance) / kRoot);
}

TEST(ErrorModelTest, LatencyIsExact) {
  for (const std::size_t ticks : {1U, 3U, 10U}) {
    const auto late = overTicks(error("latency", "free", {{"ticks", std::to_string(ticks)}}), ramp, 1000);
    ErrorModelDescription later = error("latency", "free", {{"ticks", std::to_string(ticks)}});
    later.from_tick = 500;
    const auto from_500 = overTicks(later, ramp, 1000);
    for (std::size_t i = 0; i < 1000; ++i) {
      ASSERT_EQ(late[i], i < ticks ? Probe().free : ramp(i - ticks)) << ticks << " in tick " << i;
      ASSERT_EQ(from_500[i], i < 500 ? ramp(i) : ramp(i - ticks)) << ticks << " in tick " << i;
    }
  }
}

TEST(ErrorModelTest, FaultsBeginInTheirTick) {
  for (const char* kind : {"stuck", "dead"}) {
    ErrorModelDescription fault = error(kind, "free", {});
    fault.from_tick = 40;
    const auto delivered = overTicks(fault, ramp, 100);
    for (std::size_t i = 0; i < 100; ++i) {
      const double faulty = kind[0] == 's' ? ramp(40) : Probe().free;
      ASSERT_EQ(delivered[i], i < 40 ? ramp(i) : faulty) << kind << " in tick " << i;
    }
  }
  ErrorModelDescription noise = error("gaussian", "free", {{"deviation", "1"}});
  noise.from_tick = 40;
  const auto noisy = overTicks(noise, ramp, 100);
  for (std::size_t i = 0; i < 100; ++i) {
    ASSERT_EQ(noisy[i] == ramp(i), i < 40);
  }
  ErrorModelDescription drop = error("drop_out", "free", {{"probability", "1"}});
  drop.from_tick = 40;
  EXPECT_EQ(overTicks(drop, ramp, 100).back(), ramp(39));
}

TEST(ErrorModelTest, ErrorsActInTheirOrder) {
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

TEST(ErrorModelTest, ATickThatIsMadeAgainHasTheSameErrors) {
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
      probe.free = i < 2 ? -9.0 : ramp(tick);  // the world was another one before somebody intervened
      chain.apply(&probe, often, tick);
    }
    ASSERT_EQ(expected.free, probe.free) << "tick " << tick;
  }
}

TEST(ErrorModelTest, AnErrorDrawsTheSameWhateverStandsBesideIt) {
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
    EXPECT_NE(probe.heading, probe.free - 3.0);
    probe.free = constant(tick);
    twice.apply(&probe, of_twice, tick);
    EXPECT_NE(probe.free - alone[tick], alone[tick] - 3.0) << "two of one kind and field draw different numbers";
  }
}

TEST(ErrorModelTest, ReadingsStayInTheirRangeAndAnglesWrap) {
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

TEST(ErrorModelTest, CommandsAreLeftToTheLimitsOfTheirActuator) {
  ErrorChain chain(*findDeviceType(ProbeCommand::kType));
  chain.add(error("bias", "amount", {{"offset", "5"}}));
  ErrorState state = chain.makeState(1, "robot", 0);
  ProbeCommand command;
  chain.apply(&command, state, 0);
  EXPECT_EQ(command.amount, 5.0);
}

TEST(ErrorModelTest, WholeNumbersAreRoundedAndNothingOverflows) {
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

TEST(ErrorModelTest, ElementsOfAListAreDisturbedInAPlaceOfTheirOwn) {
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

TEST(ErrorModelTest, AWholeListIsLateLostOrGone) {
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

std::string refusalOf(const ErrorModelDescription& error, const DeviceType& device = probeType()) {
  try {
    ErrorChain(device).add(error);
  } catch (const ConfigError& problem) {
    return problem.what();
  }
  return "";
}

TEST(ErrorModelTest, RefusesWhatDoesNotSuit) {
  EXPECT_EQ(refusalOf(error("gausian", "", {})),
            "file.xml:3: found the error kind 'gausian', allowed: bias, dead, drop_out, factor, factor_spread, "
            "gaussian, latency, offset_spread, quantisation, random_walk, saturation, stuck, uniform; did you mean "
            "'gaussian'?");
  EXPECT_EQ(refusalOf(error("bias", "valeu", {{"offset", "1"}})),
            "file.xml:4: found the field 'valeu', allowed: free, value, heading, level, echoes[].distance, "
            "echoes[].strength; did you mean 'value'? (of probe_of_a_test)");
  EXPECT_EQ(refusalOf(error("bias", "on", {{"offset", "1"}})),
            "file.xml:4: found the field 'on' (a truth value) for the error kind 'bias', allowed: free, value, "
            "heading, level, echoes[].distance, echoes[].strength");
  EXPECT_EQ(refusalOf(error("bias", "mode", {{"offset", "1"}})).substr(0, 55),
            "file.xml:4: found the field 'mode' (one of several mode");
  EXPECT_EQ(refusalOf(error("stuck", "echoes[].distance", {})),
            "file.xml:4: found the field 'echoes[].distance' (elements that are others in the next tick) for the error "
            "kind 'stuck', allowed: free, value, heading, level, on, mode, echoes");
  EXPECT_EQ(refusalOf(error("bias", "", {{"offset", "1"}}), *findDeviceType(ProbeSwitch::kType)),
            "file.xml:4: found the error kind 'bias' for sensor 'probe_switch_of_a_test', which has no numbers, "
            "allowed: a kind for any field");
  EXPECT_EQ(refusalOf(error("saturation", "free", {{"minimum", "2"}, {"maximum", "1"}})),
            "file.xml:5: maximum: found 1, allowed: at least the minimum, 2");
  EXPECT_NE(refusalOf(error("bias", "value[9]", {{"offset", "1"}})), "");
  for (const char* field : {"value", "value[]", "value[3]", "", "echoes", "echoes[].distance"}) {
    EXPECT_EQ(refusalOf(error("bias", field, {{"offset", "1"}})), "") << field;
  }
}

TEST(ErrorModelTest, OneElementOfAnArrayCanBeChosen) {
  ErrorChain chain(probeType());
  chain.add(error("bias", "value[2]", {{"offset", "0.25"}}));
  ErrorState state = chain.makeState(1, "robot", 0);
  Probe probe;
  chain.apply(&probe, state, 0);
  EXPECT_EQ(probe.value, (std::array<float, 4>{0.5F, 0.5F, 0.75F, 0.5F}));
}

TEST(ErrorModelTest, TicksAllocateNothing) {
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
