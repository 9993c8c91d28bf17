#include "swarmanoid_rendering/picture.hpp"

#include <png.h>

#include <stdexcept>
#include <string>

namespace swarmanoid {

std::vector<char> toPng(const Picture& picture) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  image.flags = PNG_IMAGE_FLAG_FAST;  // twice as fast; files are a little larger
  std::vector<char> file(PNG_IMAGE_PNG_SIZE_MAX(image));
  png_alloc_size_t size = file.size();
  constexpr int kEightBits = 0;
  if (png_image_write_to_memory(&image, file.data(), &size, kEightBits, picture.rgb.data(), 0, nullptr) == 0) {
    throw std::runtime_error(std::string("a picture cannot be made: ") + image.message);
  }
  file.resize(size);
  return file;
}

}  // namespace swarmanoid
