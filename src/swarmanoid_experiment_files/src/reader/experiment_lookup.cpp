#include "swarmanoid_experiment_files/experiment_lookup.hpp"

#include <algorithm>
#include <filesystem>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/contains.hpp"
#include "swarmanoid_interface/plugin_library.hpp"

namespace swarmanoid {

namespace fs = std::filesystem;

std::vector<std::string> installedExperiments() {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const std::string& folder : shareFolders()) {
    for (const auto& entry : fs::directory_iterator(fs::path(folder) / "swarmanoid_experiments/experiments", ignored)) {
      const std::string name = entry.path().stem().string();
      if (entry.path().extension() == ".xml" && !contains(names, name)) {
        names.push_back(name);
      }
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string findExperiment(const std::string& file_or_name) {
  std::error_code ignored;
  if (fs::is_regular_file(file_or_name, ignored)) {
    return file_or_name;
  }
  std::string installed = findShared("swarmanoid_experiments", "experiments/" + file_or_name + ".xml");
  if (!installed.empty()) {
    return installed;
  }
  const std::vector<std::string> names = installedExperiments();
  throw ConfigError({file_or_name, 0},
                    "found neither such a file nor an installed experiment of that name; installed: " +
                        joinNames(names) + didYouMean(file_or_name, names));
}

}  // namespace swarmanoid
