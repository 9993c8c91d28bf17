// Experiment files without the suite's plugins: controllers, devices, engines and visualisations made up for the test.
#include "swarmanoid_space/experiment_file/experiment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "swarmanoid_interface/process/temporary_folder.hpp"
#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid {
namespace {

Parameter parameter(const std::string& name, Parameter::Type type, std::optional<std::string> value, Range range = {}) {
  return makeParameter(name, type, "", std::move(value), range, "");
}

void add(PluginKind kind, const std::string& label, const std::string& implementation,
         const std::vector<Parameter>& parameters, const std::vector<std::string>& label_aliases = {},
         const std::vector<std::string>& implementation_aliases = {}) {
  PluginDescription description;
  description.label = label;
  description.implementation = implementation;
  description.parameters = parameters;
  description.label_aliases = label_aliases;
  description.implementation_aliases = implementation_aliases;
  const bool is_device = kind == PluginKind::kSensor || kind == PluginKind::kActuator;
  description.robots = is_device ? std::vector<std::string>{"footbot"} : std::vector<std::string>{};
  Registry::instance().add(kind, description, [] { return std::shared_ptr<void>(); });
}

const char* const kFile = R"(<ahss-config>
  <framework>
    <clocktick>12.5</clocktick>
    <maxclock><!-- ticks -->500</maxclock>
  </framework>
  <controllers>
    <wander id="slow">
      <actuators><wheels/></actuators>
      <sensors>
        <eye><implementation> old_eye </implementation><range>2</range></eye>
      </sensors>
      <parameters shy="true"><speed>0.5</speed><![CDATA[ ]]></parameters>
    </wander>
  </controllers>
  <arena size="10,9,3" optimization="3D">
    <footbot id="fb">
      <position>9, 8, 0</position>
      <orientation>0, 0, 90</orientation>
      <controller>slow</controller>
    </footbot>
    <floor_patch id="nest"><position>1, 1, 0</position><size>2, 1</size><color>1,2,3</color></floor_patch>
    <distribute quantity="3">
      <minimum>0, 0, 0</minimum>
      <maximum>1, 1, 0</maximum>
      <cylindric_prey id="prey"><radius>0.1</radius><height>0.2</height></cylindric_prey>
    </distribute>
  </arena>
  <engines>
    <old_plane id="ground"/>
    <plane id="sky"><height>1e0</height></plane>
  </engines>
  <arena_physics>
    <engine id="ground"><entity id="prey"/><entity id="fb" role="mirror"/></engine>
    <engine id="sky"><entity id="fb" role="move"/></engine>
  </arena_physics>
  <visualizations>
    <table id="t"/>
  </visualizations>
</ahss-config>
)";

class ExperimentTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    using Type = Parameter::Type;
    add(PluginKind::kController, "wander", "", {});
    add(PluginKind::kActuator, "wheels", "default", {parameter("noise", Type::kNumber, "0", {0.0, 1.0})});
    add(PluginKind::kSensor, "eye", "blobs", {parameter("range", Type::kNumber, "1", {0.0, 9.0})}, {"pie"},
        {"old_eye"});
    add(PluginKind::kSensor, "eye", "pixels", {parameter("width", Type::kInteger, std::nullopt, {1.0, 4096.0})});
    add(PluginKind::kSensor, "sonar", "default", {parameter("error", Type::kNumber, "0")});
    add(PluginKind::kEngine, "plane", "", {parameter("height", Type::kNumber, "0")}, {"old_plane"});
    add(PluginKind::kObserver, "table", "", {parameter("file", Type::kText, "")});
  }

  static Experiment parse(const std::vector<Override>& overrides = {}) {
    return parseExperiment(kFile, "folder/some.xml", overrides);
  }

  static std::string refusal(const std::vector<Override>& overrides, const std::string& text = kFile) {
    try {
      parseExperiment(text, "some.xml", overrides);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "(accepted)";
  }
};

TEST_F(ExperimentTest, ReadsFrameworkWithDefaults) {
  const Experiment experiment = parse();
  EXPECT_EQ(experiment.name, "some");
  EXPECT_EQ(experiment.file, "folder/some.xml");
  EXPECT_EQ(experiment.text, kFile);
  EXPECT_EQ(experiment.framework.clocktick, std::chrono::microseconds(12500));
  EXPECT_EQ(experiment.framework.max_clock, 500U);
  EXPECT_EQ(experiment.framework.seed, 1U);
  EXPECT_EQ(experiment.framework.threads, 1);
  EXPECT_EQ(experiment.framework.real_time_factor, 0.0);
  EXPECT_TRUE(experiment.framework.controller_path.empty());
}

