// The listings in the reference page of experiment files, and those of the thesis, are valid, and the page contains all
// names.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "page_sections.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/error_models/error_model.hpp"
#include "swarmanoid_space/models/entity_type.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {
namespace {

std::string textOf(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string page() { return textOf(PAGE); }

/// The section of each arena object, in the pages of its folder.
std::unordered_map<std::string, std::string> arenaObjectSections() {
  return test::pageSections(std::filesystem::path(PAGE).parent_path() / "arena_objects");
}

/// The entity types other than robots.
std::vector<const Registry::Entry*> arenaObjects() {
  std::vector<const Registry::Entry*> objects = Registry::instance().all(PluginKind::kEntity);
  const auto is_robot = [](const Registry::Entry* entry) { return makePlugin<EntityType>(*entry)->isRobot(); };
  objects.erase(std::remove_if(objects.begin(), objects.end(), is_robot), objects.end());
  return objects;
}

/// Model with the default parameters, and valid values for the required ones.
std::shared_ptr<const EntityModel> someModel(const Registry::Entry& entry) {
  Configuration parameters(entry.description.label, "", {});
  for (const Parameter& parameter : entry.description.parameters) {
    const bool is_vector = parameter.type == Parameter::Type::kVector3;
    parameters.set(parameter.name, parameter.value.value_or(is_vector ? "1, 1, 1" : "1"));
  }
  return makePlugin<EntityType>(entry)->makeModel(parameters);
}

/// The table row that starts with a name, after a heading of level 2 or 3; "" if there is none.
std::string rowOf(const std::string& text, const std::string& heading, const std::string& name) {
  const std::size_t begin = text.find("## " + heading + "\n");
  const std::string part = begin == std::string::npos ? "" : text.substr(begin, text.find("\n##", begin) - begin);
  const std::size_t row = part.find("\n| `" + name + "` |");
  return row == std::string::npos ? "" : part.substr(row + 1, part.find('\n', row + 1) - row - 1);
}

std::string rangeText(const Range& range) { return range.toString() == "any number" ? "" : range.toString(); }

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
  for (const PluginKind kind :
       {PluginKind::kSensor, PluginKind::kActuator, PluginKind::kEngine, PluginKind::kObserver}) {
    for (const Registry::Entry* entry : Registry::instance().all(kind)) {
      if (Registry::instance().find(kind, entry->description.label) != entry) {
        continue;  // a device's implementation other than the default: `swarmanoid list` shows it
      }
      for (const std::string& alias : entry->description.label_aliases) {
        expect_name(alias);
      }
      for (const std::string& alias : entry->description.implementation_aliases) {
        expect_name(alias);
      }
    }
  }
  // devices and arena objects have their own pages for the rest
  for (const PluginKind kind : {PluginKind::kEngine, PluginKind::kObserver}) {
    for (const Registry::Entry* entry : Registry::instance().all(kind)) {
      expect_name(entry->description.label);
      for (const Parameter& parameter : entry->description.parameters) {
        const bool is_numbered = parameter.name.rfind("camera_view_", 0) == 0;
        expect_name(is_numbered ? parameter.name.substr(0, parameter.name.size() - 1) + "0" : parameter.name);
      }
    }
  }
}

TEST(ArenaObjectPagesTest, EachArenaObjectOfTheSuiteHasASection) {
  loadBuiltInPlugins();
  auto sections = arenaObjectSections();
  std::set<std::string> found;
  for (const auto& section : sections) {
    found.insert(section.first);
  }
  std::set<std::string> objects;
  for (const Registry::Entry* entry : arenaObjects()) {
    objects.insert(entry->description.label);
    EXPECT_EQ(sections[entry->description.label].rfind("\n" + entry->description.summary + "\n", 0), 0U)
        << entry->description.label << ": " << entry->description.summary;
  }
  EXPECT_EQ(found, objects);
}

TEST(ArenaObjectPagesTest, TheyHaveEachParameterAndProperty) {
  loadBuiltInPlugins();
  auto sections = arenaObjectSections();
  for (const Registry::Entry* entry : arenaObjects()) {
    const std::string& text = sections[entry->description.label];
    for (const Parameter& parameter : entry->description.parameters) {
      const std::string start = "| `" + parameter.name + "` | " + parameter.value.value_or("required") + " | " +
                                (parameter.unit.empty() ? "" : parameter.unit + " ") + "| ";
      const std::string row = rowOf(text, "Parameters", parameter.name);
      EXPECT_EQ(row.rfind(start, 0), 0U) << entry->description.label << ": " << start << "...; found " << row;
      for (const std::string& part : {rangeText(parameter.range), parameter.description}) {
        EXPECT_NE(row.find(part), std::string::npos) << entry->description.label << ": " << part;
      }
    }
    const auto model = someModel(*entry);
    EXPECT_EQ(rowOf(text, "Properties", "color").empty(), !model->hasColor()) << entry->description.label;
    for (const EntityModel::Property& property : model->properties) {
      const std::string end = " | " + property.unit + (property.unit.empty() ? "| " : " | ") +
                              rangeText(property.range) + (rangeText(property.range).empty() ? "| " : " | ") +
                              property.description + " |";
      const std::string row = rowOf(text, "Properties", property.name);
      EXPECT_NE(row.find(end), std::string::npos) << entry->description.label << ": ..." << end << "; found " << row;
    }
  }
}

TEST(ExperimentPageTest, NamesAllErrorsOfDevices) {
  for (const ErrorKind* kind : errorKinds()) {
    const std::string start = "\n| `" + kind->description.name + "` |";
    const std::size_t row = page().find(start);
    ASSERT_NE(row, std::string::npos) << kind->description.name;
    const std::size_t column = row + start.size();
    const std::string attributes = page().substr(column, page().find('|', column) - column);
    for (const Parameter& parameter : kind->description.parameters) {
      EXPECT_NE(attributes.find("`" + parameter.name + "`"), std::string::npos) << start << parameter.name;
    }
    const auto quotes = static_cast<std::size_t>(std::count(attributes.begin(), attributes.end(), '`'));
    EXPECT_EQ(quotes, 2 * kind->description.parameters.size()) << start;
  }
}

TEST(ExperimentPageTest, NamesAllOfARuleForHandover) {
  for (const char* name : {"inside", "outside", "attached", "released", "debug", "minimum", "maximum", "key"}) {
    EXPECT_NE(page().find("`" + std::string(name) + "`"), std::string::npos) << name;
  }
  for (const char* text : {"`<handover entity=\"...\" to=\"...\">`", "`as=\"gripper\"`", "`as=\"gripped\"`"}) {
    EXPECT_NE(page().find(text), std::string::npos) << text;
  }
}

TEST(ThesisListingTest, LoadsUnderItsOldNames) {
  loadBuiltInPlugins();
  takeExperimentWarnings();
  const Experiment experiment = readExperiment(std::string(TEST_DATA) + "/thesis_listing.xml");
  EXPECT_EQ(takeExperimentWarnings().size(), 2U) << "the two folders of controller_path";
  ASSERT_EQ(experiment.controllers.size(), 2U);
  const ControllerDescription& controller = experiment.controllers[0];
  EXPECT_EQ(controller.label, "sample_footbot_controller");
  EXPECT_EQ(controller.actuators[0].implementation, "default");
  EXPECT_EQ(controller.sensors[0].type, "footbot_camera");
  EXPECT_EQ(controller.sensors[0].implementation, "color_blobs");
  EXPECT_EQ(controller.sensors[1].implementation, "polynomial");
  EXPECT_EQ(experiment.engines[1].label, "kinematics2d");
  EXPECT_EQ(experiment.engines[1].parameters.number("distance"), 1.0);
  EXPECT_EQ(experiment.visualisations.size(), 2U);
  Experiment without_files = experiment;
  without_files.visualisations.clear();
  const Simulation simulation(std::move(without_files));
  EXPECT_EQ(simulation.robotCount(), 2U);
}

}  // namespace
}  // namespace swarmanoid
