/// A folder for files that nobody needs afterwards.
#pragma once

#include <filesystem>
#include <string>

namespace swarmanoid {

/// A new folder of this user alone where the system keeps such files (TMPDIR, else /tmp). It goes, with all that is in
/// it, when its owner does.
class TemporaryFolder {
 public:
  /// @param purpose becomes part of its name, for whoever finds it
  /// @throws std::runtime_error if it cannot be made
  explicit TemporaryFolder(const std::string& purpose);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace swarmanoid
