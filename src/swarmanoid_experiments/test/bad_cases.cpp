#include "bad_cases.hpp"

#include <fstream>
#include <sstream>

namespace swarmanoid::test {
namespace {

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

/// Joins the lines up to `end`.
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

}  // namespace

void PrintTo(const BadCase& bad, std::ostream* out) { *out << bad.name; }

std::string readTestData(const std::string& name) {
  std::ifstream file(std::string(TEST_DATA) + "/" + name);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<BadCase> badCases() {
  std::vector<BadCase> cases;
  std::istringstream lines(readTestData("bad_experiments.txt"));
  const std::string good = readTestData("good.xml");
  std::string line;
  while (std::getline(lines, line)) {
    if (line.rfind("case ", 0) == 0) {
      cases.push_back({line.substr(5), good, "", false});
    } else if (line == "<<<") {
      const std::string from = block(lines, "===");
      replaceAll(cases.back().text, from, block(lines, ">>>"));
      replaceAll(cases.back().text, "{data}", TEST_DATA);
    } else if (line.rfind("expect ", 0) == 0) {
      cases.back().message = line.substr(7);
    } else if (line == "schema refuses") {
      cases.back().refused_by_schema = true;
    }
  }
  return cases;
}

}  // namespace swarmanoid::test
