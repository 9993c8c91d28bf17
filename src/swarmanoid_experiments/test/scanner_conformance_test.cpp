// The conformance test of a footbot with a scanner: it passes in each engine, and finds what a driver has got wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "miswired_robot.hpp"
#include "swarmanoid_interface/devices/footbot_scanner.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {
namespace {

void replace(std::string& text, const std::string& part, const std::string& by) {
  const auto found = text.find(part);
  ASSERT_NE(std::string::npos, found) << part;
  text.replace(found, part.size(), by);
}

/// The conformance experiment, with the scanner alone for the footbot.
std::unique_ptr<Simulation> start(const std::string& engine, const std::vector<Override>& overrides = {}) {
  loadBuiltInPlugins();
  std::ifstream in(findShared("swarmanoid_experiments", "experiments/conformance.xml"));
  std::ostringstream read;
  read << in.rdbuf();
  std::string text = read.str();
  replace(text, "<footbot_wheels/>\n        <footbot_gripper/>\n        <footbot_turret/>", "<footbot_scanner/>");
  replace(text, "<footbot_turret_state/>", "<footbot_scanner_readings/>");
  replace(text, "<dynamics2d id=\"ground\"/>", "<" + engine + " id=\"ground\"/>");
  auto simulation = std::make_unique<Simulation>(parseExperiment(text, "conformance.xml", overrides));
  simulation->start();
  return simulation;
}

std::string verdictOn(Simulation& simulation) {
  while (!simulation.isFinished()) {
    simulation.tick();
  }
  for (const auto& [robot, verdict] : simulation.metrics()) {
    if (robot == "fb") {
      const auto& text = std::get<std::string>(verdict);
      return text.substr(0, text.find(" ("));  // the details are in brackets
    }
  }
  return "";
}

TEST(ScannerConformanceTest, PassesInEachEngine) {
  for (const char* engine : {"kinematics2d", "dynamics2d", "dynamics3d"}) {
    const auto simulation = start(engine);
    EXPECT_EQ("passed", verdictOn(*simulation)) << engine;
    const Space& space = simulation->space();
    std::string passed;
    for (const auto& [key, value] : space.robots[space.entities.find("fb")]->debugValues()) {
      passed += key == "passed" ? value : "";
    }
    EXPECT_NE(std::string::npos, passed.find("footbot_scanner")) << passed;
  }
}

TEST(ScannerConformanceTest, FindsWhatADriverHasGotWrong) {
  using Readings = FootbotScannerReadings;
  const Miswiring mistakes[] = {
      wire<FootbotScanner>([](FootbotScanner& scanner) { scanner.speed = -scanner.speed; }),
      wire<FootbotScanner>([](FootbotScanner& scanner) { scanner.angle = -scanner.angle; }),
      wire<Readings>([](Readings& readings) { std::swap(readings.long_left, readings.long_right); }),
      wire<Readings>([](Readings& readings) { std::swap(readings.long_left, readings.short_ahead); }),
      wire<Readings>([](Readings& readings) {
        for (float& distance : readings.long_left) {
          distance *= 0.01F;
        }
      }),
      wire<Readings>([](Readings& readings) {
        for (float& distance : readings.long_left) {
          distance = std::isfinite(distance) ? distance : 0.0F;  // as many drivers have it where nothing is
        }
      })};
  int index = 0;
  for (const Miswiring& mistake : mistakes) {
    const auto simulation = start("kinematics2d", {{"arena.fb.controller.source", "remote"}});
    MiswiredRobot robot(*simulation, "fb", mistake);
    EXPECT_EQ("conformance test failed: footbot_scanner", verdictOn(*simulation)) << index;
    ++index;
  }
}

}  // namespace
}  // namespace swarmanoid::test
