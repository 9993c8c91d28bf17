// Footbots of the object retrieval experiment that gripped the wrong object, or cannot bring the prey home: they
// release it and continue.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

/// A footbot on a line that leads away from the prey at 31 degrees, or beside the line.
struct Place {
  double along;     // m, from the prey's axis
  double aside;     // m, to the left of that line
  bool is_working;  // faces the prey; otherwise it stands there without a controller
};

constexpr double kLine = 31.0 * M_PI / 180.0;  // rad

void replace(std::string& text, const std::string& first, const std::string& last, const std::string& by) {
  const std::size_t begin = text.find(first);
  const std::size_t end = text.find(last, begin);
  ASSERT_NE(end, std::string::npos) << first;
  text.replace(begin, end + last.size() - begin, by);
}

/// The experiment in dynamics2d with footbots that face the magenta prey, and the eyebot above it.
/// @param prey_radius [m]; @param more parameters of the footbots; @param prey_mass an XML element
std::unique_ptr<Simulation> startedBesidePrey(const std::vector<Place>& places, std::uint64_t seed,
                                              const std::string& prey_radius = "0.06", const std::string& more = "",
                                              const std::string& prey_mass = "") {
  loadBuiltInPlugins();
  std::ifstream file(findShared("swarmanoid_experiments", "experiments/object_retrieval.xml"));
  std::string text{std::istreambuf_iterator<char>(file), {}};
  std::string footbots;
  std::string members;
  for (const Place& place : places) {
    const std::string id = (place.is_working ? "fb_" : "idle_") + std::to_string(&place - places.data() + 1);
    const double x = 1.5 + place.along * std::cos(kLine) - place.aside * std::sin(kLine);
    const double y = 4.0 + place.along * std::sin(kLine) + place.aside * std::cos(kLine);
    const double to_prey = std::atan2(4.0 - y, 1.5 - x) * 180.0 / M_PI;
    std::string one = footbot(id, x, y, to_prey);
    replace(one, "<controller>", "</controller>", place.is_working ? "<controller>fc</controller>" : "");
    footbots += one;
    members += member(id);
  }
  replace(text, "<distribute", "</distribute>", footbots);
  text.replace(text.find("<radius>", text.find("prey_magenta")), 12, prey_mass + "<radius>" + prey_radius);
  text.insert(text.find("<speed>"), more);
  replace(text, "<entity id=\"fb\"", ">", members);
  replace(text, "<position>2.5, 2.5, 2", "</position>", "<position>1.5, 4.0, 2</position>");
  replace(text, "<kinematics2d id=\"ground\">", "</kinematics2d>",
          "<dynamics2d id=\"ground\"><subclock>4</subclock></dynamics2d>");
  replace(text, "<search_radius>", "</search_radius>", "<search_radius>3</search_radius>");
  replace(text, "<prey_color_1>yellow", "</prey_color_1>", "<prey_color_1>magenta</prey_color_1>");
  Experiment experiment = parseExperiment(text, "beside_prey.xml");
  experiment.framework.seed = seed;
  auto simulation = std::make_unique<Simulation>(std::move(experiment));
  simulation->start();
  return simulation;
}

/// Gripping and gripped entities by name.
std::map<std::string, std::string> gripsIn(const Simulation& simulation) {
  std::map<std::string, std::string> grips;
  const Space& space = simulation.space();
  for (const Row row : space.entities.order) {
    if (const Row gripped = space.structure.grippedBy(row); gripped != kNoRow) {
      grips[space.entities.name[row]] = space.entities.name[gripped];
    }
  }
  return grips;
}

using Grips = std::map<std::string, std::string>;

/// @return tick at which these grips exist; all ticks of the run if never
std::uint64_t runUntil(Simulation& simulation, const Grips& grips) {
  while (!simulation.isFinished() && gripsIn(simulation) != grips) {
    simulation.tick();
  }
  return simulation.space().tick;
}

void runToEnd(Simulation& simulation) {
  while (!simulation.isFinished()) {
    simulation.tick();
  }
}

