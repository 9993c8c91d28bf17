/// Colours as LEDs emit them and cameras report them: 8 bits a channel, compared exactly.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "swarmanoid_interface/device_field.hpp"

namespace swarmanoid {

struct Color {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  /// Black means "off": cameras do not see an LED of that colour.
  constexpr bool isLit() const { return red != 0 || green != 0 || blue != 0; }
  /// Returns the mean of the channels: 0 for black, 1 for white, 1/3 for a pure red, green or blue.
  constexpr double brightness() const {
    constexpr double kWhite = 3.0 * 255.0;
    return (red + green + blue) / kWhite;
  }
  friend constexpr bool operator==(Color a, Color b) {
    return a.red == b.red && a.green == b.green && a.blue == b.blue;
  }
  friend constexpr bool operator!=(Color a, Color b) { return !(a == b); }
};

template <class Visitor>
void fields(Visitor& visit, Color& color) {
  visit(color.red, {"red", "", "", {0.0, 255.0}});
  visit(color.green, {"green", "", "", {0.0, 255.0}});
  visit(color.blue, {"blue", "", "", {0.0, 255.0}});
}

namespace colors {
constexpr Color kBlack{0, 0, 0};
constexpr Color kWhite{255, 255, 255};
constexpr Color kRed{255, 0, 0};
constexpr Color kGreen{0, 255, 0};
constexpr Color kBlue{0, 0, 255};
constexpr Color kYellow{255, 255, 0};
constexpr Color kMagenta{255, 0, 255};
constexpr Color kCyan{0, 255, 255};
constexpr Color kOrange{255, 128, 0};
constexpr Color kGray{128, 128, 128};
}  // namespace colors

/// Reads a name of `colors` ("red", "yellow", ...) or "r,g,b" with numbers from 0 to 255.
/// @return nothing if the text is neither
std::optional<Color> parseColor(std::string_view text);

/// Returns the names that parseColor accepts, in the order of `colors`.
const std::vector<std::string>& colorNames();

/// Returns the name of a colour of `colors`, or "r,g,b" for other colours.
std::string toString(Color color);

}  // namespace swarmanoid
