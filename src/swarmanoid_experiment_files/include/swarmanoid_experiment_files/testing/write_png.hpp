/// Small images for tests.
#pragma once

#include <png.h>

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace swarmanoid::test {

/// @param values row after row from the top; @param bits 8 or 16
/// @param type PNG_COLOR_TYPE_GRAY; any other takes the values as its channels, pixel after pixel
inline std::string writePng(const std::string& file, int columns, int bits, const std::vector<int>& values,
                            int type = PNG_COLOR_TYPE_GRAY) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  const std::size_t channels = type == PNG_COLOR_TYPE_RGB ? 3 : (type == PNG_COLOR_TYPE_GRAY_ALPHA ? 2 : 1);
  const std::size_t per_row = static_cast<std::size_t>(columns) * channels;
  const std::size_t rows = values.size() / per_row;
  std::FILE* out = std::fopen(file.c_str(), "wb");
  png_init_io(png, out);
  png_set_IHDR(png, info, static_cast<png_uint_32>(columns), static_cast<png_uint_32>(rows), bits, type,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  for (std::size_t row = 0; row < rows; ++row) {
    std::vector<png_byte> bytes;
    for (std::size_t k = 0; k < per_row; ++k) {
      const int value = values[row * per_row + k];
      if (bits == 16) {
        bytes.push_back(static_cast<png_byte>(value / 256));
      }
      bytes.push_back(static_cast<png_byte>(value % 256));
    }
    png_write_row(png, bytes.data());
  }
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  std::fclose(out);
  return file;
}

}  // namespace swarmanoid::test
