/// Whether a path is inside a folder, by what both mean and not by how they are written: links and dots are followed
/// first, as far as there are such files. It holds for the moment in which it is asked.
#pragma once

#include <filesystem>

namespace swarmanoid {

/// The path as the system knows it: absolute, without links, dots, and a / at the end.
/// @param path "": the current folder
/// @return "" if the system does not say, as for links that lead to each other
std::filesystem::path realPath(const std::filesystem::path& path);

/// The folder itself is inside too; where the system does not say nothing is.
bool isInside(const std::filesystem::path& path, const std::filesystem::path& folder);

}  // namespace swarmanoid
