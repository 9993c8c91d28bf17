// Files of a run that options request.
#include "swarmanoid_recording/output/run_files.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "swarmanoid_experiment_files/testing/small_world.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"

namespace swarmanoid {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

class RunFilesTest : public testing::Test {
 protected:
  RunFilesTest() {
    loadPluginLibrary("swarmanoid_visualisations", {}, {});
    files.prefix = "~";
    files.folder = owner.path() / "results/first";
  }

  /// Runs the small world and records its hashes in this file. @return the reason if it does not start
  std::string writeHashes(const std::string& name, const Experiment& experiment = {}) const {
    const auto simulation = test::smallWorld(2);
    Configuration parameters("hash_recorder", "", {});
    parameters.set("file", name);
    RunContext context;
    try {
      context.out = openOutFolder(files, experiment);
      addObserver(*simulation, context, "~hashes", "hashes", parameters);
    } catch (const ConfigError& error) {
      return error.what();
    }
    context.out->keep();
    simulation->start();
    while (!simulation->isFinished()) {
      simulation->tick();
    }
    simulation->finish();
    return "";
  }

  const TemporaryFolder owner{"run_files_test"};
  RunFiles files;
};

TEST_F(RunFilesTest, AreInTheirFolderWhichIsMade) {
  EXPECT_EQ(writeHashes("hashes.txt"), "");
  const std::string text = textOf(fs::path(files.folder) / "hashes.txt");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3) << text;
}

TEST_F(RunFilesTest, ARunThatDoesNotBeginNamesWhoAskedAndLeavesNothing) {
  EXPECT_EQ(writeHashes(""), "~hashes: found '', allowed: a file");
  EXPECT_FALSE(fs::exists(owner.path() / "results"));
  files.folder = owner.path() / "file/folder";
  std::ofstream(owner.path() / "file") << "mine";
  EXPECT_EQ(writeHashes("hashes.txt"), "~out: cannot make the folder '" + files.folder + "': Not a directory");
}

TEST_F(RunFilesTest, WhatTheRunReadsAndNeedsIsNotReplaced) {
  files.folder = owner.path();
  files.rules.replace = true;
  Experiment experiment;
  experiment.files = {owner.path() / "world.xml"};
  std::ofstream(experiment.files.front()) << "mine";
  EXPECT_EQ(writeHashes("world.xml", experiment),
            "~hashes: found 'world.xml', which this run reads, allowed: another name");
  EXPECT_EQ(textOf(experiment.files.front()), "mine");
  const std::string program = fs::canonical("/proc/self/exe");
  EXPECT_EQ(writeHashes(program), "~hashes: found '" + program + "', which this run reads, allowed: another name");
}

TEST_F(RunFilesTest, WhatWritesABagIsLoadedIfThereIsToBeOne) {
  const auto isLoaded = [] { return Registry::instance().find(PluginKind::kObserver, "rosbag_recorder") != nullptr; };
  openOutFolder(files, {});
  EXPECT_FALSE(isLoaded());
  files.records_bag = true;
  openOutFolder(files, {});
  EXPECT_TRUE(isLoaded());
}

}  // namespace
}  // namespace swarmanoid
