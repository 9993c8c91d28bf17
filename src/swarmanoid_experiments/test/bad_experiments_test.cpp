// Every bad experiment file is rejected with exactly the message given with it.
#include <fnmatch.h>
#include <gtest/gtest.h>

#include "bad_cases.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {
namespace {

using test::BadCase;
using test::badCases;
using test::readTestData;

void build(const std::string& text, const std::string& name) {
  loadBuiltInPlugins();
  const Simulation simulation(parseExperiment(text, name));
}

class BadExperimentTest : public testing::TestWithParam<BadCase> {};

TEST_P(BadExperimentTest, IsRefusedWithItsMessage) {
  ASSERT_NE(GetParam().text, readTestData("good.xml")) << "the case changes nothing";
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
  EXPECT_NO_THROW(build(readTestData("good.xml"), "good.xml"));
}

}  // namespace
}  // namespace swarmanoid
