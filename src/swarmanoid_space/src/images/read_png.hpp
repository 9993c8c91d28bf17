/// Images from PNG files, of 2 to 4096 pixels along each side.
///
/// Errors  a std::runtime_error says what the file is that it should not be, such as "is no PNG image".
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
  std::vector<char> is_opaque;  ///< likewise; 0: less than half opaque, so there is no colour
};

/// Reads an image of any kind: coloured, grey, of a palette, partly transparent. Of 16 bits the upper 8 are kept; gamma
/// and colour profiles do not count.
ColorImage readColorPng(const std::string& file);

}  // namespace swarmanoid
