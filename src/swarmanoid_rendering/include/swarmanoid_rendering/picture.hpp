/// A picture in memory, and as a PNG file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace swarmanoid {

struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  ///< three bytes per pixel, row by row from the top; height x width x 3

  const std::uint8_t* pixel(int column, int row) const {
    constexpr std::size_t kChannels = 3;
    return &rgb[kChannels *
                (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column))];
  }
};

/// Encodes a picture as PNG. @throws std::runtime_error if libpng fails
std::vector<char> toPng(const Picture& picture);

}  // namespace swarmanoid