/// Bits in the last place decide in which tick robots meet, so only most of the seeds must behave as expected: `run` of
/// a seed returns whether it did.
template <class Run>
void expectOfMostSeeds(Run run) {
  constexpr int kSeeds = 20;
  constexpr int kMost = 14;
  int count = 0;
  std::string others;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    if (run(seed)) {
      ++count;
    } else {
      others += ' ' + std::to_string(seed);
    }
  }
  EXPECT_GE(count, kMost) << "not with the seeds" << others;
}

bool hasSuccess(Simulation& simulation) {
  runToEnd(simulation);
  return simulation.success() == true;
}

TEST(RetrievalGripTest, OfTwoThatGripOnePreyOneLetsGo) {
  expectOfMostSeeds([](std::uint64_t seed) {
    // at equal distances from it, at 177 degrees, so that they reach it in the same tick
    auto simulation = startedBesidePrey({{0.28, 0.0, true}, {-0.2796, 0.0147, true}}, seed);
    const std::uint64_t together = runUntil(*simulation, {{"fb_1", "prey_magenta"}, {"fb_2", "prey_magenta"}});
    if (together >= 100U) {
      return false;
    }
    while (gripsIn(*simulation).size() == 2 && !simulation->isFinished()) {
      simulation->tick();
    }
    EXPECT_GE(simulation->space().tick, together + 10) << "patience lasts 1 s at least, seed " << seed;
    EXPECT_LE(simulation->space().tick, together + 45) << "and 4 s at most, seed " << seed;
    return hasSuccess(*simulation);
  });
}

TEST(RetrievalGripTest, WhoGripsAnotherFootbotLetsItGo) {
  expectOfMostSeeds([](std::uint64_t seed) {
    // beside the way to the prey: the gripper's tip meets its strip before it reaches the prey
    auto simulation = startedBesidePrey({{0.43, 0.0, true}, {0.17, 0.08, false}}, seed);
    const std::uint64_t gripped = runUntil(*simulation, {{"fb_1", "idle_2"}});
    EXPECT_LT(gripped, 200U) << "seed " << seed;
    EXPECT_LE(runUntil(*simulation, {}), gripped + 45) << "seed " << seed;
    return hasSuccess(*simulation);
  });
}

TEST(RetrievalGripTest, WhoCannotMoveWhatItHoldsLetsGo) {
  expectOfMostSeeds([](std::uint64_t seed) {
    // with a friction of 0.4, 196 N are necessary to slide it; a footbot pulls with at most 16 N
    auto simulation = startedBesidePrey({{0.4, 0.0, true}}, seed, "0.06", "", "<mass>50</mass>");
    const std::uint64_t gripped = runUntil(*simulation, {{"fb_1", "prey_magenta"}});
    EXPECT_LT(gripped, 200U) << "seed " << seed;
    // four times 8 s without progress, and up to 1.5 s of wiggling after each; the spot takes some time to stop
    const std::uint64_t released = runUntil(*simulation, {});
    EXPECT_GE(released, gripped + 320) << "seed " << seed;
    return released <= gripped + 380 + 150;
  });
}

TEST(RetrievalGripTest, ALargePreyIsBroughtHomeByThoseWhoKnowHowLargeItIs) {
  expectOfMostSeeds([](std::uint64_t seed) {
    auto in_vain = startedBesidePrey({{0.4, 0.0, true}}, seed, "0.15");
    const std::uint64_t gripped = runUntil(*in_vain, {{"fb_1", "prey_magenta"}});
    EXPECT_LE(runUntil(*in_vain, {}), gripped + 45) << "seed " << seed;
    auto simulation = startedBesidePrey({{0.4, 0.0, true}}, seed, "0.15", "<prey_reach>0.3</prey_reach>");
    return runUntil(*simulation, {{"fb_1", "prey_magenta"}}) < 200U && hasSuccess(*simulation);
  });
}

}  // namespace
}  // namespace swarmanoid::test
