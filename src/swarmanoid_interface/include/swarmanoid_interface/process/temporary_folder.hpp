/// A folder for temporary files.
#pragma once

#include <filesystem>
#include <string>

namespace swarmanoid {

/// A new folder that only this user can access, where the system keeps temporary files (TMPDIR, else /tmp). The
/// destructor removes it with all its contents.
class TemporaryFolder {
 public:
  /// @param purpose becomes part of the folder's name, so that its origin can be recognised
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
