/// Shared by the tests of the conformance test: worlds, verdicts, and wrongly wired devices.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "miswired_robot.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/span.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {

constexpr double kDegrees = 57.29577951308232;  // of a radian

/// The conformance experiment of the suite.
inline std::string conformanceText() {
  std::ifstream in(findShared("swarmanoid_experiments", "experiments/conformance.xml"));
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Replaces the first occurrence of a part. @pre there is one
inline void replace(std::string& text, const std::string& part, const std::string& by) {
  const auto found = text.find(part);
  ASSERT_NE(std::string::npos, found) << part;
  text.replace(found, part.size(), by);
}

inline std::unique_ptr<Simulation> start(const std::string& text, const std::vector<Override>& overrides = {}) {
  loadBuiltInPlugins();
  auto simulation = std::make_unique<Simulation>(parseExperiment(text, "conformance.xml", overrides));
  simulation->start();
  return simulation;
}

/// The final verdict of each robot.
inline std::map<std::string, std::string> fullVerdictsOf(Simulation& simulation) {
  while (!simulation.isFinished()) {
    simulation.tick();
  }
  std::map<std::string, std::string> verdicts;
  for (const auto& [robot, verdict] : simulation.metrics()) {
    if (const auto* text = std::get_if<std::string>(&verdict)) {
      verdicts[robot] = *text;
    }
  }
  return verdicts;
}

inline std::string debugOf(const Simulation& simulation, const std::string& robot, const std::string& key) {
  const Space& space = simulation.space();
  for (const auto& [known, value] : space.robots[space.entities.find(robot)]->debugValues()) {
    if (known == key) {
      return value;
    }
  }
  return "";
}

/// Verdict when a robot's device is wired like that, as reported by the robot named last, by default the same one.
inline std::string verdictWith(const std::string& text, const std::string& robot, const Miswiring& miswiring,
                               const std::string& told = "") {
  const auto simulation = start(text, {{"arena." + robot + ".controller.source", "remote"}});
  MiswiredRobot miswired(*simulation, robot, miswiring);
  return fullVerdictsOf(*simulation)[told.empty() ? robot : told];
}

/// @param why text of the verdict after "conformance test failed: "
inline void expectFailure(const std::string& text, const std::string& robot, const Miswiring& miswiring,
                          const std::string& why, const std::string& told = "") {
  const std::string verdict = verdictWith(text, robot, miswiring, told);
  EXPECT_EQ(0U, verdict.find("conformance test failed: " + why)) << verdict;
}

/// @param list of the device @param change function that modifies the list, as a vector
template <class Device, class Owner, class Element, class Change>
Miswiring wireList(Span<const Element> Owner::*list, Change change) {
  return wire<Device>([list, change, kept = std::make_shared<std::vector<Element>>()](Device& device) mutable {
    kept->assign((device.*list).begin(), (device.*list).end());
    change(*kept);
    device.*list = Span<const Element>(kept->data(), kept->size());
  });
}

}  // namespace swarmanoid::test
