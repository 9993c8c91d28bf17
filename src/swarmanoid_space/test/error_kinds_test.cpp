// Each kind of error on a chosen field: mean, spread and shape of 10^5 draws, or the exact values.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "error_probe.hpp"

namespace swarmanoid::test {
namespace {

const double kRoot = std::sqrt(static_cast<double>(kDraws));

/// Readings of `free` of kDraws robots in one tick.
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

/// Kolmogorov-Smirnov test at the level 0.001; mean and deviation within four standard errors.
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
  // for the shapes here, the standard error of a deviation is at most that of the normal distribution
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

TEST(ErrorKindsTest, GaussianIsNormalAroundTheIdealValue) {
  expectNormal(overTicks(error("gaussian", "free", {{"deviation", "0.2"}}), constant), 3.0, 0.2);
}

TEST(ErrorKindsTest, UniformStaysWithinItsHalfWidth) {
  const auto values = overTicks(error("uniform", "free", {{"half_width", "0.5"}}), constant);
  expectDistribution(values, 3.0, 0.5 / std::sqrt(3.0), [](double x) { return std::clamp(x - 2.5, 0.0, 1.0); });
}

TEST(ErrorKindsTest, FactorMultipliesWithANormalNumber) {
  expectNormal(overTicks(error("factor", "free", {{"mean", "1.1"}, {"deviation", "0.2"}}), constant), 3.3, 0.6);
  const auto standing = overTicks(
      error("factor", "free", {{"mean", "1.1"}, {"deviation", "0.2"}}), [](std::size_t) { return 0.0; }, 1000);
  EXPECT_EQ(standing, std::vector<double>(1000, 0.0));
}

TEST(ErrorKindsTest, BiasSaturationAndQuantisationAreExact) {
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

TEST(ErrorKindsTest, QuantisationHasAUniformErrorOfItsStep) {
  std::vector<double> errors;
  const auto fine = [](std::size_t tick) { return std::fmod(0.6180339887498949 * static_cast<double>(tick), 1.0); };
  const auto rounded = overTicks(error("quantisation", "free", {{"step", "0.1"}}), fine);
  for (std::size_t i = 0; i < kDraws; ++i) {
    errors.push_back(rounded[i] - fine(i));
  }
  expectDistribution(errors, 0.0, 0.1 / std::sqrt(12.0), [](double x) { return (x + 0.05) / 0.1; });
}

TEST(ErrorKindsTest, ARandomWalkHasNormalSteps) {
  const auto walk = overTicks(error("random_walk", "free", {{"deviation", "0.01"}}), constant);
  std::vector<double> steps{walk[0] - 3.0};
  for (std::size_t i = 1; i < kDraws; ++i) {
    steps.push_back(walk[i] - walk[i - 1]);
  }
  expectNormal(steps, 0.0, 0.01);
}

TEST(ErrorKindsTest, SpreadsAreNormalBetweenRobots) {
  expectNormal(overRobots(error("offset_spread", "free", {{"deviation", "0.3"}}), 2.0), 2.0, 0.3);
  expectNormal(overRobots(error("factor_spread", "free", {{"deviation", "0.1"}}), 2.0), 2.0, 0.2);
}

TEST(ErrorKindsTest, ADropOutRepeatsWhatCameLast) {
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

TEST(ErrorKindsTest, LatencyIsExact) {
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

TEST(ErrorKindsTest, FaultsBeginInTheirTick) {
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

}  // namespace
}  // namespace swarmanoid::test
