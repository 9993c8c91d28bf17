// Random numbers: the published vectors of the generator, independence of everything but the key, and moments that a
// wrong generator does not have.
#include "swarmanoid_interface/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace swarmanoid {
namespace {

std::vector<std::uint64_t> draws(RandomStream stream, std::uint64_t tick, int count) {
  stream.startTick(tick);
  std::vector<std::uint64_t> result;
  for (int i = 0; i < count; ++i) {
    result.push_back(stream.bits());
  }
  return result;
}

TEST(StableHashTest, IsFnv1a) {
  EXPECT_EQ(stableHash(""), 0xcbf29ce484222325ULL);
  EXPECT_EQ(stableHash("a"), 0xaf63dc4c8601ec8cULL);
  EXPECT_EQ(stableHash("foobar"), 0x85944171f73967e8ULL);
}

TEST(RandomStreamTest, GivesThePublishedVectorOfPhilox4x32WithTenRounds) {
  // kat_vectors of Random123: counter 0, key 0 -> 6627e8d5 e169c58d bc57ac4c 9b00dbd8
  RandomStream stream(0, 0);
  EXPECT_EQ(stream.bits(), 0xe169c58d6627e8d5ULL);
}

TEST(RandomStreamTest, EqualKeysGiveEqualNumbersWhateverWasDrawnBefore) {
  const auto expected = draws(RandomStream(7, "fb_1", "controller"), 42, 20);
  RandomStream stream(7, "fb_1", "controller");
  for (const std::uint64_t tick : {0, 1000, 41, 42}) {
    stream.startTick(tick);
    for (std::uint64_t i = 0; i < tick % 17; ++i) {
      stream.gaussian(0.0, 1.0);
    }
  }
  EXPECT_EQ(draws(stream, 42, 20), expected);
}

TEST(RandomStreamTest, StreamsDoNotDependOnTheOrderInWhichTheyDraw) {
  std::array<RandomStream, 2> forth{RandomStream(1, "fb_1", "wheels"), RandomStream(1, "fb_2", "wheels")};
  std::array<RandomStream, 2> back = forth;
  for (std::uint64_t tick = 0; tick < 100; ++tick) {
    std::array<double, 2> values{};
    for (std::size_t i = 0; i < 2; ++i) {
      forth[i].startTick(tick);
      values[i] = forth[i].gaussian(0.0, 1.0);
    }
    for (std::size_t i = 2; i-- > 0;) {
      back[i].startTick(tick);
      EXPECT_EQ(back[i].gaussian(0.0, 1.0), values[i]);
    }
  }
}

TEST(RandomStreamTest, EveryPartOfTheKeyChangesTheNumbers) {
  const RandomStream stream(1, "fb_1", "wheels");
  std::set<std::uint64_t> firsts;
  for (const RandomStream& each :
       {stream, RandomStream(2, "fb_1", "wheels"), RandomStream(1ULL << 32U, "fb_1", "wheels"),
        RandomStream(1, "fb_2", "wheels"), RandomStream(1, "fb_1", "camera"), RandomStream(1, "wheels", "fb_1")}) {
    firsts.insert(draws(each, 0, 1)[0]);
  }
  for (const std::uint64_t tick : {1ULL, 1ULL << 32U, 1ULL << 63U}) {
    firsts.insert(draws(stream, tick, 1)[0]);
  }
  firsts.insert(draws(stream, 0, 2)[1]);
  EXPECT_EQ(firsts.size(), 10U);
}

/// Mean, variance, skewness and kurtosis of `count` numbers, each with the standard error of its estimate.
struct Moments {
  double mean = 0.0;
  double variance = 0.0;
  double third = 0.0;   // standardised
  double fourth = 0.0;  // standardised

