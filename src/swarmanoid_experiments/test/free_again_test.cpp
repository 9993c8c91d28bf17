// No robot stays stuck: in diffusion every robot gets away again from walls and other robots.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kLeastAdvance = 0.01;  // m
constexpr double kLeastTurn = 0.17453;  // rad, 10 degrees
constexpr int kPatience = 1000;         // ticks of 0.1 s, in which a robot that is not stuck moves by one of these

/// Speed [m/s], subclock.
class FreeAgainTest : public testing::TestWithParam<std::tuple<double, int>> {};

std::unique_ptr<Simulation> diffusion(double speed, int subclock, std::uint64_t seed) {
  loadBuiltInPlugins();
  constexpr double kSide = 17.9;  // m: 200 footbots, one per 1.6 square metres
  const std::string side = std::to_string(kSide);
  const std::string most = std::to_string(kSide - 0.2);
  std::string xml = R"(<ahss-config><framework><clocktick>100</clocktick><maxclock>1000000</maxclock><random_seed>)" +
                    std::to_string(seed) + R"(</random_seed></framework><controllers>
    <diffusion id="dc" library="diffusion"><actuators><footbot_wheels/></actuators><sensors><footbot_proximity/></sensors>
      <parameters><speed>)" +
                    std::to_string(speed) + R"(</speed></parameters></diffusion></controllers>
    <arena size=")" +
                    side + "," + side +
                    R"(,1" optimization="2D" bounded="true"><distribute quantity="200" layout="uniform">
      <minimum>0.2,0.2,0</minimum><maximum>)" +
                    most + "," + most +
                    R"(,0</maximum><footbot id="fb"><controller>dc</controller></footbot></distribute>
    </arena><engines><kinematics2d id="ground"><subclock>)" +
                    std::to_string(subclock) + R"(</subclock></kinematics2d></engines>
    <arena_physics><engine id="ground"><entity id="fb"/></engine></arena_physics></ahss-config>)";
  auto simulation = std::make_unique<Simulation>(parseExperiment(xml, "diffusion.xml"));
  simulation->start();
  return simulation;
}

/// Positions and headings of a robot and its neighbours: the data to reproduce the case in a small world.
std::string surroundings(const Entities& entities, Row row) {
  constexpr double kNear = 0.4;  // m
  std::ostringstream text;
  for (const Row other : entities.order) {
    const Pose& pose = entities.pose[other];
    if (entities.model[other]->is_robot && (pose.position - entities.pose[row].position).norm() < kNear) {
      text << "\n  " << entities.name[other] << " at " << pose.position.transpose() << ", heading "
           << 2.0 * std::atan2(pose.orientation.z(), pose.orientation.w());
    }
  }
  return text.str();
}

struct Watched {
  Pose last;      // at the last motion
  int since = 0;  // ticks
};

TEST_P(FreeAgainTest, Diffusion) {
  const bool is_long = std::getenv("SWARMANOID_LONG_TESTS") != nullptr;
  const int seeds = is_long ? 5 : 1;
  const int ticks = is_long ? 10'000 : 3'000;
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto simulation =
        diffusion(std::get<0>(GetParam()), std::get<1>(GetParam()), static_cast<std::uint64_t>(seed));
    const auto& entities = simulation->space().entities;
    std::vector<Watched> robots;
    for (std::size_t i = 0; i < entities.rowCount(); ++i) {
      const Row row = rowAt(i);
      robots.push_back({entities.pose[row], entities.model[row]->is_robot ? 0 : -1});
    }
    for (int tick = 0; tick < ticks; ++tick) {
      simulation->tick();
      for (std::size_t i = 0; i < robots.size(); ++i) {
        const Row row = rowAt(i);
        Watched& robot = robots[i];
        const Pose& pose = entities.pose[row];
        if (robot.since < 0) {
          continue;
        }
        const double turned = pose.orientation.angularDistance(robot.last.orientation);
        ++robot.since;
        if (turned >= kLeastTurn || (pose.position - robot.last.position).norm() >= kLeastAdvance) {
          robot = {pose, 0};
        }
        ASSERT_LT(robot.since, kPatience) << entities.name[row] << " has stood since tick " << tick - kPatience
                                          << ", seed " << seed << surroundings(entities, row);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(SpeedsAndSubclocks, FreeAgainTest,
                         testing::Combine(testing::Values(0.1, 0.2, 0.3), testing::Values(1, 10)));

}  // namespace
}  // namespace swarmanoid::test