TEST_F(ExperimentTest, ReadsControllersWithTheirDevices) {
  const Experiment experiment = parse();
  ASSERT_EQ(experiment.controllers.size(), 1U);
  const ControllerDescription& controller = experiment.controllers[0];
  EXPECT_EQ(controller.label, "wander");
  EXPECT_EQ(controller.id, "slow");
  EXPECT_EQ(controller.library, "") << "the label is known, so no library is looked for";
  EXPECT_EQ(controller.location.line, 7);
  ASSERT_EQ(controller.actuators.size(), 1U);
  EXPECT_EQ(controller.actuators[0].implementation, "default");
  EXPECT_EQ(controller.actuators[0].parameters.number("noise"), 0.0);
  ASSERT_EQ(controller.sensors.size(), 1U);
  EXPECT_EQ(controller.sensors[0].implementation, "blobs");
  EXPECT_EQ(controller.sensors[0].parameters.number("range"), 2.0);
  EXPECT_EQ(controller.parameters.number("speed"), 0.5);
  EXPECT_TRUE(controller.parameters.boolean("shy")) << "an attribute is as good as an element";
}

TEST_F(ExperimentTest, EachImplementationHasItsOwnParameters) {
  std::string text = kFile;
  text.replace(text.find(" old_eye "), 9, "pixels");
  EXPECT_EQ(refusal({}, text), "some.xml:10: found tag 'range', allowed: width, implementation, error (in <eye>)");
}

TEST_F(ExperimentTest, TheTagErrorIsNoParameter) {
  std::string text = kFile;
  const std::string eye = "<eye><implementation> old_eye </implementation><range>2</range></eye>";
  text.replace(text.find(eye), eye.size(), "<sonar/>");
  EXPECT_EQ(refusal({}, text),
            "some.xml:10: found the parameter 'error' of the implementation 'default', allowed: another name, since "
            "<error> in a device is an error model");
  text.replace(text.find("<sonar/>"), 8, "<eye><implementation>blobs</implementation><error kind='dead'/></eye>");
  EXPECT_EQ(refusal({}, text), "some.xml:10: found an error of 'eye', allowed: of a device with REGISTER_DEVICE");
}

TEST_F(ExperimentTest, AnImplementationIsNamedWhereNoneIsTheDefault) {
  std::string text = kFile;
  const std::string named = "<eye><implementation> old_eye </implementation><range>2</range></eye>";
  text.replace(text.find(named), named.size(), "<eye/>");
  EXPECT_EQ(refusal({}, text),
            "some.xml:10: found no <implementation> of sensor 'eye', which has no default, allowed: blobs, pixels");
}

TEST_F(ExperimentTest, ReadsArenaInRadians) {
  const ArenaDescription arena = parse().arena;
  EXPECT_EQ(arena.size, Eigen::Vector3d(10, 9, 3));
  EXPECT_EQ(arena.optimization, PositionalIndex::Optimization::k3D);
  EXPECT_FALSE(arena.bounded);
  ASSERT_EQ(arena.entities.size(), 2U);
  EXPECT_EQ(arena.entities[0].position, Eigen::Vector3d(9, 8, 0));
  EXPECT_DOUBLE_EQ(arena.entities[0].angles.z(), M_PI / 2);
  EXPECT_EQ(arena.entities[0].controller, "slow");
  EXPECT_FALSE(arena.entities[0].distribution.has_value());
  EXPECT_EQ(arena.entities[1].color, colors::kWhite);
  ASSERT_TRUE(arena.entities[1].distribution.has_value());
  EXPECT_EQ(arena.entities[1].distribution->quantity, 3U);
  EXPECT_EQ(arena.entities[1].distribution->layout, Distribution::Layout::kUniform);
  EXPECT_TRUE(arena.entities[1].distribution->random_heading);
  ASSERT_EQ(arena.floor_patches.size(), 1U);
  EXPECT_EQ(arena.floor_patches[0].color, (Color{1, 2, 3}));
}

