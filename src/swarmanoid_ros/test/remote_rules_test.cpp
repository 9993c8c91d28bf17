#include "../src/space/remote_rules.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"

namespace swarmanoid {
namespace {

namespace fs = std::filesystem;

/// Two folders; the user started the process in one of them.
class RemoteRulesTest : public testing::Test {
 protected:
  RemoteRulesTest() {
    fs::create_directory(folder / "mine");
    fs::create_directory(folder / "others");
    std::ofstream(folder / "mine/experiment.xml") << "<ahss-config/>";
    std::ofstream(folder / "others/experiment.xml") << "<ahss-config/>";
    setenv("SWARMANOID_FOLDER", (folder / "mine").c_str(), 1);
    unsetenv("SWARMANOID_ALLOW_REMOTE_FILES");
    unsetenv("SWARMANOID_ALLOW_REMOTE_LIBRARIES");
    options.experiment = folder / "mine/experiment.xml";
    options.out = folder / "mine/results";
  }
  ~RemoteRulesTest() override { allowLibrariesByPath(true); }

  std::string refusal() const {
    try {
      checkFiles(options, remoteRules(true));
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }
  std::string allowed(const std::string& what) const {
    return "', allowed, as other computers reach the master: " + what + "; or allow_remote_files:=true at start";
  }

  const TemporaryFolder owner{"remote_rules_test"};
  const fs::path& folder = owner.path();
  SpaceOptions options;
};

TEST_F(RemoteRulesTest, FilesInTheFolderAreAllowed) {
  options.record = "run.bag";
  options.hashes = "sub/hashes.txt";
  options.save_interventions = "done.xml";
  options.interventions = folder / "mine/todo.xml";
  EXPECT_EQ(refusal(), "");
}

TEST_F(RemoteRulesTest, OthersAreRefusedByName) {
  const std::string here = "files in " + (folder / "mine").string();
  options.experiment = folder / "others/experiment.xml";
  EXPECT_EQ(refusal(), "~experiment: found '" + options.experiment + allowed("installed experiments, " + here));
  options.experiment = folder / "mine/../others/experiment.xml";
  EXPECT_NE(refusal(), "") << "dots";
  fs::create_symlink(folder / "others/experiment.xml", folder / "mine/link.xml");
  options.experiment = folder / "mine/link.xml";
  EXPECT_NE(refusal(), "") << "a link";
  options.experiment = folder / "mine/experiment.xml";
  options.record = "../../others/run.bag";
  EXPECT_EQ(refusal(), "~record: found '../../others/run.bag" + allowed(here));
  options.record.clear();
  options.interventions = folder / "others/done.xml";
  EXPECT_EQ(refusal(), "~interventions: found '" + options.interventions + allowed(here));
  options.interventions.clear();
  options.save_interventions = "../../others/done.xml";
  EXPECT_EQ(refusal(), "~save_interventions: found '../../others/done.xml" + allowed(here));
  options.save_interventions.clear();
  options.out = folder.string() + "/mine_too";
  EXPECT_EQ(refusal(), "~out: found '" + options.out + allowed(here)) << "a name that begins alike";
  options.out = folder / "mine";
  options.write_anywhere = true;
  EXPECT_EQ(refusal(), "~write_anywhere: found 'true" + allowed("false"));
}

TEST_F(RemoteRulesTest, NothingIsReplaced) {
  options.force = true;
  EXPECT_EQ(refusal(), "~force: found 'true" + allowed("false"));
}

TEST_F(RemoteRulesTest, NoFolderForFilesIsWhereTheProcessWorks) {
  options.out = "";
  EXPECT_EQ(refusal(), "~out: found '." + allowed("files in " + (folder / "mine").string()));
  const fs::path before = fs::current_path();
  fs::current_path(folder / "mine");
  EXPECT_EQ(refusal(), "");
  fs::current_path(before);
}

TEST_F(RemoteRulesTest, TheFileOfTheExitCodeIsAskedForByItself) {
  const RemoteRules rules = remoteRules(true);
  EXPECT_NO_THROW(checkExitCodeFile("", rules));
  EXPECT_NO_THROW(checkExitCodeFile(folder / "mine/code.txt", rules));
  const std::string other = folder / "others/code.txt";
  EXPECT_NO_THROW(checkExitCodeFile(other, remoteRules(false)));
  try {
    checkExitCodeFile(other, rules);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_EQ(error.what(), "~exit_code: found '" + other + allowed("files in " + (folder / "mine").string()));
  }
}

TEST_F(RemoteRulesTest, AnythingIsAllowedWhereNobodyElseIsOrTheUserSaysSo) {
  options.experiment = folder / "others/experiment.xml";
  EXPECT_NO_THROW(checkFiles(options, remoteRules(false)));
  setenv("SWARMANOID_ALLOW_REMOTE_FILES", "true", 1);
  EXPECT_EQ(refusal(), "");
  EXPECT_FALSE(remoteRules(true).any_library) << "files are no libraries";
  setenv("SWARMANOID_ALLOW_REMOTE_FILES", "yes", 1);
  EXPECT_NE(refusal(), "") << "one word says it";
}

TEST_F(RemoteRulesTest, LibrariesThatAreNotInstalledCanBeRefused) {
  allowLibrariesByPath(false);
  for (const char* library : {"/somewhere/libmine.so", "libmine.so", "./mine"}) {
    try {
      loadPluginLibrary(library, {}, {"run.xml", 7});
      FAIL() << library;
    } catch (const ConfigError& error) {
      EXPECT_EQ(std::string(error.what()),
                "run.xml:7: library '" + std::string(library) +
                    "': found a file, allowed, as other computers reach the master: the name of an "
                    "installed library; or allow_remote_libraries:=true at start");
    }
  }
  std::ofstream(folder / "mine/swarm.py") << "raise RuntimeError()";
  try {
    parseExperiment(R"(<ahss-config><framework><clocktick>100</clocktick><maxclock>1</maxclock></framework>
      <controllers><turn id="c" source="python" file="swarm.py"/></controllers>
      <arena size="1,1,1" optimization="2D"/></ahss-config>)",
                    (folder / "mine/run.xml").string());
    FAIL() << "it was read";
  } catch (const ConfigError& error) {
    EXPECT_EQ(std::string(error.what()),
              (folder / "mine/run.xml").string() +
                  ":2: file: found 'swarm.py', allowed, as other computers reach the master: no code in files; or "
                  "allow_remote_libraries:=true at start");
  }
  std::ofstream(folder / "mine/libmine.so") << "none";
  try {
    loadPluginLibrary("mine", {folder / "mine"}, {"run.xml", 7});
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("found no libmine.so in "), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace swarmanoid
