// Colour images from all kinds of PNG. Grey images are tested as terrains.
#include "../src/images/read_png.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "swarmanoid_experiment_files/testing/write_png.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"

namespace swarmanoid {
namespace {

using Colors = std::vector<Color>;

class ReadPngTest : public testing::Test {
 protected:
  std::string write(int columns, int bits, const std::vector<int>& values, int type) {
    return test::writePng(folder_.path() / "image.png", columns, bits, values, type);
  }

  const TemporaryFolder folder_{"read_png_test"};
};

TEST_F(ReadPngTest, ColouredOnesAreReadRowAfterRowFromTheTop) {
  const ColorImage image = readColorPng(write(2, 8, {1, 2, 3, 4, 5, 6, 7, 8, 9, 250, 251, 252}, PNG_COLOR_TYPE_RGB));
  EXPECT_EQ(image.columns, 2);
  EXPECT_EQ(image.rows, 2);
  EXPECT_EQ(image.colors, (Colors{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {250, 251, 252}}));
  EXPECT_EQ(image.is_opaque, (std::vector<char>{1, 1, 1, 1}));
}

TEST_F(ReadPngTest, GreyOnesAreColours) {
  EXPECT_EQ(readColorPng(write(2, 8, {0, 51, 102, 255}, PNG_COLOR_TYPE_GRAY)).colors,
            (Colors{{0, 0, 0}, {51, 51, 51}, {102, 102, 102}, {255, 255, 255}}));
}

TEST_F(ReadPngTest, OfSixteenBitsTheUpperEightCount) {
  EXPECT_EQ(readColorPng(write(2, 16, {0x12ff, 0x3400, 0xffff, 0x00ff}, PNG_COLOR_TYPE_GRAY)).colors,
            (Colors{{0x12, 0x12, 0x12}, {0x34, 0x34, 0x34}, {255, 255, 255}, {0, 0, 0}}));
}

TEST_F(ReadPngTest, WhatIsLessThanHalfOpaqueHasNoColour) {
  const ColorImage image = readColorPng(write(2, 8, {9, 0, 8, 127, 7, 128, 6, 255}, PNG_COLOR_TYPE_GRAY_ALPHA));
  EXPECT_EQ(image.is_opaque, (std::vector<char>{0, 0, 1, 1}));
  EXPECT_EQ(image.colors[2], (Color{7, 7, 7}));
}

TEST_F(ReadPngTest, WhatIsNoneIsSaid) {
  const auto complaintAbout = [](const std::string& file) -> std::string {
    try {
      readColorPng(file);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(complaintAbout("/nowhere.png"), "cannot be opened as '/nowhere.png'");
  EXPECT_EQ(complaintAbout("/dev/zero"), "is a pipe or a device");
  EXPECT_EQ(complaintAbout(write(1, 8, {1, 2}, PNG_COLOR_TYPE_GRAY)), "has 1 x 2 pixels");
  EXPECT_EQ(complaintAbout(write(4097, 8, std::vector<int>(2 * 4097), PNG_COLOR_TYPE_GRAY)), "has 4097 x 2 pixels");
}

}  // namespace
}  // namespace swarmanoid