TEST_F(ExperimentTest, ReadsEnginesAndTheirEntities) {
  const Experiment experiment = parse();
  ASSERT_EQ(experiment.engines.size(), 2U);
  EXPECT_EQ(experiment.engines[0].label, "plane");
  EXPECT_EQ(experiment.engines[0].parameters.number("height"), 0.0);
  EXPECT_EQ(experiment.engines[1].parameters.number("height"), 1.0);
  ASSERT_EQ(experiment.mappings.size(), 2U);
  ASSERT_EQ(experiment.mappings[0].members.size(), 2U);
  EXPECT_EQ(experiment.mappings[0].members[0].entity, "prey");
  EXPECT_FALSE(experiment.mappings[0].members[0].role.has_value());
  EXPECT_EQ(experiment.mappings[0].members[1].role, Role::kMirror);
  EXPECT_EQ(experiment.mappings[1].members[0].role, Role::kMove);
  ASSERT_EQ(experiment.visualisations.size(), 1U);
  EXPECT_EQ(experiment.visualisations[0].parameters.text("file"), "");
}

TEST_F(ExperimentTest, JoinsFoldersBrokenOverLinesAndWarnsOfThoseThatAreNotThere) {
  std::string text = kFile;
  const std::string folder = std::filesystem::temp_directory_path();
  text.insert(text.find("  </framework>"),
              "<controller_path>\n  /no/such/\\\n  folder:" + folder + "\n</controller_path>\n");
  takeExperimentWarnings();
  const Experiment experiment = parseExperiment(text, "some.xml");
  EXPECT_EQ(experiment.framework.controller_path, (std::vector<std::string>{"/no/such/folder", folder}));
  EXPECT_EQ(takeExperimentWarnings(),
            std::vector<std::string>{"some.xml:5: controller_path: '/no/such/folder' is not a folder"});
  EXPECT_TRUE(takeExperimentWarnings().empty());
}

TEST_F(ExperimentTest, ReadsFiles) {
  const TemporaryFolder folder("experiment_test");
  const std::filesystem::path file = folder.path() / "some.xml";
  std::ofstream(file) << "\xEF\xBB\xBF" << kFile;
  EXPECT_EQ(readExperiment(file.string()).name, "some");
  EXPECT_THROW(readExperiment("/no/such/file.xml"), ConfigError);
  EXPECT_THROW(readExperiment(folder.path().string()), ConfigError);
}

TEST_F(ExperimentTest, RefusesWhatIsNoExperiment) {
  EXPECT_EQ(refusal({}, ""), "some.xml: found an empty file, allowed: an <ahss-config> element");
  EXPECT_EQ(refusal({}, "<!-- nothing -->"), "some.xml:1: found no well-formed XML: Start tag expected, '<' not found");
  EXPECT_EQ(refusal({}, std::string("<ahss-config>\n\0</ahss-config>", 29)),
            "some.xml:2: found a zero byte, allowed: text");
  EXPECT_EQ(refusal({}, "<?xml version='1.0' encoding='ISO-8859-1'?>\n<ahss-config>\xE9</ahss-config>"),
            "some.xml:2: found bytes that are no text in UTF-8, allowed: UTF-8");
}

std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) {
    result += text;
  }
  return result;
}

TEST_F(ExperimentTest, RefusesWhatWouldTakeTimeOrMemoryWithoutBounds) {
  EXPECT_EQ(refusal({}, "<ahss-config>\n" + repeated("<a>", 20000)),
            "some.xml:2: found elements nested more than 200 deep, allowed: fewer");
  EXPECT_EQ(refusal({}, "<ahss-config>\n<" + std::string(60000, 'a') + "/></ahss-config>"),
            "some.xml:2: found no well-formed XML: Name too long: NCName");
  EXPECT_EQ(refusal({}, "<ahss-config>\n&#" + std::string(30000, '7') + ";</ahss-config>"),
            "some.xml:2: found no well-formed XML: xmlParseCharRef: character reference out of bounds");
  // entities of entities of entities: the document type that would hold them is refused
  EXPECT_EQ(refusal({}, "<!DOCTYPE a [<!ENTITY b 'c'><!ENTITY d '&b;&b;'>]><ahss-config>&d;</ahss-config>"),
            "some.xml:1: found '<!DOCTYPE', allowed: elements and comments <!-- ... -->");
  EXPECT_EQ(refusal({}, "<!DOCTYPE a SYSTEM '/etc/passwd'><ahss-config/>"),
            "some.xml:1: found '<!DOCTYPE', allowed: elements and comments <!-- ... -->");
}

