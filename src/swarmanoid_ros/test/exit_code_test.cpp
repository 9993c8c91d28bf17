#include "../src/process/exit_code.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "swarmanoid_interface/process/temporary_folder.hpp"

namespace swarmanoid {
namespace {

namespace fs = std::filesystem;

class ExitCodeTest : public testing::Test {
 protected:
  static void put(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }
  static std::string textOf(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }
  std::size_t count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }
  std::string failure() const {
    try {
      writeExitCode(file, ExitCode::kControllerFailed);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  const TemporaryFolder owner{"exit_code_test"};
  const fs::path& folder = owner.path();
  fs::path file = folder / "code";
};

TEST_F(ExitCodeTest, ReplacesAnotherExitCodeAndNothingElse) {
  EXPECT_EQ(failure(), "");
  EXPECT_EQ(textOf(file), "3\n");
  put(file, "130\n");
  EXPECT_EQ(failure(), "");
  EXPECT_EQ(textOf(file), "3\n");
  put(file, "mine\n");
  EXPECT_EQ(failure(),
            "~exit_code: found '" + file.string() + "', which is there and holds no exit code, allowed: another name");
  EXPECT_EQ(textOf(file), "mine\n");
  EXPECT_EQ(count(), 1U);
}

TEST_F(ExitCodeTest, OtherFilesAreLeftAlone) {
  put(folder / "code.new", "mine");
  put(folder / "target", "mine too");
  EXPECT_EQ(failure(), "");
  EXPECT_EQ(textOf(folder / "code.new"), "mine");
  fs::remove(folder / "code.new");
  fs::create_symlink(folder / "target", folder / "code.new");
  EXPECT_EQ(failure(), "");
  EXPECT_EQ(textOf(folder / "target"), "mine too");
  EXPECT_TRUE(fs::is_symlink(folder / "code.new"));
  EXPECT_EQ(count(), 3U);
}

TEST_F(ExitCodeTest, AFileThatCannotBeWrittenLeavesWhatWasThere) {
  put(file, "2\n");
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit none{0, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &none), 0);
  const std::string found = failure();
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(found, "~exit_code: cannot write " + file.string() + ": File too large");
  EXPECT_EQ(textOf(file), "2\n");
  EXPECT_EQ(count(), 1U);
  file = folder / "nowhere/code";
  EXPECT_EQ(failure(), "~exit_code: cannot write " + file.string() + ": No such file or directory");
}

TEST_F(ExitCodeTest, endsAProcessThatALibraryDoesNotLetEnd) {
  const auto endBeforeALibrary = [] {
    std::atexit([] { pause(); });
    setExitCode(ExitCode::kFinished);
    alarm(40);
    std::exit(0);
  };
  EXPECT_EXIT(endBeforeALibrary(), testing::ExitedWithCode(0), "a library does not let the process end");
}

}  // namespace
}  // namespace swarmanoid
