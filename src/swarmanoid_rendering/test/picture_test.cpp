#include "swarmanoid_rendering/picture.hpp"

#include <gtest/gtest.h>
#include <png.h>

namespace swarmanoid {
namespace {

TEST(PictureTest, APngHasItsPixels) {
  Picture picture{7, 3, {}};
  for (int byte = 0; byte < 7 * 3 * 3; ++byte) {
    picture.rgb.push_back(static_cast<std::uint8_t>(byte * 37 % 256));
  }
  const std::vector<char> file = toPng(picture);

  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&image, file.data(), file.size()), 0) << image.message;
  EXPECT_EQ(image.width, 7U);
  EXPECT_EQ(image.height, 3U);
  image.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> read(PNG_IMAGE_SIZE(image));
  ASSERT_NE(png_image_finish_read(&image, nullptr, read.data(), 0, nullptr), 0) << image.message;
  EXPECT_EQ(read, picture.rgb);
  EXPECT_EQ(picture.pixel(2, 1)[0], (7 + 2) * 3 * 37 % 256);
}

}  // namespace
}  // namespace swarmanoid
