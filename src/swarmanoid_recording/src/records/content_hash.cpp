#include "content_hash.hpp"

#include <xxhash.h>

#include <charconv>

namespace swarmanoid::records {
namespace {

constexpr std::size_t kDigits = 16;
constexpr int kBase = 16;

}  // namespace

std::uint64_t contentHash(const std::string& content) { return XXH3_64bits(content.data(), content.size()); }

std::optional<std::uint64_t> parseHash(const std::string& text) {
  std::uint64_t hash = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, hash, kBase);
  return text.size() == kDigits && error == std::errc() && stop == end ? std::optional<std::uint64_t>(hash)
                                                                       : std::nullopt;
}

}  // namespace swarmanoid::records
