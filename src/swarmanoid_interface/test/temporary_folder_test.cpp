// Folders for temporary files.
#include "swarmanoid_interface/process/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <optional>
#include <stdexcept>

namespace swarmanoid {
namespace {

namespace fs = std::filesystem;

TEST(TemporaryFolderTest, IsNewAndGoesWithAllThatIsInIt) {
  std::optional<TemporaryFolder> folder("some_test");
  const TemporaryFolder other("some_test");
  const fs::path path = folder->path();
  EXPECT_NE(path, other.path());
  EXPECT_EQ(path.parent_path(), fs::temp_directory_path());
  EXPECT_EQ(path.filename().string().rfind("swarmanoid_some_test_", 0), 0U) << path;
  EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_all);
  fs::create_directory(path / "inner");
  std::ofstream(path / "inner/file") << "text";
  folder.reset();
  EXPECT_FALSE(fs::exists(path));
  EXPECT_TRUE(fs::is_directory(other.path()));
}

TEST(TemporaryFolderTest, IsWhereTheUserWantsSuchFiles) {
  const TemporaryFolder outer("some_test");
  const char* before = std::getenv("TMPDIR");
  const std::optional<std::string> put_back = before == nullptr ? std::nullopt : std::optional<std::string>(before);
  setenv("TMPDIR", outer.path().c_str(), 1);
  EXPECT_EQ(TemporaryFolder("inner").path().parent_path(), outer.path());
  try {
    const TemporaryFolder folder("no/such");
    FAIL();
  } catch (const std::runtime_error& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.rfind("cannot make the folder " + outer.path().string() + "/swarmanoid_no/such_", 0), 0U) << text;
    EXPECT_NE(text.find(": No such file or directory"), std::string::npos) << text;
  }
  put_back ? setenv("TMPDIR", put_back->c_str(), 1) : unsetenv("TMPDIR");
}

}  // namespace
}  // namespace swarmanoid
