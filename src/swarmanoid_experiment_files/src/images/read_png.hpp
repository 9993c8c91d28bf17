/// Reads images from PNG files, of 2 to 4096 pixels along each side.
///
/// Errors  std::runtime_error with the reason, such as "is no PNG image".
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "swarmanoid_interface/color.hpp"

namespace swarmanoid {

struct GreyImage {
  int columns = 0;
  int rows = 0;
  int white = 0;                      ///< the value of white; black is 0
  std::vector<std::uint16_t> values;  ///< row after row from the top
};

/// Reads an image of one channel of 8 or 16 bits.
GreyImage readGreyPng(const std::string& file);

struct ColorImage {
  int columns = 0;
  int rows = 0;
  std::vector<Color> colors;    ///< row after row from the top
  std::vector<char> is_opaque;  ///< row after row from the top; 0: less than half opaque, without a colour
};

/// Reads an image of any kind: coloured, grey, with a palette, partly transparent. 16-bit channels are reduced to their
/// upper 8 bits; gamma and colour profiles are ignored.
ColorImage readColorPng(const std::string& file);

}  // namespace swarmanoid
