// Finding robots through the package.xml of packages, in install spaces and in the sources of devel spaces.
#include "../src/robots/robot_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "swarmanoid_interface/process/temporary_folder.hpp"

namespace swarmanoid {
namespace {

namespace fs = std::filesystem;

class RobotFilesTest : public testing::Test {
 protected:
  void write(const std::string& path, const std::string& text = "") {
    fs::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
  }

  static std::string manifest(const std::string& name, const std::string& element) {
    return "<?xml version=\"1.0\"?>\n<package format=\"2\">\n<name>" + name + "</name>\n<export>\n" + element +
           "\n</export></package>";
  }

  static std::string robotsIn(const std::string& folder) { return "<swarmanoid robots=\"" + folder + "\"/>"; }

  RobotFiles find(const std::vector<std::string>& prefixes) {
    std::vector<std::string> folders;
    for (const std::string& prefix : prefixes) {
      folders.push_back((root_ / prefix / "share").string());
    }
    return findRobotFiles(folders);
  }

  const TemporaryFolder owner_{"robot_files_test"};
  const fs::path root_ = owner_.path();
};

TEST_F(RobotFilesTest, FindsRobotsOfInstalledPackages) {
  write("installed/share/ants/package.xml", manifest("ants", robotsIn("${prefix}/robots")));
  write("installed/share/ants/robots/worker.urdf");
  write("installed/share/ants/robots/queen.urdf");
  write("installed/share/ants/robots/notes.txt");
  write("installed/share/others/package.xml", manifest("others", "<nodelet plugin=\"x\"/>"));
  write("installed/share/others/urdf/stranger.urdf");
  const RobotFiles found = find({"installed"});
  EXPECT_TRUE(found.problems.empty());
  ASSERT_EQ(found.robots.size(), 2U);
  EXPECT_EQ(found.robots[0].type, "queen");
  EXPECT_EQ(found.robots[0].package, "ants");
  EXPECT_EQ(found.robots[0].file, (root_ / "installed/share/ants/robots/queen.urdf").string());
  EXPECT_EQ(found.robots[1].type, "worker");
}

TEST_F(RobotFilesTest, LooksIntoTheSourcesOfADevelSpace) {
  write("devel/.catkin", (root_ / "source").string());
  write("source/group/ants/package.xml", manifest("ants", robotsIn("${prefix}/urdf")));
  write("source/group/ants/urdf/worker.urdf");
  write("source/group/ants/inner/package.xml", manifest("inner", robotsIn("${prefix}")));  // part of ants
  write("source/group/ants/inner/larva.urdf");
  write("source/unused/CATKIN_IGNORE");
  write("source/unused/bees/package.xml", manifest("bees", robotsIn("${prefix}")));
  write("source/unused/bees/drone.urdf");
  const RobotFiles found = find({"devel"});
  ASSERT_EQ(found.robots.size(), 1U);
  EXPECT_EQ(found.robots[0].file, (root_ / "source/group/ants/urdf/worker.urdf").string());
}

TEST_F(RobotFilesTest, TakesAPackageFromTheFirstPrefixThatHasIt) {
  for (const std::string prefix : {"first", "second"}) {
    write(prefix + "/share/ants/package.xml", manifest("ants", robotsIn("${prefix}")));
    write(prefix + "/share/ants/worker.urdf");
  }
  write("second/share/bees/package.xml", manifest("bees", robotsIn("${prefix}")));
  write("second/share/bees/worker.urdf");
  const RobotFiles found = find({"first", "second"});
  ASSERT_EQ(found.robots.size(), 2U) << "two packages have a worker: both are found";
  EXPECT_EQ(found.robots[0].file, (root_ / "first/share/ants/worker.urdf").string());
  EXPECT_EQ(found.robots[1].package, "bees");
}

TEST_F(RobotFilesTest, KeepsWhatIsWrongWithPackages) {
  write("installed/share/ants/package.xml", manifest("ants", robotsIn("${prefix}/robots")));
  write("installed/share/bees/package.xml", manifest("bees", "<swarmanoid robot=\"${prefix}\"/>"));
  write("installed/share/wasps/package.xml", "<package>\n<swarmanoid");
  const RobotFiles found = find({"installed"});
  EXPECT_TRUE(found.robots.empty());
  const std::string share = (root_ / "installed/share").string();
  ASSERT_EQ(found.problems.size(), 3U);
  EXPECT_EQ(found.problems[0], share +
                                   "/ants/package.xml:5: robots: found '${prefix}/robots', allowed: a folder, such "
                                   "as ${prefix}/urdf");
  EXPECT_EQ(found.problems[1], share +
                                   "/bees/package.xml:5: <swarmanoid> needs the attribute robots=\"${prefix}/...\" or "
                                   "realism=\"${prefix}/...\"");
  EXPECT_EQ(found.problems[2].rfind(share + "/wasps/package.xml:2: found no well-formed XML", 0), 0U)
      << found.problems[2];
}

}  // namespace
}  // namespace swarmanoid
