// Every bad experiment file is refused with exactly the message that stands beside it.
#include <fnmatch.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "swarmanoid_space/simulation.hpp"

namespace swarmanoid {
namespace {

struct BadCase {
  std::string name;
  std::string text;
  std::string message;
};

void PrintTo(const BadCase& bad, std::ostream* out) { *out << bad.name; }

std::string read(const std::string& name) {
  std::ifstream file(std::string(TEST_DATA) + "/" + name);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

/// The lines up to `end`, joined.
std::string block(std::istream& lines, const std::string& end) {
  std::string line;
  std::string text;
  bool is_first = true;
  while (std::getline(lines, line) && line != end) {
    text += (is_first ? "" : "\n") + line;
    is_first = false;
  }
  return text;
}

std::vector<BadCase> badCases() {
  std::vector<BadCase> cases;
  std::istringstream lines(read("bad_experiments.txt"));
  const std::string good = read("good.xml");
  std::string line;
  while (std::getline(lines, line)) {
    if (line.rfind("case ", 0) == 0) {
      cases.push_back({line.substr(5), good, ""});
    } else if (line == "<<<") {
      const std::string from = block(lines, "===");
      replaceAll(cases.back().text, from, block(lines, ">>>"));
    } else if (line.rfind("expect ", 0) == 0) {
      cases.back().message = line.substr(7);
    }
  }
  return cases;
}

void build(const std::string& text, const std::string& name) {
  loadBuiltInPlugins();
  const Simulation simulation(parseExperiment(text, name));
}

class BadExperimentTest : public testing::TestWithParam<BadCase> {};

TEST_P(BadExperimentTest, IsRefusedWithItsMessage) {
  ASSERT_NE(GetParam().text, read("good.xml")) << "the case changes nothing";
  ASSERT_FALSE(GetParam().message.empty());
  try {
    build(GetParam().text, "bad.xml");
    FAIL() << "was accepted";
  } catch (const ConfigError& error) {
    const std::string& expected = GetParam().message;
    if (expected.find('*') == std::string::npos) {
      EXPECT_EQ(error.what(), expected);
    } else {
      EXPECT_EQ(fnmatch(expected.c_str(), error.what(), 0), 0) << error.what();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, BadExperimentTest, testing::ValuesIn(badCases()),
                         [](const auto& bad) { return bad.param.name; });

TEST(BadExperimentsTest, ThereAreManyAndTheGoodOneIsGood) {
  EXPECT_GE(badCases().size(), 60U);
  EXPECT_NO_THROW(build(read("good.xml"), "good.xml"));
}

}  // namespace
}  // namespace swarmanoid
