#include "swarmanoid_experiment_files/override_text.hpp"

#include <gtest/gtest.h>

namespace swarmanoid {
namespace {

TEST(OverrideTextTest, AValueEndsWhereTheNextPathBegins) {
  const auto texts = [](const std::string& text) {
    std::vector<std::string> result;
    for (const Override& change : parseOverrides(text, "set")) {
      result.push_back(change.path + "|" + change.value);
    }
    return result;
  };
  using Texts = std::vector<std::string>;
  EXPECT_EQ(Texts(), texts("  "));
  EXPECT_EQ((Texts{"a.b|3", "c.d|"}), texts("a.b=3 c.d="));
  EXPECT_EQ((Texts{"arena.size|1, 2, 2", "a.b|x=y"}), texts(" arena.size=1, 2,\t2  a.b=x=y"));
  for (const std::string bad : {"a.b", "=3"}) {
    try {
      parseOverrides(bad + " c.d=3", "set");
      ADD_FAILURE() << bad;
    } catch (const ConfigError& error) {
      EXPECT_EQ("set: found '" + bad + "', allowed: path=value", std::string(error.what()));
    }
  }
}

}  // namespace
}  // namespace swarmanoid
