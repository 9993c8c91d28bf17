/// The folder of --out: made if it is not there, and taken away again unless the run begins.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace swarmanoid::program {

class OutFolder {
 public:
  /// @param folder may be empty: then there is none
  /// @throws ConfigError if it cannot be made
  explicit OutFolder(const std::string& folder);
  /// Folders that were made, and are still empty, go.
  ~OutFolder();
  OutFolder(const OutFolder&) = delete;
  OutFolder& operator=(const OutFolder&) = delete;

  /// From here on the folder stays.
  void keep() { made_.clear(); }

 private:
  std::vector<std::filesystem::path> made_;  // the innermost first
};

}  // namespace swarmanoid::program