TEST_F(ExperimentTest, CountsLinesHoweverManyTheyAreAndWhereverATagEnds) {
  const std::string text =
      "<ahss-config>" + repeated("\n", 70000) + "<framework\n  speed='1'\n/>\n<arena/></ahss-config>";
  EXPECT_EQ(refusal({}, text), "some.xml:70001: found attribute 'speed', allowed: none (in <framework>)");
  EXPECT_EQ(refusal({}, "<ahss-config>" + repeated("\n", 70000) + "text &amp; text\n\n<arena/></ahss-config>"),
            "some.xml:70001: found the text 'text & text' in <ahss-config>, allowed: only elements");
}

TEST_F(ExperimentTest, ReadsReferencesAndSectionsOfCharacters) {
  std::string text = kFile;
  const auto read = [&](const std::string& maxclock) {
    std::string changed = text;
    changed.replace(changed.find("500"), 3, maxclock);
    return parseExperiment(changed, "some.xml").framework.max_clock;
  };
  EXPECT_EQ(read("2&#" + std::string(30000, '0') + "48;"), 20U);
  EXPECT_EQ(read("&#x33;<![CDATA[4]]>5"), 345U);
}

TEST_F(ExperimentTest, ValuesOfOverridesStandForThemselves) {
  for (const char* value : {"a&amp;b", "<b>", "&#48;", "\xC3\xA9"}) {
    EXPECT_EQ(parse({{"visualisations.t.file", value}}).visualisations[0].parameters.text("file"), value);
    EXPECT_EQ(refusal({{"arena.bounded", value}}),
              "--set arena.bounded: bounded: found '" + std::string(value) + "', allowed: true, false");
  }
  EXPECT_EQ(refusal({{"visualisations.t.file", "\xE9"}}),
            "--set visualisations.t.file: found bytes that are no text in UTF-8, allowed: UTF-8");
}

TEST_F(ExperimentTest, OverridesReplaceValues) {
  EXPECT_EQ(parse({{"framework.maxclock", "7"}}).framework.max_clock, 7U) << "the comment before it is no part of it";
  EXPECT_EQ(parse({{"framework.random_seed", "9"}}).framework.seed, 9U) << "not in the file";
  EXPECT_EQ(parse({{"controllers.slow.parameters.speed", "2"}}).controllers[0].parameters.number("speed"), 2.0);
  EXPECT_FALSE(parse({{"controllers.slow.parameters.shy", "false"}}).controllers[0].parameters.boolean("shy"));
  EXPECT_EQ(parse({{"controllers.wander.actuators.wheels.noise", "1"}})
                .controllers[0]
                .actuators[0]
                .parameters.number("noise"),
            1.0);
  EXPECT_EQ(parse({{"engines.sky.height", "3"}}).engines[1].parameters.number("height"), 3.0);
  EXPECT_EQ(parse({{"visualisations.t.file", "x"}}).visualisations[0].parameters.text("file"), "x")
      << "either spelling of the section";
  EXPECT_EQ(parse({{"framework.maxclock", "7"}, {"framework.maxclock", "8"}}).framework.max_clock, 8U);
}

TEST_F(ExperimentTest, OverridesReplaceAttributes) {
  const Experiment experiment = parse({{"arena.bounded", "true"},
                                       {"arena.size", "10,9,5"},
                                       {"arena.distribute.quantity", "8"},
                                       {"arena.distribute.layout", "grid"},
                                       {"arena.prey.radius", "0.2"},
                                       {"arena_physics.ground.prey.role", "mirror"}});
  EXPECT_TRUE(experiment.arena.bounded);
  EXPECT_EQ(experiment.arena.size, Eigen::Vector3d(10, 9, 5));
  EXPECT_EQ(experiment.arena.entities[1].distribution->quantity, 8U);
  EXPECT_EQ(experiment.arena.entities[1].distribution->layout, Distribution::Layout::kGrid);
  EXPECT_EQ(experiment.arena.entities[1].parameters.number("radius"), 0.2);
  EXPECT_EQ(experiment.mappings[0].members[0].role, Role::kMirror);
}

