// Every rule of the suite has a section of a page that contains each of its values and metrics with the description in
// the code, and there are no other sections.
#include <gtest/gtest.h>

#include <filesystem>

#include "page_sections.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_space/rule.hpp"

namespace swarmanoid {
namespace {

namespace fs = std::filesystem;

fs::path pages() { return fs::path(TEST_DATA) / "../../../../docs/reference/rules"; }

std::vector<const Registry::Entry*> rules() {
  loadBuiltInPlugins();
  return Registry::instance().all(PluginKind::kRule);
}

/// A value that is valid for any parameter of that type without a default.
std::string someValue(const Parameter& parameter) {
  using Type = Parameter::Type;
  switch (parameter.type) {
    case Type::kVector2:
      return "1, 1";
    case Type::kVector3:
    case Type::kAngles3:
      return "1, 1, 1";
    case Type::kBoolean:
      return "true";
    case Type::kColor:
      return "red";
    case Type::kChoice:
      return parameter.choices.front();
    case Type::kText:
      return "something";
    default:
      return numberText(parameter.range.minimum);
  }
}

std::shared_ptr<Rule> configured(const Registry::Entry& entry) {
  Configuration values(entry.description.label, "", {});
  for (const Parameter& parameter : entry.description.parameters) {
    values.set(parameter.name, parameter.value ? *parameter.value : someValue(parameter));
  }
  const auto rule = makePlugin<Rule>(entry);
  rule->setId("r");
  rule->configure(values);
  return rule;
}

/// The table row of a section that starts with this name; "" if there is none.
std::string rowOf(const std::string& section, const std::string& name) {
  const std::string start = "\n| `" + name + "` |";
  const std::size_t row = section.find(start);
  return row == std::string::npos ? "" : section.substr(row + 1, section.find('\n', row + 1) - row - 1);
}

TEST(RulePagesTest, NameEveryValueAndEveryMetric) {
  ASSERT_FALSE(rules().empty());
  auto sections = test::pageSections(pages());
  for (const Registry::Entry* entry : rules()) {
    const std::string& label = entry->description.label;
    const std::string& section = sections[label];
    EXPECT_EQ(section.rfind("\n" + entry->description.summary, 0), 0U) << label;
    for (const Parameter& parameter : entry->description.parameters) {
      const std::string row = rowOf(section, parameter.name);
      EXPECT_NE(row.find("| " + parameter.value.value_or("required") + " |"), std::string::npos) << row;
      EXPECT_NE(row.find("| " + parameter.description + " |"), std::string::npos)
          << label << ": " << parameter.name << ": " << row;
    }
    const auto rule = configured(*entry);
    for (const Metric& metric : rule->metrics()) {
      const std::string row = rowOf(section, metric.name.substr(std::string("r.").size()));
      EXPECT_NE(row.find("| " + metric.description + " |"), std::string::npos)
          << label << ": " << metric.name << ": " << row;
      EXPECT_NE(row.find(metric.unit.empty() ? "| |" : "| " + metric.unit + " |"), std::string::npos) << row;
    }
  }
}

TEST(RulePagesTest, AreOfRulesThatThereAre) {
  rules();
  for (const auto& section : test::pageSections(pages())) {
    EXPECT_NE(Registry::instance().find(PluginKind::kRule, section.first), nullptr) << section.first;
  }
}

/// The schema interprets a tag with the name of a rule as that rule, even inside an unknown element.
TEST(RulePagesTest, NoRuleIsCalledAsAParameterOfAPlugin) {
  rules();
  for (const PluginKind kind : kPluginKinds) {
    for (const Registry::Entry* entry : Registry::instance().all(kind)) {
      for (const Parameter& parameter : entry->description.parameters) {
        EXPECT_EQ(Registry::instance().find(PluginKind::kRule, parameter.name), nullptr)
            << entry->description.label << ": " << parameter.name;
      }
    }
  }
}

}  // namespace
}  // namespace swarmanoid
