// Paths inside a folder, in different spellings.
#include "swarmanoid_recording/output/inside_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "swarmanoid_interface/process/temporary_folder.hpp"

namespace swarmanoid {
namespace {

namespace fs = std::filesystem;

/// Creates mine/file, mine/sub/, mine_too/file, others/file.
class InsideFolderTest : public testing::Test {
 protected:
  InsideFolderTest() {
    for (const char* name : {"mine/sub", "mine_too", "others"}) {
      fs::create_directories(here / name);
    }
    for (const char* name : {"mine/file", "mine_too/file", "others/file"}) {
      std::ofstream(here / name) << "text";
    }
  }

  const TemporaryFolder owner{"inside_folder_test"};
  const fs::path here = fs::canonical(owner.path());
  const fs::path mine = here / "mine";
};

TEST_F(InsideFolderTest, TheFolderItselfAndAllBelowItAre) {
  for (const char* name : {"mine", "mine/", "mine/.", "mine/file", "mine/sub", "mine/sub/file", "mine/no/such/file"}) {
    EXPECT_TRUE(isInside(here / name, mine)) << name;
    EXPECT_TRUE(isInside(here / name, here / "mine/")) << name;
    EXPECT_TRUE(isInside(here / name, "/")) << name;
  }
  for (const char* name : {"", "others", "others/file", "no/such/file"}) {
    EXPECT_FALSE(isInside(here / name, mine)) << name;
  }
}

TEST_F(InsideFolderTest, ANameThatBeginsAlikeIsAnother) {
  EXPECT_FALSE(isInside(here / "mine_too", mine));
  EXPECT_FALSE(isInside(here / "mine_too/file", mine));
  EXPECT_FALSE(isInside(mine, here / "mine_too"));
}

TEST_F(InsideFolderTest, DotsAreFollowed) {
  EXPECT_FALSE(isInside(mine / "../others/file", mine));
  EXPECT_FALSE(isInside(mine / "no/such/../../../others/file", mine));
  EXPECT_TRUE(isInside(here / "others/../mine/./file", mine));
  EXPECT_TRUE(isInside(mine / "file", here / "others/../mine"));
}

TEST_F(InsideFolderTest, LinksAreFollowed) {
  fs::create_symlink(here / "others", mine / "out");
  fs::create_symlink(here / "others/file", mine / "file_out");
  fs::create_symlink(mine, here / "others/in");
  EXPECT_FALSE(isInside(mine / "out", mine));
  EXPECT_FALSE(isInside(mine / "out/file", mine));
  EXPECT_FALSE(isInside(mine / "out/no/such/file", mine));
  EXPECT_FALSE(isInside(mine / "file_out", mine));
  EXPECT_TRUE(isInside(here / "others/in/file", mine));
  EXPECT_TRUE(isInside(mine / "file", here / "others/in"));
  EXPECT_FALSE(isInside(mine / "out/..", mine)) << "the folder in which the link's target is";
}

TEST_F(InsideFolderTest, WhereTheSystemDoesNotTellNothingIs) {
  fs::create_symlink(mine / "round", mine / "about");
  fs::create_symlink(mine / "about", mine / "round");
  EXPECT_EQ(realPath(mine / "round/file"), "");
  EXPECT_FALSE(isInside(mine / "round/file", mine));
  EXPECT_FALSE(isInside(mine / "file", mine / "round"));
  EXPECT_FALSE(isInside(mine / "round", mine / "round"));
}

TEST_F(InsideFolderTest, NamesBeginInTheCurrentFolder) {
  const fs::path before = fs::current_path();
  fs::current_path(mine);
  EXPECT_EQ(realPath(""), mine);
  EXPECT_EQ(realPath("."), mine);
  EXPECT_EQ(realPath("no/such/"), mine / "no/such");
  EXPECT_TRUE(isInside("", mine));
  EXPECT_TRUE(isInside("file", ""));
  EXPECT_TRUE(isInside("no/such/file", "no/such/"));
  EXPECT_FALSE(isInside("../others/file", ""));
  fs::current_path(before);
}

}  // namespace
}  // namespace swarmanoid
