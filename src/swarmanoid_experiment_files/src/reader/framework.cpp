// <framework>: settings of the whole run.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "reader.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid::experiment {
namespace {

/// Splits "a:b", with line breaks (and the backslashes that the thesis puts before them) anywhere.
std::vector<std::string> splitPath(const std::string& text) {
  std::vector<std::string> folders{""};
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_break = text[i] == '\\' && (i + 1 == text.size() || text[i + 1] == '\n' || text[i + 1] == '\r');
    if (text[i] == ':') {
      folders.emplace_back();
    } else if (!is_break && std::string(" \t\r\n").find(text[i]) == std::string::npos) {
      folders.back() += text[i];
    }
  }
  folders.erase(std::remove(folders.begin(), folders.end(), ""), folders.end());
  return folders;
}

}  // namespace

void readFramework(const XmlElement& section, Reader& reader) {
  section.allowAttributes(attributesOf("framework"));
  const Configuration values = readParameters(section, frameworkParameters());
  FrameworkDescription& framework = reader.experiment.framework;
  constexpr double kNanosecondsPerMillisecond = 1e6;
  framework.clocktick = Duration(std::llround(values.number("clocktick") * kNanosecondsPerMillisecond));
  framework.max_clock = static_cast<std::uint64_t>(values.integer("maxclock"));
  framework.seed = static_cast<std::uint64_t>(values.integer("random_seed"));
  framework.threads = static_cast<int>(values.integer("threads"));
  framework.location = section.child("maxclock")->location();
  framework.real_time_factor = values.number("real_time_factor");
  if (!limits::isRealTimeFactor(framework.real_time_factor)) {
    section.child("real_time_factor")
        ->refuse("real_time_factor: found '" + values.text("real_time_factor") +
                 "', allowed: " + limits::kRealTimeFactors);
  }
  framework.controller_path = splitPath(values.text("controller_path"));
  for (const std::string& folder : framework.controller_path) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder, ignored)) {
      reader.warnings.push_back(section.child("controller_path")->location().toString() + ": controller_path: '" +
                                folder + "' is not a folder");
    }
  }
}

}  // namespace swarmanoid::experiment
