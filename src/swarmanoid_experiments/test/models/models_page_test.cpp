// Each formula of docs/reference/models.md has a test of its name in this program, and each test a formula there.
#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <set>
#include <string>

namespace swarmanoid::test {
namespace {

/// "Blob bearing and distance" as BlobBearingAndDistance.
std::string nameOf(const std::string& heading) {
  std::string name;
  bool is_start = true;
  for (const char c : heading) {
    if (c != ' ') {
      name += is_start ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    }
    is_start = c == ' ';
  }
  return name;
}

TEST(ModelsPageHeadings, AreTheNamesOfTheTests) {
  std::set<std::string> headings;
  std::ifstream page(PAGE);
  ASSERT_TRUE(page) << PAGE;
  for (std::string line; std::getline(page, line);) {
    if (line.rfind("### ", 0) == 0) {
      EXPECT_TRUE(headings.insert(nameOf(line.substr(4))).second) << line << ": twice";
    }
  }
  std::set<std::string> tests;
  const testing::UnitTest& program = *testing::UnitTest::GetInstance();
  for (int i = 0; i < program.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *program.GetTestSuite(i);
    for (int k = 0; k < suite.total_test_count() && std::string(suite.name()) == "ModelsPageTest"; ++k) {
      tests.insert(suite.GetTestInfo(k)->name());
    }
  }
  EXPECT_GE(tests.size(), 15U);
  EXPECT_EQ(headings, tests);
}

}  // namespace
}  // namespace swarmanoid::test
