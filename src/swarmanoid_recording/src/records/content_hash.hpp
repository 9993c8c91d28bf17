/// Hashes of files in records, and their text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace swarmanoid::records {

/// Returns XXH3 of the bytes.
std::uint64_t contentHash(const std::string& content);

/// Reads a hash, including state hashes, that hashText has written. @return nothing unless the text is 16 hexadecimal
/// digits
std::optional<std::uint64_t> parseHash(const std::string& text);

}  // namespace swarmanoid::records
