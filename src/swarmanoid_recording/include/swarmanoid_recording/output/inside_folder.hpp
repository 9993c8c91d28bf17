/// Checks whether a path is inside a folder, by their meaning and not their text: links and dots are resolved first, as
/// far as the files exist. The result holds only for the moment of the call.
#pragma once

#include <filesystem>

namespace swarmanoid {

/// Returns the canonical path: absolute, without links, dots or a trailing /.
/// @param path "": the current folder
/// @return "" if the system cannot resolve it, such as for links that lead to each other
std::filesystem::path realPath(const std::filesystem::path& path);

/// Returns whether the path is inside the folder or is the folder itself; false if one of them cannot be resolved.
bool isInside(const std::filesystem::path& path, const std::filesystem::path& folder);

}  // namespace swarmanoid
