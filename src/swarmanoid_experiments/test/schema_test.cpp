// The schema and the parser agree: on good files, on bad ones within a schema's possibilities, and on every name.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "bad_cases.hpp"
#include "swarmanoid_experiment_files/experiment_schema.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/error_models/error_model.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"

namespace swarmanoid {
namespace {

namespace fs = std::filesystem;

fs::path writeFile(const std::string& name, const std::string& text) {
  static const TemporaryFolder folder("schema_test");
  fs::path file = folder.path() / name;
  std::ofstream(file) << text;
  return file;
}

/// The schema of the suite's own plugins, as installed.
const std::string& schema() {
  static const std::string text = [] {
    loadBuiltInPlugins();
    return suiteSchema();
  }();
  return text;
}

/// Verdict of xmllint.
bool schemaAccepts(const fs::path& file, const fs::path& schema_file = {}) {
  static const fs::path suites_file = writeFile("schema.xsd", schema());
  const fs::path report = writeFile("report.txt", "");
  const int status =
      std::system(("xmllint --noout --schema '" + (schema_file.empty() ? suites_file : schema_file).string() + "' '" +
                   file.string() + "' 2>'" + report.string() + "'")
                      .c_str());
  std::ifstream reason(report);
  std::string words((std::istreambuf_iterator<char>(reason)), {});
  // any code other than valid or invalid means that xmllint is missing or the schema is wrong
  constexpr int kInvalid = 3;
  constexpr int kMalformed = 1;
  const int code = WEXITSTATUS(status);
  EXPECT_TRUE(code == 0 || code == kInvalid || code == kMalformed) << words;
  return code == 0;
}

class BadExperimentSchemaTest : public testing::TestWithParam<test::BadCase> {};

TEST_P(BadExperimentSchemaTest, SeesWhatASchemaCanSee) {
  EXPECT_EQ(!schemaAccepts(writeFile("bad_" + GetParam().name + ".xml", GetParam().text)),
            GetParam().refused_by_schema);
}

INSTANTIATE_TEST_SUITE_P(All, BadExperimentSchemaTest, testing::ValuesIn(test::badCases()),
                         [](const auto& bad) { return bad.param.name; });

TEST(SchemaTest, AcceptsGoodFiles) {
  for (const char* name : {"good.xml", "thesis_listing.xml"}) {
    EXPECT_TRUE(schemaAccepts(fs::path(TEST_DATA) / name)) << name;
  }
  int count = 0;
  for (const auto& entry : fs::directory_iterator(findShared("swarmanoid_experiments", "experiments"))) {
    if (entry.path().extension() == ".xml") {
      EXPECT_TRUE(schemaAccepts(entry.path())) << entry.path();
      ++count;
    }
  }
  EXPECT_GE(count, 2);
}

TEST(SchemaTest, IsInstalled) {
  const std::string file = findShared("swarmanoid_experiments", "experiment.xsd");
  ASSERT_FALSE(file.empty());
  std::ifstream installed(file);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(installed), {}), schema());
}

TEST(SchemaTest, AcceptsSectionsInAnyOrder) {
  std::string text = test::readTestData("good.xml");
  const std::string end = "</framework>\n";
  const std::size_t begin = text.find("  <framework>");
  const std::size_t length = text.find(end) + end.size() - begin;
  const std::string framework = text.substr(begin, length);
  text.erase(begin, length);
  text.insert(text.find("</ahss-config>"), framework);
  EXPECT_TRUE(schemaAccepts(writeFile("order.xml", text)));
  EXPECT_NO_THROW(parseExperiment(text, "order.xml"));
}