TEST_F(ExperimentTest, OverridesReachRulesForHandover) {
  std::string text = kFile;
  text.insert(text.find("  </arena_physics>"),
              "<handover id=\"climb\" entity=\"fb\" to=\"sky\"><attached/></handover>"
              "<handover id=\"lost\" entity=\"fb\" to=\"ground\"><debug key=\"state\">lost</debug></handover>"
              "<handover id=\"up\" entity=\"prey\" to=\"sky\">"
              "<inside><minimum>1,1,0</minimum><maximum>2,2,1</maximum></inside></handover>");
  const auto rules = [&](const std::string& path, const std::string& value) {
    return parseExperiment(text, "some.xml", {{path, value}}).handovers;
  };
  EXPECT_EQ(rules("arena_physics.climb.to", "ground")[0].engine, "ground");
  EXPECT_EQ(rules("arena_physics.climb.attached.as", "gripped")[0].end, HandoverDescription::End::kGripped);
  EXPECT_EQ(rules("arena_physics.lost.debug", "found")[1].value, "found");
  EXPECT_EQ(rules("arena_physics.lost.debug.key", "mind")[1].key, "mind");
  EXPECT_EQ(rules("arena_physics.up.inside.maximum", "3,3,1")[2].maximum, Eigen::Vector3d(3, 3, 1));
  EXPECT_EQ(refusal({{"arena_physics.climb.attached.as", "hand"}}, text),
            "--set arena_physics.climb.attached.as: as: found the value 'hand', allowed: gripper, gripped");
  EXPECT_EQ(refusal({{"arena_physics.up.to", "sly"}}, text),
            "--set arena_physics.up.to: found the engine 'sly', allowed: ground, sky; did you mean 'sky'?");
}

TEST_F(ExperimentTest, MistakesInOverridesNameTheOverride) {
  EXPECT_EQ(refusal({{"framework.maxclock", "many"}}),
            "--set framework.maxclock: maxclock: found 'many', allowed: a whole number from 1 to 1e+15");
  EXPECT_EQ(refusal({{"arena.bounded", "yes"}}), "--set arena.bounded: bounded: found 'yes', allowed: true, false");
  EXPECT_EQ(refusal({{"arena.size", "1,1"}}),
            "--set arena.size: size: found '1,1', allowed: 3 numbers separated by commas, each from 0.1 to 10000");
  EXPECT_EQ(refusal({{"arena.fb.controller", "fast"}}),
            "--set arena.fb.controller: controller of a footbot: found the id 'fast', allowed: slow");
  EXPECT_EQ(refusal({{"framework.speed", "1"}}),
            "--set framework.speed: found tag 'speed', allowed: clocktick, maxclock, controller_path, random_seed, "
            "threads, real_time_factor (in <framework>)");
  EXPECT_EQ(refusal({{"engines.ground.depth", "1"}}),
            "--set engines.ground.depth: found tag 'depth', allowed: height (in <old_plane>)");
}

TEST_F(ExperimentTest, RefusesOverridesThatLeadNowhereOrToMoreThanOnePlace) {
  EXPECT_EQ(refusal({{"controllers.slwo.parameters.speed", "1"}}),
            "--set controllers.slwo.parameters.speed: found no tag or id 'slwo', allowed: slow; did you mean 'slow'? "
            "(in <controllers>)");
  EXPECT_EQ(refusal({{"arena_physics.engine.fb.role", "move"}}),
            "--set arena_physics.engine.fb.role: found 2 <engine> in <arena_physics>, allowed: a tag that stands there "
            "once, or an id");
  EXPECT_EQ(refusal({{"arena.fb", "1"}}),
            "--set arena.fb: found <footbot>, which holds elements, allowed: the path of a value");
  for (const char* path : {"maxclock", "", ".", "framework.", "framework..maxclock"}) {
    EXPECT_EQ(refusal({{path, "1"}}),
              "--set " + std::string(path) + ": allowed: section.name, such as framework.maxclock");
  }
}

TEST(FloorPatchTest, DiscAndRectangle) {
  FloorPatch disc;
  disc.position = {1, 1, 0};
  disc.radius = 0.5;
  EXPECT_TRUE(disc.contains({1.5, 1, 2}));
  EXPECT_FALSE(disc.contains({1.4, 1.4, 0}));
  EXPECT_EQ(disc.nearestPoint({3, 1, 2}), Eigen::Vector3d(1.5, 1, 0));
  EXPECT_EQ(disc.nearestPoint({1.25, 1, 2}), Eigen::Vector3d(1.25, 1, 0));

  FloorPatch rectangle;
  rectangle.position = {1, 1, 0};
  rectangle.size = {2, 1};
  EXPECT_TRUE(rectangle.contains({2, 1.5, 0}));
  EXPECT_FALSE(rectangle.contains({2, 1.6, 0}));
  EXPECT_EQ(rectangle.nearestPoint({5, 5, 1}), Eigen::Vector3d(2, 1.5, 0));
  EXPECT_EQ(rectangle.nearestPoint({1.5, 5, 1}), Eigen::Vector3d(1.5, 1.5, 0));
}

}  // namespace
}  // namespace swarmanoid
