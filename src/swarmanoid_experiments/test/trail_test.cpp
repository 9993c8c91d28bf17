// The installed experiment `trail`: footbots with ground sensors alone travel between patches by the trail of an
// eyebot, and rarely without it; and runs are reproducible.
#include <gtest/gtest.h>

#include <fstream>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

// Limits of this test.
constexpr std::uint64_t kTicks = 6000;  // ten minutes
constexpr double kTimesAsMany = 3.0;    // minimum ratio of trips with the trail to those without, over all seeds
constexpr double kTripsOfAll = 40.0;    // minimum trips with the trail, all seeds; one undisturbed footbot: 23 per seed

std::unique_ptr<Simulation> trail(std::uint64_t seed, const std::string& found = "", const std::string& put = "",
                                  int threads = 1) {
  loadBuiltInPlugins();
  std::ifstream file(findShared("swarmanoid_experiments", "experiments/trail.xml"));
  std::string text(std::istreambuf_iterator<char>(file), {});
  if (!found.empty()) {
    const std::size_t at = text.find(found);
    EXPECT_NE(at, std::string::npos) << found;
    text.replace(at, found.size(), put);
  }
  Experiment experiment = parseExperiment(text, "trail.xml");
  experiment.framework.seed = seed;
  experiment.framework.threads = threads;
  auto simulation = std::make_unique<Simulation>(std::move(experiment));
  simulation->start();
  return simulation;
}

double tripsOf(const Simulation& simulation) { return std::get<double>(simulation.metrics().at("trips.trips")); }

/// Sum over five seeds.
double tripsOfAll(const std::string& found = "", const std::string& put = "") {
  double trips = 0.0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto simulation = trail(seed, found, put);
    tick(*simulation, kTicks);
    trips += tripsOf(*simulation);
  }
  return trips;
}

TEST(TrailExperimentTest, FootbotsComeFromPatchToPatchByTheTrailAndHardlyWithoutIt) {
  const double with_trail = tripsOfAll();
  const double without = tripsOfAll("<trail id=\"trail\">", "<trail id=\"trail\"><led_color>white</led_color>");
  EXPECT_GE(with_trail, kTripsOfAll);
  EXPECT_GE(with_trail, kTimesAsMany * without);
}

TEST(TrailExperimentTest, ATrailThatNobodyRenewsFades) {
  const auto simulation = trail(1);
  tick(*simulation, 600);
  const Space& space = simulation->space();
  const Eigen::Vector3d middle(2.0, 1.5, 0.0);
  EXPECT_LT(space.floor.colorAt(middle, space.tick).brightness(), 0.6) << "half way from patch to patch";
  for (const char* robot : {"scout", "fb_1", "fb_2"}) {
    simulation->apply(DeleteEntity{robot});
  }
  tick(*simulation, 2200);  // eleven half-lives
  EXPECT_GT(space.floor.colorAt(middle, space.tick).brightness(), 0.99);
}

TEST(TrailExperimentTest, TheSameSeedHasTheSameBitsAgainAfterAResetAndWithTwoThreads) {
  const auto first = trail(3);
  const auto other = trail(3, "", "", 2);
  for (int i = 0; i < 500; ++i) {
    first->tick();
    other->tick();
    ASSERT_EQ(deepHash(first->space()), deepHash(other->space())) << i;
  }
  const std::uint64_t after = first->stateHash();
  first->reset();
  tick(*first, 500);
  EXPECT_EQ(first->stateHash(), after);
  const auto another = trail(4);
  tick(*another, 500);
  EXPECT_NE(another->stateHash(), after) << "another seed";
}

}  // namespace
}  // namespace swarmanoid::test
