// The record of a run as a folder: its contents, its independence of other files, and messages about damaged records.
#include "swarmanoid_recording/records/run_record.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/testing/write_png.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"
#include "swarmanoid_recording/output/run_files.hpp"
#include "swarmanoid_recording/records/record_folder.hpp"
#include "swarmanoid_recording/records/recorded_run.hpp"

namespace swarmanoid {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExperiment = R"(<ahss-config>
  <framework><clocktick>50</clocktick><maxclock>9</maxclock><random_seed>3</random_seed></framework>
  <arena size="6,5,3" optimization="2D">
    <heightfield><file> ../ground.png </file><position>2, 2, 0</position><size>2, 1</size><height>0.3</height></heightfield>
    <light id="lamp"><position>1, 1, 2</position><orientation>0, 0, 30</orientation><intensity>0.5</intensity></light>
    <block id="wall"><position>4.5, 4, 0.2</position><orientation>0, 0, 30</orientation><size>1, 0.1, 0.4</size></block>
  </arena>
  <visualisations><text_render id="table"><file>a &amp; "b".txt</file></text_render></visualisations>
</ahss-config>
)";

std::string textOf(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

class RunRecordTest : public testing::Test {
 protected:
  RunRecordTest() {
    loadPluginLibrary("swarmanoid_visualisations", {}, {});
    fs::create_directories(owner.path() / "mine");
    fs::create_directories(owner.path() / "out");
    write(owner.path() / "mine/hills.xml", kExperiment);
    test::writePng(owner.path() / "ground.png", 3, 8, {0, 51, 102, 153, 204, 255});
  }

  Experiment read(const std::vector<Override>& overrides) const {
    return readExperiment(owner.path() / "mine/hills.xml", overrides);
  }

  /// Runs the experiment for a number of ticks, and records it. @param result "": the run is killed
  void record(Experiment experiment, int ticks, const std::string& result = "{}\n") const {
    RunFiles files;
    files.folder = owner.path() / "out";
    RunContext context;
    context.out = openOutFolder(files, experiment);
    Simulation simulation(std::move(experiment), context);
    RecordFolder record(*context.out, "done", {"--record", {}, false}, recordOf(simulation.experiment(), "1.2.3+abc"));
    for (const auto& [label, file] : {std::pair("hash_recorder", record_files::kHashes),
                                      std::pair("intervention_recorder", record_files::kInterventions)}) {
      Configuration parameters(label, "", {});
      parameters.set("file", "done/" + std::string(file));
      addObserver(simulation, context, "--record", label, parameters);
    }
    context.out->keep();
    record.begin();
    simulation.start();
    for (int i = 0; i < ticks; ++i) {
      if (i == 2) {
        simulation.apply(DeleteEntity{"wall"});
      }
      simulation.tick();
    }
    simulation.finish();
    if (!result.empty()) {
      record.finish(result);
    }
  }

  std::string refusal() const {
    try {
      const RecordedRun run = readRecordedRun(folder);
      const Experiment experiment = experimentOf(run);
      interventionsOf(run, experiment);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }

  const TemporaryFolder owner{"run_record_test"};
  const std::string folder = owner.path() / "out/done";
};

TEST_F(RunRecordTest, TheTextAfterOverridesIsReadAsTheSameExperiment) {
  Experiment first = read({{"arena.lamp.intensity", "0.75"}, {"arena.bounded", "true"}, {"framework.maxclock", "8"}});
  first.framework.seed = 18446744073709551615U;
  const double height = first.arena.terrain->heightAt(2.3, 2.1);
  ASSERT_GT(height, 0.0);
  record(first, 5);
  fs::remove(owner.path() / "ground.png");
  fs::remove_all(owner.path() / "mine");
  fs::rename(folder, owner.path() / "elsewhere");

  const RecordedRun run = readRecordedRun(owner.path() / "elsewhere");
  const Experiment second = experimentOf(run);
  EXPECT_EQ(second.name, "hills");
  EXPECT_EQ(second.framework.seed, 18446744073709551615U);
  EXPECT_EQ(second.framework.max_clock, 8U);
  EXPECT_EQ(second.framework.clocktick, std::chrono::milliseconds(50));
  EXPECT_TRUE(second.arena.bounded);
  ASSERT_EQ(second.arena.entities.size(), 2U);
  EXPECT_EQ(second.arena.entities[0].parameters.number("intensity"), 0.75);
  EXPECT_EQ(second.arena.entities[1].angles.z(), first.arena.entities[1].angles.z());
  EXPECT_EQ(second.visualisations[0].parameters.text("file"), "a & \"b\".txt");
  EXPECT_EQ(second.arena.terrain->heightAt(2.3, 2.1), height);
  EXPECT_EQ(run.record.version, "1.2.3+abc");
  EXPECT_EQ(run.ticks(), 5U);
  EXPECT_FALSE(run.record.is_open);
  const auto interventions = interventionsOf(run, second).interventions;
  ASSERT_EQ(interventions.size(), 1U);
  EXPECT_EQ(interventions[0].taken.tick, 2U);
}

TEST_F(RunRecordTest, ARecordOfARecordHasTheSameExperiment) {
  record(read({}), 1);
  const RecordedRun run = readRecordedRun(folder);
  const RunRecord first = recordOf(read({}), "");
  const RunRecord second = recordOf(experimentOf(run), "");
  EXPECT_EQ(second.seed, 3U);
  ASSERT_EQ(second.files.size(), 1U);
  EXPECT_EQ(first.files[0].name, "files/1_ground.png");
  EXPECT_EQ(second.files[0].content, first.files[0].content);
}

TEST_F(RunRecordTest, WhatIsDamagedIsNamed) {
  struct Damage {
    std::string file;
    std::function<std::string(const std::string&)> change;
    std::string message;
  };
  const auto replaced = [](const std::string& from, const std::string& to) {
    return [from, to](std::string text) { return text.replace(text.find(from), from.size(), to); };
  };
  const auto cut = [](std::size_t bytes) {
    return [bytes](const std::string& text) { return text.substr(0, text.size() - bytes); };
  };
  const std::vector<Damage> damages{
      {"record.xml", replaced("format=\"1\"", "format=\"2\""),
       "record.xml:1: format: found '2', allowed: 1; another version of the suite has written this record"},
      {"record.xml", replaced("seed=\"3\"", "seed=\"-3\""),
       "record.xml:1: seed: found '-3', allowed: a whole number from 0 to 18446744073709551615"},
      {"record.xml", replaced("files/1_ground.png", "../ground.png"),
       "record.xml:3: name: found '../ground.png', allowed: a file of the record"},
      {"record.xml", cut(20), "record.xml:"},
      {"experiment.xml", replaced("<maxclock>9", "<maxclock>8"), "experiment.xml: found a content with the hash "},
      {"files/1_ground.png", cut(1), "files/1_ground.png: found a content with the hash "},
      {"hashes.txt", cut(3), "hashes.txt:6: found '5 "},
      {"hashes.txt", replaced("\n2 ", "\n3 "), "hashes.txt:3: found tick 3, allowed: tick 2 in this line"},
      {"hashes.txt", replaced("\n2 ", "\ntwo "), "hashes.txt:3: found 'two "},
      {"hashes.txt", [](const std::string&) { return ""; },
       "hashes.txt:1: found '' at the end, allowed: whole lines, at least that of tick 0"},
      {"interventions.xml", replaced("</interventions>\n", ""),
       "interventions.xml: found no </interventions> at the end, allowed: a file that ends with it"},
      {"interventions.xml", replaced("<delete ", "<delte "), "interventions.xml:2: found tag 'delte', allowed: "}};
  record(read({}), 5);
  EXPECT_EQ(refusal(), "");
  for (const Damage& damage : damages) {
    const fs::path file = fs::path(folder) / damage.file;
    const std::string whole = textOf(file);
    write(file, damage.change(whole));
    const std::string expected = folder + "/" + damage.message;
    EXPECT_EQ(refusal().substr(0, expected.size()), expected) << damage.file;
    fs::remove(file);
    EXPECT_EQ(refusal(), file.string() + ": cannot be read");
    write(file, whole);
  }
}

TEST_F(RunRecordTest, OfARunThatWasKilledThereIsWhatItHasWritten) {
  record(read({}), 5, "");
  const fs::path hashes = fs::path(folder) / "hashes.txt";
  const fs::path interventions = fs::path(folder) / "interventions.xml";
  write(hashes, textOf(hashes).substr(0, textOf(hashes).size() - 7));
  write(interventions, textOf(interventions).substr(0, textOf(interventions).find("</interventions>")));
  const RecordedRun run = readRecordedRun(folder);
  EXPECT_EQ(run.ticks(), 4U);
  EXPECT_EQ(run.missing, std::vector<std::string>{"the run has no result: it was killed, or is not over; what there is "
                                                  "ends with tick 4"});
  EXPECT_EQ(interventionsOf(run, experimentOf(run)).interventions.size(), 1U);
}

TEST_F(RunRecordTest, ItsFilesObeyTheRulesOfTheOutFolder) {
  record(read({}), 1);
  OutFolder out(owner.path() / "out", "--", {});
  try {
    const RecordFolder second(out, "done", {"--record", {}, false}, recordOf(read({}), ""));
    ADD_FAILURE() << "it is replaced";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "--record: found 'done/record.xml', which is there already, allowed: another name, or --force to "
                 "replace it");
  }
  EXPECT_EQ(refusal(), "");
}

TEST_F(RunRecordTest, AFolderOfARunThatDoesNotBeginGoesAgain) {
  {
    OutFolder out(owner.path() / "out", "--", {});
    const RecordFolder record(out, "a/b", {"--record", {}, false}, recordOf(read({}), ""));
    EXPECT_TRUE(fs::exists(owner.path() / "out/a/b/files/1_ground.png"));
  }
  EXPECT_FALSE(fs::exists(owner.path() / "out/a"));
  EXPECT_TRUE(fs::exists(owner.path() / "out"));
}

TEST_F(RunRecordTest, DifferencesAreSaid) {
  RunRecord recorded;
  recorded.version = "1+a";
  recorded.libraries = {{"liba.so", 255}, {"libb.so", 1}};
  RunRecord here = recorded;
  EXPECT_EQ(differences(recorded, here), std::vector<std::string>{});
  here.version = "2+b";
  here.libraries = {{"liba.so", 256}};
  EXPECT_EQ(
      differences(recorded, here),
      (std::vector<std::string>{"recorded with the version 1+a, made again with 2+b",
                                "recorded with another liba.so: its hash was 00000000000000ff, and is 0000000000000100",
                                "recorded with the library libb.so, made again without it"}));
}

TEST_F(RunRecordTest, RobotsThatOtherProcessesCommandedAreNamed) {
  RecordedRun run;
  Experiment experiment;
  EntityDescription robot;
  robot.controller = "c";
  robot.id = "fb_1";
  experiment.arena.entities.push_back(robot);
  robot.id = "fb_2";
  robot.source = CommandSource::kRemote;
  experiment.arena.entities.push_back(robot);
  InterventionFile interventions;
  interventions.interventions.push_back({{SetCommandSource{"fb_3", CommandSource::kTopics}, "", 4, false}, {}});
  interventions.interventions.push_back({{SetCommandSource{"fb_1", CommandSource::kNone}, "", 5, false}, {}});
  EXPECT_EQ(robotsOfOthers(run, experiment, interventions), std::vector<std::string>{}) << "nobody could";
  run.record.is_open = true;
  EXPECT_EQ(robotsOfOthers(run, experiment, interventions), (std::vector<std::string>{"fb_2", "fb_3"}));
}

}  // namespace
}  // namespace swarmanoid
