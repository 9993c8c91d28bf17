// The listings of the reference page of experiment files can be used as they stand, and no name is missing there.
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/simulation.hpp"

namespace swarmanoid {
namespace {

std::string page() {
  std::ifstream file(PAGE);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> listings() {
  const std::string text = page();
  const std::string start = "```xml\n";
  std::vector<std::string> result;
  for (std::size_t at = text.find(start); at != std::string::npos; at = text.find(start, at + 1)) {
    const std::size_t begin = at + start.size();
    result.push_back(text.substr(begin, text.find("```", begin) - begin));
  }
  return result;
}

TEST(ExperimentPageTest, ListingsCanBeBuiltAndTicked) {
  loadBuiltInPlugins();
  EXPECT_GE(listings().size(), 2U);
  for (const std::string& listing : listings()) {
    Experiment experiment = parseExperiment(listing, "listing.xml");
    experiment.visualisations.clear();  // they would write files
    Simulation simulation(std::move(experiment));
    simulation.start();
    simulation.tick();
    EXPECT_EQ(simulation.space().tick, 1U);
  }
}

TEST(ExperimentPageTest, NamesAllThatTheSuiteBrings) {
  loadBuiltInPlugins();
  const std::string text = page();
  const auto expect_name = [&text](const std::string& name) {
    EXPECT_NE(text.find("`" + name + "`"), std::string::npos) << name;
  };
  for (const PluginKind kind : {PluginKind::kSensor, PluginKind::kActuator, PluginKind::kEngine,
                                PluginKind::kVisualisation, PluginKind::kEntity}) {
    for (const Registry::Entry* entry : Registry::instance().all(kind)) {
      expect_name(entry->description.label);
      for (const std::string& alias : entry->description.label_aliases) {
        expect_name(alias);
      }
      for (const std::string& alias : entry->description.implementation_aliases) {
        expect_name(alias);
      }
      for (const Parameter& parameter : entry->description.parameters) {
        const bool is_numbered = parameter.name.rfind("camera_view_", 0) == 0;
        expect_name(is_numbered ? parameter.name.substr(0, parameter.name.size() - 1) + "0" : parameter.name);
      }
    }
  }
}

}  // namespace
}  // namespace swarmanoid
