// Groups of over a thousand are numbered along a curve: neighbours have similar numbers, and positions are uniform.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kSide = 13.0;  // m, side of the square that contains the robots' origins

std::unique_ptr<Simulation> group(int quantity, std::uint64_t seed, double side = kSide) {
  loadBuiltInPlugins();
  const std::string most = std::to_string(side + 0.5);
  const std::string whole = std::to_string(side + 1.0);
  const std::string xml =
      R"(<ahss-config><framework><clocktick>100</clocktick><maxclock>10</maxclock><random_seed>)" +
      std::to_string(seed) + R"(</random_seed></framework><arena size=")" + whole + "," + whole +
      R"(,1" optimization="2D"><distribute quantity=")" + std::to_string(quantity) +
      R"("><minimum>0.5,0.5,0</minimum><maximum>)" + most + "," + most +
      R"(,0</maximum><footbot id="fb"/></distribute></arena><engines><kinematics2d id="ground"/></engines>
    <arena_physics><engine id="ground"><entity id="fb"/></engine></arena_physics></ahss-config>)";
  auto simulation = std::make_unique<Simulation>(parseExperiment(xml, "group.xml"));
  simulation->start();
  return simulation;
}

/// Positions of the robots, in the order of their numbers.
std::vector<Eigen::Vector2d> placesOf(const Simulation& simulation) {
  const Entities& entities = simulation.space().entities;
  std::vector<Eigen::Vector2d> places;
  for (const Row row : entities.order) {
    EXPECT_EQ(entities.name[row], "fb_" + std::to_string(places.size() + 1));
    places.emplace_back(entities.pose[row].position.head<2>());
  }
  return places;
}

double meanStep(const std::vector<Eigen::Vector2d>& places) {
  double sum = 0.0;
  for (std::size_t k = 1; k < places.size(); ++k) {
    sum += (places[k] - places[k - 1]).norm();
  }
  return sum / static_cast<double>(places.size() - 1);
}

TEST(LargeGroupsTest, NearNumbersAreNear) {
  constexpr double kMeanDistance = 0.5214;  // between two random points in a unit square
  EXPECT_NEAR(meanStep(placesOf(*group(1000, 4))), kMeanDistance * kSide, 0.05 * kSide);
  // one robot per 0.11 m2: a step along a curve through random points is about as long as their spacing; later rounds
  // have fewer points, so their steps are longer
  EXPECT_LT(meanStep(placesOf(*group(1500, 4))), 3.0 * std::sqrt(kSide * kSide / 1500.0));
}

TEST(LargeGroupsTest, AllPlacesAreAsLikely) {
  constexpr int kCells = 4;
  constexpr int kSeeds = 12;
  constexpr int kQuantity = 1500;
  std::array<int, kCells * kCells> counts{};
  for (int seed = 1; seed <= kSeeds; ++seed) {
    for (const Eigen::Vector2d& place : placesOf(*group(kQuantity, static_cast<std::uint64_t>(seed)))) {
      const auto cell = [](double x) { return std::min(kCells - 1, static_cast<int>((x - 0.5) / kSide * kCells)); };
      ++counts[static_cast<std::size_t>(cell(place.y()) * kCells + cell(place.x()))];
    }
  }
  // robots that keep a distance are spread more evenly than random points; at the rim they have more space than inside
  const double mean = static_cast<double>(kSeeds) * kQuantity / (kCells * kCells);
  for (const int count : counts) {
    EXPECT_NEAR(count, mean, 4.0 * std::sqrt(mean));
  }
}

TEST(LargeGroupsTest, TheSameSeedGivesTheSamePlaces) {
  EXPECT_EQ(placesOf(*group(1200, 7)), placesOf(*group(1200, 7)));
  EXPECT_NE(placesOf(*group(1200, 7)), placesOf(*group(1200, 8)));
}

TEST(LargeGroupsTest, WhereThereIsNoRoomTheErrorSaysWho) {
  try {
    group(1001, 1, 3.0);
    FAIL() << "a thousand footbots have room on 9 square metres";
  } catch (const ConfigError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("no free place found for 'fb_"), std::string::npos) << text;
    EXPECT_NE(text.find("' of 1001 in 100 trials; allow more area or fewer entities"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace swarmanoid::test
