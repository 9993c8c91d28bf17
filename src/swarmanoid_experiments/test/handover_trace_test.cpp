// A rejected handover leaves no trace, even inside the engines: the run continues with the same bits.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <utility>

#include "installed_experiment.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid::test {
namespace {

/// group_pull in one engine, with a second one that is empty at first.
std::unique_ptr<Simulation> pullWith(const std::string& ground, const std::string& other, std::uint64_t seed) {
  loadBuiltInPlugins();
  const std::string file = findShared("swarmanoid_experiments", "experiments/group_pull.xml");
  std::ifstream in(file);
  std::string text(std::istreambuf_iterator<char>(in), {});
  const std::size_t begin = text.find("<engines>");
  text.replace(begin, text.find("</engines>") - begin,
               "<engines><" + ground + " id=\"ground\"/><" + other + " id=\"other\"/>");
  Experiment experiment = parseExperiment(text, file);
  experiment.framework.seed = seed;
  auto simulation = std::make_unique<Simulation>(std::move(experiment));
  simulation->start();
  return simulation;
}

Pose flat(double x, double y, double heading) {
  return {{x, y, 0.0}, Eigen::Quaterniond(Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()))};
}

void tick(Simulation& simulation, int ticks) {
  for (int i = 0; i < ticks; ++i) {
    simulation.tick();
  }
}

void expectRefused(Simulation& simulation, const std::string& entity, const std::string& engine) {
  EXPECT_THROW(simulation.apply(HandOverEntity{entity, engine}), ConfigError) << entity << " to " << engine;
}

TEST(HandoverTraceTest, ARefusedOneChangesNothingAmongPulledAndHandedOverRobots) {
  const auto run = [](bool asks) {
    auto simulation = pullWith("dynamics2d", "dynamics3d", 6);
    tick(*simulation, 19);
    simulation->apply(MoveEntity{"fb_8", flat(3.57, 4.21, 0.0)});
    tick(*simulation, 1);
    simulation->apply(MoveEntity{"fb_5", flat(4.846, 0.2407, -2.35)});
    simulation->apply(HandOverEntity{"fb_5", "other"});
    tick(*simulation, 1);
    if (asks) {
      expectRefused(*simulation, "boundary_north", "ground");
    }
    tick(*simulation, 30);
    return simulation->stateHash();
  };
  EXPECT_EQ(run(true), run(false));
}

TEST(HandoverTraceTest, RefusedOnesChangeNothingWhereRobotsOfTwoEnginesPushEachOther) {
  for (const auto& [ground, other] : {std::pair("dynamics2d", "dynamics3d"), std::pair("dynamics3d", "dynamics2d"),
                                      std::pair("dynamics2d", "dynamics2d"), std::pair("dynamics3d", "kinematics2d"),
                                      std::pair("kinematics2d", "dynamics2d")}) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      const auto run = [&, ground = ground, other = other](bool asks) {
        std::mt19937 random(static_cast<unsigned>(seed));
        const auto some = [&](double most) { return most * static_cast<double>(random() % 1000) / 1000.0; };
        auto simulation = pullWith(ground, other, seed);
        simulation->apply(MoveEntity{"fb_8", flat(4.2, 4.2, some(6.0))});
        simulation->apply(MoveEntity{"fb_7", flat(4.45 + some(0.05), 4.2, some(6.0))});
        simulation->apply(MoveEntity{"fb_5", flat(4.2, 4.45 + some(0.05), some(6.0))});
        simulation->apply(HandOverEntity{"fb_5", "other"});
        for (int i = 0; i < 40; ++i) {
          tick(*simulation, 1 + static_cast<int>(random() % 3));
          if (asks) {
            expectRefused(*simulation, "boundary_north", "ground");
            expectRefused(*simulation, "boundary_west", "other");
          }
        }
        return simulation->stateHash();
      };
      EXPECT_EQ(run(true), run(false)) << ground << ", " << other << ", seed " << seed;
    }
  }
}

}  // namespace
}  // namespace swarmanoid::test
