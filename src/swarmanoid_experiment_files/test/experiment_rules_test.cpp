// <rules> in experiment files: contents, refusals with their places, and overrides from the command line.
#include <string>
#include <vector>

#include "experiment_fixture.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"

namespace swarmanoid::test {
namespace {

/// The fixture's experiment with two rules; <rules> is line 36.
class ExperimentRulesTest : public ExperimentTest {
 protected:
  static void SetUpTestSuite() {
    ExperimentTest::SetUpTestSuite();
    using Type = Parameter::Type;
    add(PluginKind::kRule, "recharge", "",
        {parameter("rate", Type::kNumber, "1", {0.0, 9.0}), parameter("where", Type::kText, "")}, {"charge"});
  }

  static std::string withRules(const std::string& rules) {
    std::string text = kFile;
    return text.insert(text.find("  <visualizations>"), "  <rules>\n" + rules + "  </rules>\n");
  }

  const std::string two_rules = withRules(
      "    <recharge id=\"dock\"><rate>2</rate><where>nest</where></recharge>\n"
      "    <charge id=\"pole\"/>\n");
};

TEST_F(ExperimentRulesTest, AreReadInTheirOrderWithDefaults) {
  const Experiment experiment = parseExperiment(two_rules, "some.xml");
  ASSERT_EQ(experiment.rules.size(), 2U);
  const RuleDescription& dock = experiment.rules[0];
  EXPECT_EQ(dock.id, "dock");
  EXPECT_EQ(dock.label, "recharge");
  EXPECT_EQ(dock.library, "");
  EXPECT_EQ(dock.location.line, 37);
  EXPECT_EQ(dock.parameters.number("rate"), 2.0);
  EXPECT_EQ(dock.parameters.text("where"), "nest");
  EXPECT_EQ(experiment.rules[1].id, "pole");
  EXPECT_EQ(experiment.rules[1].label, "recharge") << "never an alias";
  EXPECT_EQ(experiment.rules[1].parameters.number("rate"), 1.0);
  EXPECT_TRUE(parse().rules.empty());
}

TEST_F(ExperimentRulesTest, MistakesAreRefusedWithTheirLine) {
  const auto refused = [](const std::string& rules) { return refusal({}, withRules(rules)); };
  EXPECT_EQ(refused("    <rechange id=\"dock\"/>\n"),
            "some.xml:37: found rule 'rechange', allowed: recharge; did you mean 'recharge'?");
  EXPECT_EQ(refused("    <recharge id=\"dock\">\n      <rat>2</rat></recharge>\n"),
            "some.xml:38: found tag 'rat', allowed: rate, where; did you mean 'rate'? (in <recharge>)");
  EXPECT_EQ(refused("    <recharge id=\"dock\"><rate>10</rate></recharge>\n"),
            "some.xml:37: rate: found '10', allowed: a number from 0 to 9");
  EXPECT_EQ(refused("    <recharge id=\"dock\"/>\n    <recharge id=\"dock\"/>\n"),
            "some.xml:38: the rule id 'dock' is taken already, in some.xml:37");
  EXPECT_EQ(refused("    dock\n").rfind("some.xml:", 0), 0U);
  std::string again = two_rules;
  again.insert(again.find("  <visualizations>"), "  <rules/>\n");
  EXPECT_EQ(refusal({}, again), "some.xml:40: found a second <rules> in <ahss-config>, allowed: one");
}

TEST_F(ExperimentRulesTest, AnIdMayBeThatOfSomethingElse) {
  EXPECT_EQ(refusal({}, withRules("    <recharge id=\"sky\"/><recharge id=\"fb\"/>\n")), "(accepted)");
}

TEST_F(ExperimentRulesTest, OverridesReachTheirParameters) {
  const auto rules = [&](const std::string& path, const std::string& value) {
    return parseExperiment(two_rules, "some.xml", {{path, value}}).rules;
  };
  EXPECT_EQ(rules("rules.dock.rate", "3")[0].parameters.number("rate"), 3.0);
  EXPECT_EQ(rules("rules.dock.rate", "3")[1].parameters.number("rate"), 1.0);
  EXPECT_EQ(rules("rules.pole.rate", "4")[1].parameters.number("rate"), 4.0) << "not in the file";
  EXPECT_EQ(rules("rules.pole.id", "post")[1].id, "post");
  EXPECT_EQ(refusal({{"rules.dock.rate", "much"}}, two_rules),
            "--set rules.dock.rate: rate: found 'much', allowed: a number from 0 to 9");
  EXPECT_EQ(refusal({{"rules.dok.rate", "1"}}, two_rules),
            "--set rules.dok.rate: found no tag or id 'dok', allowed: dock, pole; did you mean 'dock'? (in <rules>)");
}

}  // namespace
}  // namespace swarmanoid::test
