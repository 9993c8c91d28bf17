// Files of interventions: what is written is read back to the same bits, and what is wrong is refused in words.
#include "swarmanoid_space/interventions/intervention_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include "small_world.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"
#include "swarmanoid_space/simulation/intervention_player.hpp"
#include "swarmanoid_space/simulation/run_files.hpp"

namespace swarmanoid {
namespace {

/// The small world, and two engines and a controller, which files may name.
Experiment namedParts() {
  Experiment experiment = test::smallWorld()->experiment();
  for (const char* id : {"ground", "air"}) {
    EngineDescription engine;
    engine.label = "dummy_engine";
    engine.id = id;
    experiment.engines.push_back(engine);
  }
  ControllerDescription controller;
  controller.id = "drive";
  experiment.controllers.push_back(controller);
  return experiment;
}

std::string fileOf(const std::string& elements) { return "<interventions>\n" + elements + "</interventions>\n"; }

/// Written, and read again.
TakenIntervention throughAFile(const TakenIntervention& taken) {
  const std::string text = interventionsBegin("small_world", 7) + toXml(taken, 1) + interventionsEnd();
  const InterventionFile file = parseInterventions(text, "test.xml", namedParts());
  EXPECT_EQ(file.experiment, "small_world");
  EXPECT_EQ(file.seed, "7");
  EXPECT_EQ(file.interventions.size(), 1U) << text;
  const TakenIntervention& read = file.interventions.front().taken;
  EXPECT_EQ(read.what.index(), taken.what.index());
  EXPECT_EQ(read.tick, taken.tick);
  EXPECT_EQ(read.asked_by, taken.asked_by);
  EXPECT_EQ(read.after_rules, taken.after_rules);
  return read;
}

template <class What>
What throughAFile(const What& what) {
  return std::get<What>(throughAFile(TakenIntervention{what, "", 3, false}).what);
}

/// Bit for bit: -0 is not 0 here.
template <class Numbers>
bool areSameBits(const Numbers& a, const Numbers& b) {
  return std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

constexpr double kTiny = std::numeric_limits<double>::denorm_min();
const double kAwkward = std::nextafter(0.1, 1.0);

EntityDescription footbotAt(const Eigen::Vector3d& position, const Eigen::Vector3d& angles) {
  EntityDescription entity;
  entity.type = "footbot";
  entity.id = "late";
  entity.position = position;
  entity.angles = angles;
  return entity;
}

TEST(InterventionFileTest, ASpawnHasPlaceAndAnglesToTheLastBit) {
  for (const Eigen::Vector3d& angles :
       {Eigen::Vector3d(M_PI, -M_PI / 2.0, std::nextafter(M_PI, 0.0)), Eigen::Vector3d(-0.0, kTiny, 1.0 / 3.0),
        Eigen::Vector3d(1e17, -1e-300, kAwkward)}) {
    const SpawnEntity spawn{footbotAt({2.0 / 3.0, kAwkward, -0.0}, angles), {"ground", "air"}};
    const SpawnEntity read = throughAFile(spawn);
    EXPECT_TRUE(areSameBits(read.entity.position, spawn.entity.position));
    EXPECT_TRUE(areSameBits(read.entity.angles, spawn.entity.angles));
    EXPECT_EQ(read.engines, spawn.engines);
    EXPECT_EQ(read.entity.id, "late");
    EXPECT_EQ(read.entity.type, "footbot");
  }
}

TEST(InterventionFileTest, ASpawnHasItsControllerAndWhoCommandsIt) {
  SpawnEntity spawn{footbotAt({1, 1, 0}, {0, 0, 0}), {}};
  spawn.entity.controller = "drive";
  EXPECT_EQ(throughAFile(spawn).entity.controller, "drive");
  EXPECT_EQ(throughAFile(spawn).entity.source, CommandSource::kController);
  spawn.entity.source = CommandSource::kTopics;
  EXPECT_EQ(throughAFile(spawn).entity.command_timeout, kCommandTimeout);
  for (const std::int64_t nanoseconds : {1000001L, 300000000L, 1234567891L, 3599999999999L}) {
    spawn.entity.command_timeout = std::chrono::nanoseconds(nanoseconds);
    EXPECT_EQ(throughAFile(spawn).entity.command_timeout, spawn.entity.command_timeout);
    EXPECT_EQ(throughAFile(spawn).entity.source, CommandSource::kTopics);
  }
}

TEST(InterventionFileTest, ASpawnHasTheValuesOfItsTypeAndItsColour) {
  SpawnEntity prey{footbotAt({1, 1, 0}, {0, 0, 0}), {}};
  prey.entity.type = "cylindric_prey";
  prey.entity.parameters.set("radius", "0.10000000000000002");
  prey.entity.parameters.set("height", "0.1");
  prey.entity.parameters.set("color", "blue");
  for (const Color color : {colors::kBlue, colors::kBlack, Color{1, 2, 3}}) {
    prey.entity.color = color;
    const EntityDescription read = throughAFile(prey).entity;
    EXPECT_EQ(read.color, color);
    EXPECT_EQ(read.parameters.number("radius"), kAwkward);
    EXPECT_EQ(read.parameters.text("color"), "blue");
  }
  SpawnEntity painted{footbotAt({1, 1, 0}, {0, 0, 0}), {}};
  EXPECT_EQ(throughAFile(painted).entity.color, colors::kBlack);
  painted.entity.color = {9, 8, 7};
  EXPECT_EQ(throughAFile(painted).entity.color, (Color{9, 8, 7}));
}

TEST(InterventionFileTest, AMoveHasItsQuaternionToTheLastBitNormalisedOrNot) {
  for (const Eigen::Quaterniond& q : {Eigen::Quaterniond(kAwkward, -0.0, kTiny, 1.0 / 3.0),
                                      Eigen::Quaterniond(2, -3e10, 5e-10, 0), orientationFromAngles({0.1, 0.2, 0.3})}) {
    const MoveEntity read = throughAFile(MoveEntity{"fb_1", {{-0.0, 2.0 / 3.0, kTiny}, q}});
    EXPECT_EQ(read.entity, "fb_1");
    EXPECT_TRUE(areSameBits(read.pose.orientation.coeffs(), q.coeffs()));
    EXPECT_TRUE(areSameBits(read.pose.position, Eigen::Vector3d(-0.0, 2.0 / 3.0, kTiny)));
  }
}

TEST(InterventionFileTest, TheOtherKindsHaveTheirWords) {
  EXPECT_EQ(throughAFile(DeleteEntity{"prey"}).entity, "prey");
  EXPECT_EQ(throughAFile(HandOverEntity{"prey", "air"}).entity, "prey");
  EXPECT_EQ(throughAFile(HandOverEntity{"prey", "air"}).engine, "air");
  const NamedValues values{{"gravity", "1e-3"}, {"friction", "0.10000000000000002"}, {"text", "a < \"b\" & 'c'"}};
  EXPECT_EQ(throughAFile(SetEngineParameters{"ground", values}).engine, "ground");
  EXPECT_EQ(throughAFile(SetEngineParameters{"ground", values}).values, values);
  for (const CommandSource source :
       {CommandSource::kController, CommandSource::kRemote, CommandSource::kTopics, CommandSource::kNone}) {
    EXPECT_EQ(throughAFile(SetCommandSource{"fb_1", source}).source, source);
    EXPECT_EQ(throughAFile(SetCommandSource{"fb_1", source}).robot, "fb_1");
  }
  const SetProperty property = throughAFile(SetProperty{"lamp", "intensity", "0.30000000000000004"});
  EXPECT_EQ(property.entity, "lamp");
  EXPECT_EQ(property.property, "intensity");
  EXPECT_EQ(property.value, "0.30000000000000004");
}

TEST(InterventionFileTest, OfAValueThatIsSetTwiceTheLastOneStaysThere) {
  const SetEngineParameters twice{"ground", {{"gravity", "1"}, {"friction", "2"}, {"gravity", "3"}}};
  const std::string text = interventionsBegin("x", 0) + toXml({twice, "", 0, false}) + interventionsEnd();
  const InterventionFile file = parseInterventions(text, "test.xml", namedParts());
  EXPECT_EQ(std::get<SetEngineParameters>(file.interventions.front().taken.what).values,
            (NamedValues{{"friction", "2"}, {"gravity", "3"}}));
}

TEST(InterventionFileTest, WhoAskedAndWhenIsInEachElement) {
  EXPECT_EQ(toXml({DeleteEntity{"prey"}, "rule 'a & b'", 12, true}),
            "<delete tick=\"12\" after_rules=\"true\" by=\"rule 'a &amp; b'\" entity=\"prey\"/>\n");
  throughAFile(TakenIntervention{DeleteEntity{"prey"}, "rule 'a & b'", 999999999999999, true});
}

TEST(InterventionFileTest, LooksAsOnThePage) {
  SpawnEntity spawn{footbotAt({1.5, 2, 0}, {0, 0, 0.5}), {"ground", "air"}};
  spawn.entity.controller = "drive";
  EXPECT_EQ(toXml({spawn, "", 2, false}, 1),
            "  <spawn tick=\"2\" engines=\"ground air\">\n    <footbot id=\"late\">\n"
            "      <position>1.5, 2, 0</position>\n      <angles>0, 0, 0.5</angles>\n"
            "      <controller>drive</controller>\n    </footbot>\n  </spawn>\n");
  EXPECT_EQ(toXml({MoveEntity{"prey", {{1, 2, 0}, Eigen::Quaterniond::Identity()}}, "", 3, false}, 1),
            "  <move tick=\"3\" entity=\"prey\">\n    <position>1, 2, 0</position>\n"
            "    <quaternion>1, 0, 0, 0</quaternion>\n  </move>\n");
}

TEST(InterventionFileTest, PeopleMayWriteDegreesAsInExperimentFiles) {
  const InterventionFile file = parseInterventions(
      fileOf("<spawn tick='1'><eyebot id='e'><position>1,1,1</position><orientation>0, 0, 90</orientation></eyebot>"
             "</spawn><move tick='1' entity='e'><position>1,1,1</position><orientation>0, 0, 180</orientation></move>"),
      "test.xml", namedParts());
  ASSERT_EQ(file.interventions.size(), 2U);
  EXPECT_NEAR(std::get<SpawnEntity>(file.interventions[0].taken.what).entity.angles.z(), M_PI / 2.0, 1e-15);
  EXPECT_NEAR(std::get<MoveEntity>(file.interventions[1].taken.what).pose.orientation.z(), 1.0, 1e-15);
}

std::string refusalOf(const std::string& text) {
  try {
    parseInterventions(text, "f.xml", namedParts());
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

/// Of one element, which is in line 2.
std::string refusalIn(const std::string& element) { return refusalOf(fileOf(element)); }

TEST(InterventionFileTest, AnotherRootOrKindIsRefused) {
  EXPECT_EQ(refusalOf("<intervention/>"), "f.xml:1: found the root element <intervention>, allowed: <interventions>");
  EXPECT_EQ(refusalOf("<interventions seeds='1'/>"),
            "f.xml:1: found attribute 'seeds', allowed: experiment, seed; did you mean 'seed'? (in <interventions>)");
  EXPECT_EQ(refusalOf("<interventions seed='-1'/>"), "f.xml:1: seed: found '-1', allowed: a whole number from 0");
  EXPECT_EQ(refusalIn("<mov tick='1'/>"),
            "f.xml:2: found tag 'mov', allowed: spawn, delete, move, handover, engine_parameters, command_source, "
            "property; did you mean 'move'? (in <interventions>)");
  EXPECT_EQ(refusalIn("text"), "f.xml:2: found the text 'text' in <interventions>, allowed: only elements");
  EXPECT_EQ(refusalOf(""), "f.xml: found an empty file, allowed: an <interventions> element");
  EXPECT_EQ(refusalOf(fileOf("")), "");
}

TEST(InterventionFileTest, AFileWithoutItsEndIsRefusedWithWhatMendsIt) {
  const std::string whole = fileOf("<delete tick='1' entity='x'/>\n");
  EXPECT_EQ(refusalOf(whole), "");
  EXPECT_EQ(
      refusalOf(whole.substr(0, whole.rfind("</"))),
      "f.xml: found no </interventions> at the end, as a run that was killed leaves it, allowed: a file that ends "
      "with it");
  EXPECT_EQ(refusalOf(whole.substr(0, whole.rfind("entity"))).rfind("f.xml:", 0), 0U);
}

TEST(InterventionFileTest, TicksAreWholeAndDoNotDescend) {
  EXPECT_EQ(refusalIn("<delete entity='x'/>"), "f.xml:2: <delete> needs the attribute tick=\"...\"");
  EXPECT_EQ(refusalIn("<delete tick='1.5' entity='x'/>").rfind("f.xml:2: tick: found '1.5', allowed: a whole", 0), 0U);
  EXPECT_EQ(refusalIn("<delete tick='5' entity='x'/>\n<delete tick='3' entity='x'/>"),
            "f.xml:3: tick: found '3' below a tick 5, allowed: 5 or later");
  EXPECT_EQ(refusalIn("<delete tick='5' after_rules='true' entity='x'/>\n<delete tick='5' entity='x'/>"),
            "f.xml:3: after_rules: found 'false' below one of the same tick with 'true', allowed: true");
  EXPECT_EQ(refusalIn("<delete tick='5' after_rules='yes' entity='x'/>"),
            "f.xml:2: after_rules: found 'yes', allowed: true, false");
}

TEST(InterventionFileTest, WhatAKindDoesNotHaveIsRefused) {
  EXPECT_EQ(refusalIn("<delete tick='1' entity='x' enity='y'/>"),
            "f.xml:2: found attribute 'enity', allowed: tick, by, after_rules, entity; did you mean 'entity'? (in "
            "<delete>)");
  EXPECT_EQ(refusalIn("<delete tick='1'/>"), "f.xml:2: <delete> needs the attribute entity=\"...\"");
  EXPECT_EQ(refusalIn("<delete tick='1' entity='x'><y/></delete>").rfind("f.xml:2: found tag 'y'", 0), 0U);
  EXPECT_EQ(refusalIn("<handover tick='1' entity='x' engine='grund'/>"),
            "f.xml:2: found the engine 'grund', allowed: ground, air; did you mean 'ground'?");
  EXPECT_EQ(refusalIn("<engine_parameters tick='1' engine='ground'/>"),
            "f.xml:2: found no value in <engine_parameters>, allowed: one or more");
  EXPECT_EQ(refusalIn("<engine_parameters tick='1' engine='ground'><a>1</a>\n<a>2</a></engine_parameters>"),
            "f.xml:3: found a second <a> in <engine_parameters>, allowed: one");
  EXPECT_EQ(refusalIn("<command_source tick='1' robot='x' source='topic'/>"),
            "f.xml:2: source: found the value 'topic', allowed: controller, remote, topics, none; did you mean "
            "'topics'?");
}

TEST(InterventionFileTest, AMoveHasOnePositionAndOneOrientation) {
  EXPECT_EQ(refusalIn("<move tick='1' entity='x'><position>1,1,1</position></move>"),
            "f.xml:2: <move> needs <orientation>");
  EXPECT_EQ(refusalIn("<move tick='1' entity='x'><quaternion>1,0,0,0</quaternion></move>"),
            "f.xml:2: <move> needs <position>");
  EXPECT_EQ(refusalIn("<move tick='1' entity='x'><position>1,1,1</position><quaternion>1,0,0,0</quaternion>\n"
                      "<orientation>0,0,0</orientation></move>"),
            "f.xml:3: found <orientation> beside <quaternion> in <move>, allowed: one of them");
  const std::string three = refusalIn(
      "<move tick='1' entity='x'><position>1,1,1</position>\n"
      "<quaternion>1,0,0</quaternion></move>");
  EXPECT_EQ(three.rfind("f.xml:3: quaternion: found '1,0,0', allowed: ", 0), 0U) << three;
}

TEST(InterventionFileTest, ASpawnHasOneEntityAsInAnArena) {
  const std::string place = "<position>1,1,0</position><orientation>0,0,0</orientation>";
  EXPECT_EQ(refusalIn("<spawn tick='1'/>"), "f.xml:2: found 0 entities in <spawn>, allowed: one");
  EXPECT_EQ(refusalIn("<spawn tick='1'><footbot id='x'>" + place + "</footbot><footbot id='y'>" + place +
                      "</footbot></spawn>"),
            "f.xml:2: found 2 entities in <spawn>, allowed: one");
  EXPECT_EQ(refusalIn("<spawn tick='1' engines='ground grund'><footbot id='x'>" + place + "</footbot></spawn>"),
            "f.xml:2: found the engine 'grund', allowed: ground, air; did you mean 'ground'?");
  EXPECT_EQ(refusalIn("<spawn tick='1'>\n<footbot id='x y'>" + place + "</footbot></spawn>"),
            "f.xml:3: id: found 'x y', allowed: letters, digits and _, a letter first");
  EXPECT_EQ(refusalIn("<spawn tick='1'>\n<footbot id='x'>" + place + "<controller>driv</controller></footbot></spawn>"),
            "f.xml:3: controller of a footbot: found the id 'driv', allowed: drive; did you mean 'drive'?");
  EXPECT_EQ(refusalIn("<spawn tick='1'>\n<footbot id='x'><position>9,1,0</position><angles>0,0,0</angles></footbot>"
                      "</spawn>"),
            "f.xml:3: position: found '9, 1, 0', allowed: in the arena, from 0, 0, 0 to 5, 5, 3");
  EXPECT_EQ(refusalIn("<spawn tick='1'>\n<footbot id='x'>" + place + "<angles>0,0,0</angles></footbot></spawn>"),
            "f.xml:3: found <orientation> beside <angles> in <footbot>, allowed: one of them");
  EXPECT_EQ(refusalIn("<spawn tick='1' color='purpel'><footbot id='x'>" + place + "</footbot></spawn>")
                .rfind("f.xml:2: color: found 'purpel', allowed: ", 0),
            0U);
}

TEST(InterventionFileTest, WhatIsStrangeAboutPlayingItIsSaid) {
  Experiment experiment = namedParts();  // small_world, seed 1, 50 ticks
  RuleDescription rule;
  rule.id = "mine";
  experiment.rules.push_back(rule);
  const std::string elements =
      "<delete tick='1' by=\"rule 'mine' (x)\" entity='x'/>\n<delete tick='2' by=\"rule 'gone' (x)\" entity='x'/>\n"
      "<delete tick='50' entity='x'/><delete tick='51' entity='x'/>";
  const InterventionFile file = parseInterventions(
      "<interventions experiment='other' seed='2'>\n" + elements + "</interventions>", "f.xml", experiment);
  using Lines = std::vector<std::string>;
  const Lines always{"f.xml: recorded with the experiment 'other', played into 'small_world'",
                     "f.xml: recorded with the seed 2, played into a run with the seed 1",
                     "f.xml:4: 2 interventions from tick 50 on will not be played, the run ends after 50 ticks"};
  Lines left_out = always;
  left_out.push_back(
      "f.xml: 1 intervention of rule 'gone' (x) will not be played, and the run has no such rule to ask "
      "for them");
  EXPECT_EQ(playingWarnings(file, AskedByRules::kLeftOut, experiment), left_out);
  Lines played = always;
  played.push_back(
      "f.xml: 1 intervention of rule 'mine' (x) will be played, and the run has that rule, which may ask "
      "for them too");
  EXPECT_EQ(playingWarnings(file, AskedByRules::kPlayed, experiment), played);
  EXPECT_EQ(InterventionPlayer(file, AskedByRules::kLeftOut).left(), 2U);
  EXPECT_EQ(InterventionPlayer(file, AskedByRules::kPlayed).left(), 4U);
}

TEST(InterventionFileTest, ThePlayerGivesEachInItsTickAndThoseAfterTheRulesAfterThem) {
  const InterventionFile file = parseInterventions(
      fileOf(
          "<delete tick='0' entity='a'/><delete tick='2' entity='b'/><delete tick='2' after_rules='true' entity='c'/>"),
      "f.xml", namedParts());
  InterventionPlayer player(file, AskedByRules::kLeftOut);
  const auto due = [&](std::uint64_t tick, bool after_rules) {
    std::string names;
    while (const RecordedIntervention* next = player.takeDue(tick, after_rules)) {
      names += std::get<DeleteEntity>(next->taken.what).entity;
    }
    return names;
  };
  for (int run = 0; run < 2; ++run) {
    EXPECT_EQ(due(0, false), "a");
    EXPECT_EQ(due(0, true), "");
    EXPECT_EQ(due(1, false) + due(1, true), "");
    EXPECT_EQ(due(2, false), "b");
    EXPECT_EQ(player.left(), 1U);
    EXPECT_EQ(due(2, true), "c");
    EXPECT_EQ(player.left(), 0U);
    player.restart();
  }
}

TEST(InterventionFileTest, WhatCannotBeReadOrHasNoEndIsRefused) {
  for (const auto& [file, problem] :
       {std::pair("/nowhere.xml", "cannot be read"), std::pair("/", "cannot be read"),
        std::pair("/dev/zero", "found a file without an end in sight, allowed: at most 268435456 characters")}) {
    try {
      readInterventions(file, namedParts());
      ADD_FAILURE() << file;
    } catch (const ConfigError& error) {
      EXPECT_EQ(error.what(), std::string(file) + ": " + problem);
    }
  }
}

class InterventionRecorderTest : public testing::Test {
 protected:
  InterventionRecorderTest() {
    loadPluginLibrary("swarmanoid_visualisations", {}, {});
    RunFiles files;
    files.prefix = "--";
    files.folder = owner.path();
    RunContext context;
    context.out = openOutFolder(files, {});
    Configuration parameters("intervention_recorder", "", {});
    parameters.set("file", "done.xml");
    addObserver(*simulation, context, "--save-interventions", "recorder", parameters);
    context.out->keep();
    simulation->start();
  }

  InterventionFile read() const { return readInterventions(owner.path() / "done.xml", simulation->experiment()); }

  const TemporaryFolder owner{"intervention_file_test"};
  const std::unique_ptr<Simulation> simulation = test::smallWorld(5);
};

TEST_F(InterventionRecorderTest, WritesAsTheRunGoesAndTheEndWhenItIsOver) {
  simulation->tick();
  simulation->apply(DeleteEntity{"prey"});
  simulation->tick();
  try {
    read();
    ADD_FAILURE() << "the run is not over";
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("found no </interventions> at the end"), std::string::npos);
  }
  std::ofstream(owner.path() / "done.xml", std::ios::app) << "</interventions>\n";  // as the page says
  EXPECT_EQ(read().interventions.size(), 1U);
  simulation->reset(9);
  simulation->tick();
  simulation->tick();
  simulation->apply(DeleteEntity{"lamp"});
  simulation->tick();
  simulation->finish();
  const InterventionFile file = read();
  EXPECT_EQ(file.seed, "9");
  EXPECT_EQ(file.experiment, "small_world");
  ASSERT_EQ(file.interventions.size(), 1U);
  EXPECT_EQ(file.interventions[0].taken.tick, 2U);
  EXPECT_EQ(std::get<DeleteEntity>(file.interventions[0].taken.what).entity, "lamp");
}

TEST_F(InterventionRecorderTest, ARunInWhichNothingWasDoneHasAWholeFile) {
  simulation->finish();
  EXPECT_TRUE(read().interventions.empty());
}

}  // namespace
}  // namespace swarmanoid
