/// Grey images.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace swarmanoid {

struct GreyImage {
  int columns = 0;
  int rows = 0;
  int white = 0;                      ///< the value of white; black is 0
  std::vector<std::uint16_t> values;  ///< row after row from the top
};

/// Reads a PNG image of one channel of 8 or 16 bits, with 2 to 4096 pixels along each side.
/// @throws std::runtime_error what the file is that it should not be, such as "is no PNG image"
GreyImage readGreyPng(const std::string& file);

}  // namespace swarmanoid
