/// The bad experiment files of data/bad_experiments.txt, and the good file that they are derived from.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace swarmanoid::test {

struct BadCase {
  std::string name;
  std::string text;
  std::string message;             ///< a * matches any text
  bool refused_by_schema = false;  ///< an editor with the schema detects the mistake too
};

void PrintTo(const BadCase& bad, std::ostream* out);

std::vector<BadCase> badCases();

/// A file of test/data.
std::string readTestData(const std::string& name);

}  // namespace swarmanoid::test
