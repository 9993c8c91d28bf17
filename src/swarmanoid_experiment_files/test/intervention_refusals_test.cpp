// Files of interventions: messages about mistakes.
#include <gtest/gtest.h>

#include "swarmanoid_experiment_files/interventions/intervention_file.hpp"
#include "swarmanoid_experiment_files/testing/intervention_texts.hpp"

namespace swarmanoid {
namespace {

using test::fileOf;
using test::namedParts;

std::string refusalOf(const std::string& text) {
  try {
    parseInterventions(text, "f.xml", namedParts());
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

/// Refusal of a file with one element, in line 2.
std::string refusalIn(const std::string& element) { return refusalOf(fileOf(element)); }

TEST(InterventionRefusalsTest, AnotherRootOrKindIsRefused) {
  EXPECT_EQ(refusalOf("<intervention/>"), "f.xml:1: found the root element <intervention>, allowed: <interventions>");
  EXPECT_EQ(refusalOf("<interventions seeds='1'/>"),
            "f.xml:1: found attribute 'seeds', allowed: experiment, seed; did you mean 'seed'? (in <interventions>)");
  EXPECT_EQ(refusalOf("<interventions seed='-1'/>"), "f.xml:1: seed: found '-1', allowed: a whole number from 0");
  EXPECT_EQ(refusalIn("<mov tick='1'/>"),
            "f.xml:2: found tag 'mov', allowed: spawn, delete, move, handover, engine_parameters, command_source, "
            "property, paint, fault; did you mean 'move'? (in <interventions>)");
  EXPECT_EQ(refusalIn("text"), "f.xml:2: found the text 'text' in <interventions>, allowed: only elements");
  EXPECT_EQ(refusalOf(""), "f.xml: found an empty file, allowed: an <interventions> element");
  EXPECT_EQ(refusalOf(fileOf("")), "");
}

TEST(InterventionRefusalsTest, AFileWithoutItsEndIsRefusedWithWhatMendsIt) {
  const std::string whole = fileOf("<delete tick='1' entity='x'/>\n");
  EXPECT_EQ(refusalOf(whole), "");
  EXPECT_EQ(
      refusalOf(whole.substr(0, whole.rfind("</"))),
      "f.xml: found no </interventions> at the end, as a run that was killed leaves it, allowed: a file that ends "
      "with it");
  EXPECT_EQ(refusalOf(whole.substr(0, whole.rfind("entity"))).rfind("f.xml:", 0), 0U);
}

TEST(InterventionRefusalsTest, TicksAreWholeAndDoNotDescend) {
  EXPECT_EQ(refusalIn("<delete entity='x'/>"), "f.xml:2: <delete> needs the attribute tick=\"...\"");
  EXPECT_EQ(refusalIn("<delete tick='1.5' entity='x'/>").rfind("f.xml:2: tick: found '1.5', allowed: a whole", 0), 0U);
  EXPECT_EQ(refusalIn("<delete tick='5' entity='x'/>\n<delete tick='3' entity='x'/>"),
            "f.xml:3: tick: found '3' below a tick 5, allowed: 5 or later");
  EXPECT_EQ(refusalIn("<delete tick='5' after_rules='true' entity='x'/>\n<delete tick='5' entity='x'/>"),
            "f.xml:3: after_rules: found 'false' below one of the same tick with 'true', allowed: true");
  EXPECT_EQ(refusalIn("<delete tick='5' after_rules='yes' entity='x'/>"),
            "f.xml:2: after_rules: found 'yes', allowed: true, false");
}

TEST(InterventionRefusalsTest, WhatAKindDoesNotHaveIsRefused) {
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

TEST(InterventionRefusalsTest, PaintHasDiscsWithinTheirBounds) {
  const auto disc = [](const std::string& attributes) {
    return refusalIn("<paint tick='1'>\n<disc " + attributes + "/></paint>");
  };
  EXPECT_EQ(refusalIn("<paint tick='1'/>"), "f.xml:2: found no <disc> in <paint>, allowed: one or more");
  EXPECT_EQ(disc("position='1, 1' radius='0.1' color='red'"), "");
  EXPECT_EQ(disc("position='1, 1' radius='0.1'"), "f.xml:3: <disc> needs the attribute color=\"...\"");
  EXPECT_EQ(disc("position='1' radius='0.1' color='red'").rfind("f.xml:3: position: found '1', allowed: 2 numbers", 0),
            0U);
  EXPECT_EQ(disc("position='1, 1' radius='-1' color='red'").rfind("f.xml:3: radius: found '-1', allowed: ", 0), 0U);
  EXPECT_EQ(
      disc("position='1, 1' radius='1' color='red' strength='0'").rfind("f.xml:3: strength: found '0', allowed: ", 0),
      0U);
  EXPECT_EQ(disc("position='1, 1' radius='1' color='redd'").rfind("f.xml:3: color: found 'redd', allowed: ", 0), 0U);
}

TEST(InterventionRefusalsTest, AFaultIsOfADeviceAndHasErrorsAsInAnExperiment) {
  const auto refusalOfError = [](const std::string& error) {
    return refusalIn("<fault tick='1' robot='x' device='footbot_proximity'>\n" + error + "</fault>");
  };
  EXPECT_EQ(refusalIn("<fault tick='1' robot='x' device='footbot_proximty'/>"),
            "f.xml:2: found the device 'footbot_proximty', allowed: footbot_proximity; did you mean "
            "'footbot_proximity'?");
  EXPECT_EQ(refusalIn("<fault tick='1' device='footbot_proximity'/>"),
            "f.xml:2: <fault> needs the attribute robot=\"...\"");
  EXPECT_EQ(refusalOfError("<eror kind='dead'/>"),
            "f.xml:3: found tag 'eror', allowed: error; did you mean 'error'? (in <fault>)");
  EXPECT_EQ(refusalOfError("<error kind='bias' field='value[3]'/>"),
            "f.xml:3: <error> of the kind 'bias' needs the attribute offset=\"...\"");
  EXPECT_EQ(refusalOfError("<error kind='dead' deviation='1'/>"),
            "f.xml:3: found attribute 'deviation', allowed: kind, id, field, from_tick (in <error>)");
  EXPECT_EQ(refusalOfError("<error kind='stuck' field='valu'/>"),
            "f.xml:3: found the field 'valu', allowed: value; did you mean 'value'? (of footbot_proximity)");
  EXPECT_EQ(refusalOfError("<error kind='dead'/>"), "");
}

TEST(InterventionRefusalsTest, AMoveHasOnePositionAndOneOrientation) {
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

TEST(InterventionRefusalsTest, ASpawnHasOneEntityAsInAnArena) {
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

TEST(InterventionRefusalsTest, WhatCannotBeReadOrHasNoEndIsRefused) {
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

}  // namespace
}  // namespace swarmanoid
