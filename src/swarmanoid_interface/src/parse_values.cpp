// Strict readers of single values, and the texts of their messages.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <sstream>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_interface/readable_number.hpp"

namespace swarmanoid {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) {
    return "";
  }
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// Returns a readable form of the text; of a long text only its beginning.
std::string readable(const std::string& text) {
  constexpr std::size_t kLongest = 200;
  return text.size() <= kLongest ? text : text.substr(0, kLongest) + "...";
}

[[noreturn]] void refuse(const std::string& what, const std::string& found, const std::string& allowed,
                         const SourceLocation& location) {
  throw ConfigError(location, what + ": found '" + readable(found) + "', allowed: " + allowed);
}

template <class Value>
std::optional<Value> readWhole(const std::string& text) {
  Value value{};
  const char* begin = text.data();
  const char* end = begin + text.size();
  if (end - begin > 1 && begin[0] == '+' && begin[1] != '-') {
    ++begin;  // std::from_chars does not accept a plus sign
  }
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || stop != end || begin == end) {
    return std::nullopt;
  }
  return value;
}

std::string shortNumber(double value) {
  constexpr int kAllDigits = 15;
  return swarmanoid::shortNumber(value, kAllDigits);
}

int editDistance(std::string_view a, std::string_view b) {
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    int diagonal = row[0];
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int substitution = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitution});
    }
  }
  return row.back();
}

}  // namespace

std::string SourceLocation::toString() const {
  return line > 0 && !file.empty() ? file + ":" + std::to_string(line) : file;
}

ConfigError::ConfigError(const SourceLocation& location, const std::string& message)
    : std::runtime_error(location.file.empty() ? message : location.toString() + ": " + message), location_(location) {}

std::string Range::toString() const {
  const bool has_minimum = std::isfinite(minimum);
  const bool has_maximum = std::isfinite(maximum);
  std::string text = "any number";
  if (has_minimum && has_maximum) {
    text = "from " + shortNumber(minimum) + " to " + shortNumber(maximum);
  } else if (has_minimum) {
    text = "at least " + shortNumber(minimum);
  } else if (has_maximum) {
    text = "at most " + shortNumber(maximum);
  }
  return smallest_magnitude > 0.0 ? text + " (0, or at least " + shortNumber(smallest_magnitude) + ")" : text;
}

std::string numberText(double value) {
  std::array<char, 32> text{};  // the longest number has 24 letters
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

std::string readableNumber(double value) {
  constexpr double kThousandths = 1e3;
  constexpr double kLargest = 1e9;  // beyond, a double has hardly a thousandth
  const bool is_rounded = std::abs(value) < kLargest;
  return numberText(is_rounded ? std::round(value * kThousandths) / kThousandths + 0.0 : value);  // not -0
}

double parseNumber(const std::string& text, const std::string& what, const SourceLocation& location, Range range) {
  const std::string found = trimmed(text);
  const auto value = readWhole<double>(found);
  if (!value || !std::isfinite(*value) || !range.contains(*value)) {
    refuse(what, found, "a number" + (range.toString() == "any number" ? "" : " " + range.toString()), location);
  }
  return *value;
}

std::int64_t parseInteger(const std::string& text, const std::string& what, const SourceLocation& location,
                          Range range) {
  const std::string found = trimmed(text);
  const auto value = readWhole<std::int64_t>(found);
  if (!value || !range.contains(static_cast<double>(*value))) {
    refuse(what, found, "a whole number" + (range.toString() == "any number" ? "" : " " + range.toString()), location);
  }
  return *value;
}

bool parseBoolean(const std::string& text, const std::string& what, const SourceLocation& location) {
  const std::string found = trimmed(text);
  if (found != "true" && found != "false") {
    refuse(what, found, "true, false", location);
  }
  return found == "true";
}

Color parseColorOrThrow(const std::string& text, const std::string& what, const SourceLocation& location) {
  const auto color = parseColor(text);
  if (!color) {
    throw ConfigError(location, what + ": found '" + readable(trimmed(text)) +
                                    "', allowed: " + joinNames(colorNames()) + ", or three numbers from 0 to 255" +
                                    didYouMean(trimmed(text), colorNames()));
  }
  return *color;
}

std::vector<double> parseNumbers(const std::string& text, std::size_t count, const std::string& what,
                                 const SourceLocation& location, Range range) {
  std::vector<double> values;
  std::istringstream parts(text);
  std::string part;
  while (std::getline(parts, part, ',')) {
    const auto value = readWhole<double>(trimmed(part));
    if (!value || !std::isfinite(*value) || !range.contains(*value)) {
      break;
    }
    values.push_back(*value);
  }
  const auto commas = static_cast<std::size_t>(std::count(text.begin(), text.end(), ','));
  if (values.size() != count || commas + 1 != count) {
    const std::string bounds = range.toString() == "any number" ? "" : ", each " + range.toString();
    refuse(what, trimmed(text), std::to_string(count) + " numbers separated by commas" + bounds, location);
  }
  return values;
}

std::optional<std::string> nearestName(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t kLongestName = 200;
  if (word.size() > kLongestName) {
    return std::nullopt;
  }
  std::optional<std::string> best;
  int best_distance = std::max(2, static_cast<int>(word.size()) / 3) + 1;
  for (const std::string& candidate : candidates) {
    const int distance = editDistance(word, candidate);
    // a name that shares no letter with the word does not help
    if (distance < best_distance && distance < static_cast<int>(word.size())) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string didYouMean(std::string_view word, const std::vector<std::string>& candidates) {
  const auto name = nearestName(word, candidates);
  return name ? "; did you mean '" + *name + "'?" : "";
}

std::string joinNames(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 200;  // keeps a message with many names readable
  std::string result;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i) {
    result += (result.empty() ? "" : ", ") + names[i];
  }
  return names.size() <= kMost ? result : result + " and " + std::to_string(names.size() - kMost) + " more";
}

std::string unknownName(const std::string& what, const std::string& name, const std::vector<std::string>& allowed) {
  return "found " + what + " '" + name + "', allowed: " + (allowed.empty() ? "none" : joinNames(allowed)) +
         didYouMean(name, allowed);
}

}  // namespace swarmanoid
