#include "swarmanoid_recording/output/inside_folder.hpp"

#include <algorithm>

namespace swarmanoid {

namespace fs = std::filesystem;

fs::path realPath(const fs::path& path) {
  std::error_code problem;
  const fs::path full = fs::absolute(path.empty() ? "." : path, problem);
  const fs::path real = fs::weakly_canonical(full, problem);
  return real.has_filename() ? real : real.parent_path();  // a missing folder keeps its trailing /
}

bool isInside(const fs::path& path, const fs::path& folder) {
  const fs::path inner = realPath(path);
  const fs::path outer = realPath(folder);
  return !outer.empty() && std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

}  // namespace swarmanoid
