#include "swarmanoid_interface/read_file.hpp"

#include <filesystem>
#include <fstream>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {

std::string readFile(const std::string& file, std::size_t most) {
  std::error_code ignored;
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file, ignored)) {
    throw ConfigError({file, 0}, "cannot be read");
  }
  std::string text;
  for (std::vector<char> part(std::size_t{1} << 16U); in;) {
    in.read(part.data(), static_cast<std::streamsize>(part.size()));
    text.append(part.data(), static_cast<std::size_t>(in.gcount()));
    if (text.size() > most) {
      throw ConfigError(
          {file, 0}, "found a file without an end in sight, allowed: at most " + std::to_string(most) + " characters");
    }
  }
  if (in.bad()) {
    throw ConfigError({file, 0}, "cannot be read to its end");
  }
  return text;
}

}  // namespace swarmanoid
