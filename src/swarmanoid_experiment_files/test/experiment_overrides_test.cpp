// Overrides, "path=value": the values that they can set, and refused ones.
#include <string>
#include <vector>

#include "experiment_fixture.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"

namespace swarmanoid::test {
namespace {

class ExperimentOverridesTest : public ExperimentTest {};

TEST_F(ExperimentOverridesTest, ValuesOfOverridesStandForThemselves) {
  for (const char* value : {"a&amp;b", "<b>", "&#48;", "\xC3\xA9"}) {
    EXPECT_EQ(parse({{"visualisations.t.file", value}}).visualisations[0].parameters.text("file"), value);
    EXPECT_EQ(refusal({{"arena.bounded", value}}),
              "--set arena.bounded: bounded: found '" + std::string(value) + "', allowed: true, false");
  }
  EXPECT_EQ(refusal({{"visualisations.t.file", "\xE9"}}),
            "--set visualisations.t.file: found bytes that are no text in UTF-8, allowed: UTF-8");
}

TEST_F(ExperimentOverridesTest, WhatXmlCannotHoldIsRefusedInsteadOfCutOff) {
  const std::string refused = ": found a control character, such as a zero byte, allowed: text";
  const std::string path = "visualisations.t.file";
  EXPECT_EQ(refusal({{path, std::string("a\0b", 3)}}), "--set " + path + refused);
  EXPECT_EQ(refusal({{path, "\x1b"}}), "--set " + path + refused);
  const std::string longer_path = path + std::string("\0b", 2);
  EXPECT_EQ(refusal({{longer_path, "a"}}), "--set " + path + "?b" + refused);
  EXPECT_EQ(parse({{path, "a\tb"}}).visualisations[0].parameters.text("file"), "a\tb");
}

TEST_F(ExperimentOverridesTest, OverridesReplaceValues) {
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

TEST_F(ExperimentOverridesTest, OverridesReplaceAttributes) {
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

TEST_F(ExperimentOverridesTest, OverridesReachRulesForHandover) {
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

TEST_F(ExperimentOverridesTest, MistakesInOverridesNameTheOverride) {
  EXPECT_EQ(refusal({{"framework.maxclock", "many"}}),
            "--set framework.maxclock: maxclock: found 'many', allowed: a whole number from 1 to 1e+15");
  EXPECT_EQ(refusal({{"arena.bounded", "yes"}}), "--set arena.bounded: bounded: found 'yes', allowed: true, false");
  EXPECT_EQ(refusal({{"arena.size", "1,1"}}),
            "--set arena.size: size: found '1,1', allowed: 3 numbers separated by commas, each from 0.1 to 10000");
  EXPECT_EQ(refusal({{"arena.fb.controller", "fast"}}),
            "--set arena.fb.controller: controller of a footbot: found the id 'fast', allowed: slow");
  EXPECT_EQ(refusal({{"framework.speed", "1"}}),
            "--set framework.speed: found tag 'speed', allowed: clocktick, maxclock, controller_path, random_seed, "
            "threads, real_time_factor, realism (in <framework>)");
  EXPECT_EQ(refusal({{"engines.ground.depth", "1"}}),
            "--set engines.ground.depth: found tag 'depth', allowed: height (in <old_plane>)");
}

TEST_F(ExperimentOverridesTest, RefusesOverridesThatLeadNowhereOrToMoreThanOnePlace) {
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

}  // namespace
}  // namespace swarmanoid::test
