/// Results of a run as named values.
#pragma once

#include <map>
#include <string>
#include <variant>

namespace swarmanoid {

/// Named results of a run.
using Metrics = std::map<std::string, std::variant<bool, double, std::string>>;

/// A number that is kept through a run: its last value is a result, and tables contain all its values.
struct Metric {
  std::string name;  ///< "<id of the rule>.<name>", as in summaries and tables
  std::string unit;
  std::string description;  ///< one sentence
  double value = 0.0;
};

}  // namespace swarmanoid
