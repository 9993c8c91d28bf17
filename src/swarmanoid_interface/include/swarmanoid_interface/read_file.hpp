/// Reads input files of users as a whole.
#pragma once

#include <cstddef>
#include <string>

namespace swarmanoid {

/// Returns the bytes of a file; it may be a pipe. Not more than `most` are read, since devices such as /dev/zero have
/// no end.
/// @throws ConfigError if it cannot be read, as a folder cannot, or has more than `most` bytes
std::string readFile(const std::string& file, std::size_t most);

}  // namespace swarmanoid
