#include "read_png.hpp"

#include <png.h>

#include <array>
#include <csetjmp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace swarmanoid {
namespace {

constexpr int kFewest = 2;
constexpr int kMost = 4096;

/// State of libpng. It leaves its functions by longjmp, so functions that call it must not own resources.
struct Reading {
  Reading() = default;
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;
  ~Reading() { png_destroy_read_struct(&png, &info, nullptr); }

  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string problem;
  std::vector<png_byte> bytes;
  std::vector<png_bytep> rows;
};

void takeError(png_structp png, png_const_charp message) {
  static_cast<Reading*>(png_get_error_ptr(png))->problem = message;
  png_longjmp(png, 1);
}

void ignoreWarning(png_structp, png_const_charp) {}

/// @return false if the file is not a PNG image; then `problem` has the reason
bool readHeader(Reading& reading, std::FILE* file) {
  if (setjmp(png_jmpbuf(reading.png)) != 0) {
    return false;
  }
  png_init_io(reading.png, file);
  png_read_info(reading.png, reading.info);
  return true;
}

bool readPixels(Reading& reading) {
  if (setjmp(png_jmpbuf(reading.png)) != 0) {
    return false;
  }
  png_read_image(reading.png, reading.rows.data());
  png_read_end(reading.png, nullptr);
  return true;
}

/// libpng also exits by longjmp here, such as for an invalid palette.
bool updateInfo(Reading& reading, void (*prepare)(Reading&)) {
  if (setjmp(png_jmpbuf(reading.png)) != 0) {
    return false;
  }
  if (prepare != nullptr) {
    prepare(reading);
  }
  png_set_interlace_handling(reading.png);
  png_read_update_info(reading.png, reading.info);
  return true;
}

bool hasSignature(std::FILE* file) {
  constexpr std::size_t kLength = 8;
  std::array<png_byte, kLength> bytes{};
  const bool is_png =
      std::fread(bytes.data(), 1, kLength, file) == kLength && png_sig_cmp(bytes.data(), 0, kLength) == 0;
  std::rewind(file);
  return is_png;
}

void makeRoom(Reading& reading) {
  const std::size_t rows = png_get_image_height(reading.png, reading.info);
  const std::size_t row_bytes = png_get_rowbytes(reading.png, reading.info);
  reading.bytes.resize(rows * row_bytes);
  for (std::size_t i = 0; i < rows; ++i) {
    reading.rows.push_back(reading.bytes.data() + i * row_bytes);
  }
}

/// Reason why the size is not supported, or an empty string.
std::string sizeComplaint(const Reading& reading) {
  const int columns = static_cast<int>(png_get_image_width(reading.png, reading.info));
  const int rows = static_cast<int>(png_get_image_height(reading.png, reading.info));
  if (columns < kFewest || rows < kFewest || columns > kMost || rows > kMost) {
    return "has " + std::to_string(columns) + " x " + std::to_string(rows) + " pixels";
  }
  return "";
}

/// Reason why the image is not supported as a grey image, or an empty string.
std::string greyComplaint(const Reading& reading) {
  const int bits = png_get_bit_depth(reading.png, reading.info);
  const int channels = png_get_color_type(reading.png, reading.info);
  if (channels != PNG_COLOR_TYPE_GRAY) {
    return channels == PNG_COLOR_TYPE_GRAY_ALPHA ? "is partly transparent" : "is coloured";
  }
  if (bits != 8 && bits != 16) {
    return "has " + std::to_string(bits) + (bits == 1 ? " bit" : " bits");
  }
  return sizeComplaint(reading);
}

/// Requests pixels of four bytes, red, green, blue and opacity, for all kinds of files.
void askForFourBytes(Reading& reading) {
  png_set_expand(reading.png);
  png_set_strip_16(reading.png);
  png_set_gray_to_rgb(reading.png);
  png_set_add_alpha(reading.png, 0xff, PNG_FILLER_AFTER);
}

using Complaint = std::string (*)(const Reading&);
using Preparation = void (*)(Reading&);

/// @param complaint checks the header @param prepare requests the wanted pixel format; null: that of the file
void read(Reading& reading, const std::string& name, Complaint complaint, Preparation prepare) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(name, ignored);
  if (std::filesystem::is_other(status)) {
    throw std::runtime_error("is a pipe or a device");  // opening a pipe would block until a writer opens it
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(name.c_str(), "rb"), &std::fclose);
  if (file == nullptr) {
    throw std::runtime_error("cannot be opened as '" + name + "'");
  }
  if (!hasSignature(file.get())) {
    throw std::runtime_error("is no PNG image");
  }
  reading.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reading, &takeError, &ignoreWarning);
  reading.info = reading.png == nullptr ? nullptr : png_create_info_struct(reading.png);
  if (reading.info == nullptr) {
    throw std::runtime_error("libpng cannot read");
  }
  if (!readHeader(reading, file.get())) {
    throw std::runtime_error("is damaged (" + reading.problem + ")");
  }
  if (const std::string problem = complaint(reading); !problem.empty()) {
    throw std::runtime_error(problem);
  }
  if (!updateInfo(reading, prepare)) {
    throw std::runtime_error("is damaged (" + reading.problem + ")");
  }
  makeRoom(reading);
  if (!readPixels(reading)) {
    throw std::runtime_error("is damaged (" + reading.problem + ")");
  }
}

}  // namespace

GreyImage readGreyPng(const std::string& file) {
  Reading reading;
  read(reading, file, &greyComplaint, nullptr);
  const bool is_wide = png_get_bit_depth(reading.png, reading.info) == 16;
  GreyImage image;
  image.columns = static_cast<int>(png_get_image_width(reading.png, reading.info));
  image.rows = static_cast<int>(png_get_image_height(reading.png, reading.info));
  image.white = is_wide ? 0xffff : 0xff;
  for (std::size_t i = 0; i < reading.bytes.size(); i += is_wide ? 2 : 1) {
    image.values.push_back(
        static_cast<std::uint16_t>(is_wide ? 256 * reading.bytes[i] + reading.bytes[i + 1] : reading.bytes[i]));
  }
  return image;
}

ColorImage readColorPng(const std::string& file) {
  constexpr png_byte kHalf = 128;
  Reading reading;
  read(reading, file, &sizeComplaint, &askForFourBytes);
  ColorImage image;
  image.columns = static_cast<int>(png_get_image_width(reading.png, reading.info));
  image.rows = static_cast<int>(png_get_image_height(reading.png, reading.info));
  for (std::size_t i = 0; i < reading.bytes.size(); i += 4) {
    const png_byte* pixel = &reading.bytes[i];
    image.colors.push_back({pixel[0], pixel[1], pixel[2]});
    image.is_opaque.push_back(pixel[3] >= kHalf ? 1 : 0);
  }
  return image;
}

}  // namespace swarmanoid
