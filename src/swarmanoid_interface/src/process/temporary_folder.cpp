#include "swarmanoid_interface/process/temporary_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace swarmanoid {

TemporaryFolder::TemporaryFolder(const std::string& purpose) {
  std::string name = std::filesystem::temp_directory_path() / ("swarmanoid_" + purpose + "_XXXXXX");
  if (mkdtemp(name.data()) == nullptr) {
    throw std::runtime_error("cannot make the folder " + name + ": " + std::strerror(errno));
  }
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace swarmanoid
