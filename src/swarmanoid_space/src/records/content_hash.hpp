/// Hashes of files in records, and reading them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace swarmanoid::records {

/// XXH3 of the bytes.
std::uint64_t contentHash(const std::string& content);

/// Of what hashText has written; those of state hashes too. @return nothing if these are not 16 digits
std::optional<std::uint64_t> parseHash(const std::string& text);

}  // namespace swarmanoid::records
