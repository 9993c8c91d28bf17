/// The folder that files of a run go to: made if it is not there, and taken away again unless the run begins.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace swarmanoid {

class OutFolder {
 public:
  /// @param folder may be empty: then there is none
  /// @param option who asked for it, for messages: "--out", "~out"
  /// @throws ConfigError if it cannot be made
  OutFolder(const std::string& folder, const std::string& option);
  /// Folders that were made, and are still empty, go.
  ~OutFolder();
  OutFolder(const OutFolder&) = delete;
  OutFolder& operator=(const OutFolder&) = delete;

  /// From here on the folder stays.
  void keep() { made_.clear(); }

 private:
  std::vector<std::filesystem::path> made_;  // the innermost first
};

}  // namespace swarmanoid