  explicit Moments(const std::vector<double>& values) {
    const auto n = static_cast<double>(values.size());
    for (const double value : values) {
      mean += value / n;
    }
    for (const double value : values) {
      variance += (value - mean) * (value - mean) / n;
    }
    for (const double value : values) {
      const double z = (value - mean) / std::sqrt(variance);
      third += z * z * z / n;
      fourth += z * z * z * z / n;
    }
  }
};

constexpr int kMany = 200000;

/// The ways in which the simulator draws: many from one tick, one of each tick, one of each robot.
std::vector<std::vector<double>> ofEachKind(double (*draw)(RandomStream&)) {
  std::vector<std::vector<double>> kinds(3);
  RandomStream stream(5, "fb", "controller");
  for (int i = 0; i < kMany; ++i) {
    kinds[0].push_back(draw(stream));
  }
  for (int i = 0; i < kMany; ++i) {
    stream.startTick(static_cast<std::uint64_t>(i));
    kinds[1].push_back(draw(stream));
  }
  for (int i = 0; i < kMany; ++i) {
    RandomStream other(5, "fb_" + std::to_string(i), "controller");
    kinds[2].push_back(draw(other));
  }
  return kinds;
}

TEST(RandomStreamTest, UniformNumbersAreUniformAndNeighboursIndependent) {
  for (const std::vector<double>& values : ofEachKind([](RandomStream& stream) { return stream.uniform(); })) {
    constexpr int kBins = 100;
    std::array<int, kBins> bins{};
    std::array<int, kBins> pairs{};
    double previous = 0.0;
    for (const double value : values) {
      ASSERT_GE(value, 0.0);
      ASSERT_LT(value, 1.0);
      ++bins[static_cast<std::size_t>(value * kBins)];
      ++pairs[static_cast<std::size_t>(value * 10) * 10 + static_cast<std::size_t>(previous * 10)];
      previous = value;
    }
    for (const auto& counts : {bins, pairs}) {
      double chi_squared = 0.0;
      for (const int count : counts) {
        const double expected = static_cast<double>(kMany) / kBins;
        chi_squared += (count - expected) * (count - expected) / expected;
      }
      // 99 degrees of freedom: mean 99, standard deviation 14; too even a distribution is as wrong as too uneven a one
      EXPECT_LT(chi_squared, 99.0 + 5.0 * 14.1);
      EXPECT_GT(chi_squared, 99.0 - 4.0 * 14.1);
    }
    const Moments moments(values);
    EXPECT_NEAR(moments.mean, 0.5, 5.0 * std::sqrt(1.0 / 12.0 / kMany));
    EXPECT_NEAR(moments.variance, 1.0 / 12.0, 5.0 * std::sqrt(1.0 / 180.0 / kMany));
  }
}

TEST(RandomStreamTest, GaussianNumbersHaveTheMomentsOfANormalDistribution) {
  const auto draw = [](RandomStream& stream) { return stream.gaussian(3.0, 2.0); };
  for (const std::vector<double>& values : ofEachKind(draw)) {
    const Moments moments(values);
    EXPECT_NEAR(moments.mean, 3.0, 5.0 * 2.0 / std::sqrt(kMany));
    EXPECT_NEAR(moments.variance, 4.0, 5.0 * 4.0 * std::sqrt(2.0 / kMany));
    EXPECT_NEAR(moments.third, 0.0, 5.0 * std::sqrt(6.0 / kMany));
    EXPECT_NEAR(moments.fourth, 3.0, 5.0 * std::sqrt(24.0 / kMany));
    int beyond_two = 0;
    for (const double value : values) {
      beyond_two += std::abs(value - 3.0) > 4.0 ? 1 : 0;
    }
    const double expected = 0.0455002639 * kMany;
    EXPECT_NEAR(beyond_two, expected, 5.0 * std::sqrt(expected));
  }
}

TEST(RandomStreamTest, NoSpreadIsExactlyTheMean) {
  RandomStream stream(1, "fb", "wheels");
  for (int i = 0; i < 1000; ++i) {
    EXPECT_EQ(stream.gaussian(0.25, 0.0), 0.25);
    EXPECT_EQ(stream.uniform(0.25, 0.25), 0.25);
  }
}

TEST(RandomStreamTest, BelowReachesEachNumberEquallyOften) {
  RandomStream stream(1, "fb", "controller");
  std::array<int, 7> counts{};
  for (int i = 0; i < 70000; ++i) {
    ++counts.at(stream.below(7));
  }
  for (const int count : counts) {
    EXPECT_NEAR(count, 10000, 5.0 * std::sqrt(10000.0 * 6.0 / 7.0));
  }
}

/// The defaults are those of Python.
TEST(RandomStreamTest, AGaussianNumberIsStandardNormalUnlessMoreIsSaid) {
  RandomStream one(7, 11);
  RandomStream other(7, 11);
  EXPECT_EQ(one.gaussian(), other.gaussian(0.0, 1.0));
  EXPECT_EQ(one.gaussian(3.0), other.gaussian(3.0, 1.0));
}

}  // namespace
}  // namespace swarmanoid