TEST(SchemaTest, AcceptsRulesForHandover) {
  std::string text = test::readTestData("good.xml");
  text.insert(text.find("  <arena_physics>") + std::string("  <arena_physics>").size(),
              "<handover entity=\"fb\" to=\"ground\" id=\"first\"><inside><maximum>1,2,3</maximum>"
              "<minimum>0,0,0</minimum></inside></handover>");
  text.insert(text.find("  </arena_physics>"),
              "<handover entity=\"fc\" to=\"ground\"><released as=\"gripped\"/></handover>"
              "<handover entity=\"fb\" to=\"ground\"><debug key=\"state of mind\"> lost </debug></handover>");
  EXPECT_TRUE(schemaAccepts(writeFile("handover.xml", text)));
  const Experiment experiment = parseExperiment(text, "handover.xml");
  ASSERT_EQ(experiment.handovers.size(), 3U);
  EXPECT_EQ(experiment.handovers[0].id, "first");
  EXPECT_EQ(experiment.handovers[0].maximum, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(experiment.handovers[1].condition, HandoverDescription::Condition::kReleased);
  EXPECT_EQ(experiment.handovers[1].end, HandoverDescription::End::kGripped);
  EXPECT_EQ(experiment.handovers[1].entity, "fc");
  EXPECT_EQ(experiment.handovers[2].key, "state of mind");
  EXPECT_EQ(experiment.handovers[2].value, "lost");
}

TEST(SchemaTest, AcceptsPresetsWhereTheyMayStand) {
  const std::string typical = "<realism>typical</realism>";
  std::string text = test::readTestData("good.xml");
  text.insert(text.find("</framework>"), typical);
  text.insert(text.find("<sensors>"), typical);
  text.insert(text.find("<sensors>") + std::string("<sensors>").size(),
              "<range_and_bearing_received>" + typical + "</range_and_bearing_received>");
  EXPECT_TRUE(schemaAccepts(writeFile("realism.xml", text)));
  EXPECT_NO_THROW(parseExperiment(text, "realism.xml"));
  text.replace(text.find(typical), typical.size(), "<realism>untypical</realism>");
  EXPECT_FALSE(schemaAccepts(writeFile("untypical.xml", text)));
}

TEST(SchemaTest, AcceptsRules) {
  std::string text = test::readTestData("good.xml");
  text.insert(text.find("  <visualisations>"),
              "<rules><foraging id=\"f\"><maximum>2,2,0</maximum><minimum>1,1,0</minimum><enough>3</enough></foraging>"
              "<my_rule id=\"g\" library=\"my_rule\"><anything>1</anything></my_rule></rules>");
  EXPECT_TRUE(schemaAccepts(writeFile("rules.xml", text)));
  text.erase(text.find("<my_rule"), text.find("</rules>") - text.find("<my_rule"));
  const Experiment experiment = parseExperiment(text, "rules.xml");
  ASSERT_EQ(experiment.rules.size(), 1U);
  EXPECT_EQ(experiment.rules[0].parameters.text("prey"), "prey") << "by default";
  EXPECT_EQ(experiment.rules[0].parameters.integer("enough"), 3);
}

TEST(SchemaTest, AcceptsErrorsOfDevices) {
  std::string text = test::readTestData("good.xml");
  text.insert(text.find("<range>0.1</range>"), "<error kind=\"gaussian\" deviation=\"0.1\"/>");
  text.insert(text.find("</footbot_proximity>"),
              "<error kind=\"stuck\" field=\"value[3]\" from_tick=\"5\" id=\"blind\"/>");
  EXPECT_TRUE(schemaAccepts(writeFile("errors.xml", text)));
  const Experiment experiment = parseExperiment(text, "errors.xml");
  const std::vector<ErrorModelDescription>& errors = experiment.controllers[0].sensors[0].errors;
  ASSERT_EQ(errors.size(), 2U);
  EXPECT_EQ(errors[0].kind, "gaussian");
  EXPECT_EQ(errors[0].parameters.number("deviation"), 0.1);
  EXPECT_EQ(errors[1].field, "value[3]");
  EXPECT_EQ(errors[1].from_tick, 5U);
}

TEST(SchemaTest, LetsThroughPluginsThatItDoesNotKnow) {
  std::string text = test::readTestData("good.xml");
  text.insert(text.find("  </visualisations>"),
              "<my_plot id=\"plot\" library=\"my_plot\"><color>any</color></my_plot>");
  EXPECT_TRUE(schemaAccepts(writeFile("own.xml", text)));
}

TEST(SchemaTest, AsksForTheLibraryWhereAFileMustNameIt) {
  loadBuiltInPlugins();
  const Registry& registry = Registry::instance();
  PluginLibraries libraries{{registry.find(PluginKind::kEngine, "kinematics2d"), "my_engine"}};
  for (const Registry::Entry* entry : registry.all(PluginKind::kActuator)) {
    if (entry->description.label == "footbot_wheels") {
      libraries[entry] = "my_wheels";
    }
  }
  const fs::path strict = writeFile("strict.xsd", experimentSchema(libraries));
  std::string text = test::readTestData("good.xml");
  const auto accepts = [&] { return schemaAccepts(writeFile("strict.xml", text), strict); };
  const auto insert_library = [&](const std::string& tag, const std::string& library) {
    ASSERT_NE(text.find("<" + tag), std::string::npos);
    for (std::size_t at = text.find("<" + tag); at != std::string::npos; at = text.find("<" + tag, at + 1)) {
      text.insert(at + 1 + tag.size(), " library=\"" + library + "\"");
    }
  };
  EXPECT_FALSE(accepts());
  insert_library("kinematics2d", "my_engine");
  EXPECT_FALSE(accepts()) << "that of the wheels is missing";
  insert_library("footbot_wheels", "");
  EXPECT_FALSE(accepts()) << "it has no name";
  text.replace(text.find("library=\"\""), 10, "library=\"./libmine.so\"");
  EXPECT_TRUE(accepts()) << "the file may be elsewhere";
}

TEST(SchemaTest, HasWhatLibrariesHaveBroughtSinceTheLastOne) {
  EXPECT_EQ(schema().find("\"jitter_of_the_test\""), std::string::npos);
  ErrorKind jitter;
  jitter.description = {"jitter_of_the_test", "", {errorParameter("jitter_depth", {0.0, 1.0}, "")}};
  [[maybe_unused]] const ErrorKindRegistration registration(jitter);
  EXPECT_NE(experimentSchema().find("value=\"jitter_of_the_test\""), std::string::npos);
  EXPECT_NE(experimentSchema().find("name=\"jitter_depth\""), std::string::npos);
}

TEST(SchemaTest, ChecksWhatAllImplementationsOfADeviceAllow) {
  loadBuiltInPlugins();
  std::string text = test::readTestData("good.xml");
  const auto accepts = [](const std::string& edited, const fs::path& schema_file) {
    return schemaAccepts(writeFile("implementations.xml", edited), schema_file);
  };
  const auto with_range = [&text](const std::string& implementation, const std::string& range) {
    std::string edited = text;
    const std::string old = "<range>0.1</range>";
    return edited.replace(edited.find(old), old.size(),
                          "<implementation>" + implementation + "</implementation><range>" + range + "</range>");
  };
  const auto add = [](const std::string& implementation, Range range) {
    PluginDescription sensor = Registry::instance().find(PluginKind::kSensor, "footbot_proximity")->description;
    sensor.implementation = implementation;
    sensor.implementation_aliases.clear();
    sensor.is_default = false;
    sensor.parameters[0].range = range;
    Registry::instance().add(PluginKind::kSensor, sensor, [] { return std::shared_ptr<void>(); });
  };
  ASSERT_EQ(Registry::instance().find(PluginKind::kSensor, "footbot_proximity")->description.parameters[0].name,
            "range");
  add("first_of_the_test", {0.001, 1.0});  // the same range as the polynomial's
  const fs::path alike = writeFile("alike.xsd", experimentSchema());
  EXPECT_TRUE(accepts(with_range("first_of_the_test", "0.2"), alike));
  EXPECT_TRUE(accepts(with_range("polynomial", "0.2"), alike));
  EXPECT_FALSE(accepts(with_range("second_of_the_test", "0.2"), alike));
  EXPECT_FALSE(accepts(with_range("first_of_the_test", "2"), alike));
  add("second_of_the_test", {0.001, 3.0});
  const fs::path different = writeFile("different.xsd", experimentSchema());
  EXPECT_TRUE(accepts(with_range("second_of_the_test", "2"), different)) << "it may have that range";
}

TEST(SchemaTest, LetsThroughTagsThatMeanPluginsOfTwoKinds) {
  EXPECT_NE(experimentSchema().find("<xs:element name=\"footbot_leds\""), std::string::npos);
  PluginDescription controller;
  controller.label = "footbot_leds";
  Registry::instance().add(PluginKind::kController, controller, [] { return std::shared_ptr<void>(); });
  EXPECT_EQ(experimentSchema().find("<xs:element name=\"footbot_leds\""), std::string::npos);
}

TEST(SchemaTest, KnowsEveryNameThatTheParserKnows) {
  loadBuiltInPlugins();
  const auto expect_name = [](const std::string& name) {
    EXPECT_NE(schema().find("name=\"" + name + "\""), std::string::npos) << name;
  };
  for (const PluginKind kind : kPluginKinds) {
    if (kind == PluginKind::kController) {
      continue;  // their parameters are free
    }
    for (const Registry::Entry* entry : Registry::instance().all(kind)) {
      expect_name(entry->description.label);
      for (const std::string& alias : entry->description.label_aliases) {
        expect_name(alias);
      }
      for (const std::string& alias : entry->description.implementation_aliases) {
        EXPECT_NE(schema().find("value=\"" + alias + "\""), std::string::npos) << alias;
      }
      for (const Parameter& parameter : entry->description.parameters) {
        expect_name(parameter.name);
      }
    }
  }
  expect_name("rules");
  for (const char* name : {"clocktick",      "maxclock",     "controller_path",
                           "random_seed",    "threads",      "real_time_factor",
                           "size",           "optimization", "bounded",
                           "floor_patch",    "distribute",   "quantity",
                           "layout",         "minimum",      "maximum",
                           "random_heading", "max_trials",   "controller",
                           "role",           "library",      "handover",
                           "entity",         "to",           "inside",
                           "outside",        "attached",     "released",
                           "debug",          "as",           "key",
                           "heightfield",    "floor",        "hole",
                           "realism"}) {
    expect_name(name);
  }
}

}  // namespace
}  // namespace swarmanoid
