// The conformance test of a footbot with a scanner: it passes in each engine, and detects the faults of drivers.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "conformance_world.hpp"
#include "swarmanoid_interface/devices/footbot_scanner.hpp"

namespace swarmanoid::test {
namespace {

/// The conformance experiment with a footbot that has only the scanner.
std::unique_ptr<Simulation> scannerIn(const std::string& engine, const std::vector<Override>& overrides = {}) {
  std::string text = conformanceText();
  replace(text, "<footbot_wheels/>\n        <footbot_gripper/>\n        <footbot_turret/>", "<footbot_scanner/>");
  replace(text, "<footbot_turret_state/>", "<footbot_scanner_readings/>");
  replace(text, "<dynamics2d id=\"ground\"/>", "<" + engine + " id=\"ground\"/>");
  return start(text, overrides);
}

std::string verdictOn(Simulation& simulation) {
  const std::string verdict = fullVerdictsOf(simulation)["fb"];
  return verdict.substr(0, verdict.find(" ("));  // the details are in brackets
}

TEST(ScannerConformanceTest, PassesInEachEngine) {
  for (const char* engine : {"kinematics2d", "dynamics2d", "dynamics3d"}) {
    const auto simulation = scannerIn(engine);
    EXPECT_EQ("passed", verdictOn(*simulation)) << engine;
    const std::string passed = debugOf(*simulation, "fb", "passed");
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
          distance = std::isfinite(distance) ? distance : 0.0F;  // many drivers report 0 in open space
        }
      })};
  int index = 0;
  for (const Miswiring& mistake : mistakes) {
    const auto simulation = scannerIn("kinematics2d", {{"arena.fb.controller.source", "remote"}});
    MiswiredRobot robot(*simulation, "fb", mistake);
    EXPECT_EQ("conformance test failed: footbot_scanner", verdictOn(*simulation)) << index;
    ++index;
  }
}

}  // namespace
}  // namespace swarmanoid::test
