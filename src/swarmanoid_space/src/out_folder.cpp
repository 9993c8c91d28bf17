#include "swarmanoid_space/out_folder.hpp"

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {

namespace fs = std::filesystem;

OutFolder::OutFolder(const std::string& folder, const std::string& option) {
  if (folder.empty()) {
    return;
  }
  std::error_code problem;
  fs::path missing = fs::absolute(folder, problem).lexically_normal();
  while (!problem && !missing.empty() && !fs::exists(missing, problem) && missing != missing.parent_path()) {
    made_.push_back(missing);
    missing = missing.parent_path();
  }
  problem.clear();
  fs::create_directories(folder, problem);
  if (!problem && !fs::is_directory(folder)) {
    problem = std::make_error_code(std::errc::not_a_directory);
  }
  if (problem) {
    throw ConfigError({option, 0}, "cannot make the folder '" + folder + "': " + problem.message());
  }
}

OutFolder::~OutFolder() {
  for (const fs::path& folder : made_) {
    std::error_code ignored;
    fs::remove(folder, ignored);
  }
}

}  // namespace swarmanoid
