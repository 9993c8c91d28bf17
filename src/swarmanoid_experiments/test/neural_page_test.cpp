// The listing in the reference page of neural controllers is valid: its network drives straight on.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

constexpr int kTicks = 50;  // of 0.1 s

std::string listing() {
  std::ifstream file(PAGE);
  const std::string page(std::istreambuf_iterator<char>(file), {});
  const std::string begin = "```xml\n";
  const std::size_t at = page.find(begin) + begin.size();
  return page.substr(at, page.find("```", at) - at);
}

std::unique_ptr<Simulation> world(const std::string& controllers) {
  loadBuiltInPlugins();
  const std::string text =
      "<ahss-config><framework><clocktick>100</clocktick><maxclock>50</maxclock></framework>"
      "<controllers>" +
      controllers +
      "</controllers><arena size=\"10,10,2\" optimization=\"2D\"><footbot id=\"fb\">"
      "<position>2, 5, 0</position><orientation>0, 0, 0</orientation><controller>nc</controller>"
      "</footbot></arena><engines><kinematics2d id=\"ground\"/></engines><arena_physics>"
      "<engine id=\"ground\"><entity id=\"fb\"/></engine></arena_physics></ahss-config>";
  auto simulation = std::make_unique<Simulation>(parseExperiment(text, "page.xml"));
  simulation->start();
  return simulation;
}

TEST(NeuralPageTest, ItsNetworkDrivesAFootbotAhead) {
  const auto simulation = world(listing());
  tick(*simulation, kTicks);
  EXPECT_TRUE(simulation->failures().empty());
  // biases of 1 without weights: each wheel turns at -5 + 10 / (1 + e^-1) rad/s
  const double way = 0.029 * (-5.0 + 10.0 / (1.0 + std::exp(-1.0))) * 0.1 * kTicks;
  EXPECT_NEAR(poseOf(*simulation, "fb").position.x(), 2.0 + way, 1e-9);
  EXPECT_NEAR(poseOf(*simulation, "fb").position.y(), 5.0, 1e-9);
}

TEST(NeuralPageTest, HowManyNumbersAreMissingIsToldWithTheLine) {
  std::string text = listing();
  const std::string line = "      0, 0, 0, 0, 0, 0, 0, 0,\n";
  text.replace(text.find(line), line.size(), "");
  try {
    world(text);
    FAIL() << "it was taken";
  } catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what())
                  .find("weights: found 8 numbers, allowed: 16 numbers separated by commas (neurons "
                        "by layer: 8, 2)"),
              std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("page.xml:26"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace swarmanoid::test
