#include "swarmanoid_interface/color.hpp"

#include <array>
#include <charconv>
#include <utility>

namespace swarmanoid {
namespace {

using NamedColor = std::pair<std::string_view, Color>;
constexpr std::array<NamedColor, 10> kNamedColors{{{"black", colors::kBlack},
                                                   {"white", colors::kWhite},
                                                   {"red", colors::kRed},
                                                   {"green", colors::kGreen},
                                                   {"blue", colors::kBlue},
                                                   {"yellow", colors::kYellow},
                                                   {"magenta", colors::kMagenta},
                                                   {"cyan", colors::kCyan},
                                                   {"orange", colors::kOrange},
                                                   {"gray", colors::kGray}}};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::optional<std::uint8_t> parseChannel(std::string_view text) {
  text = trimmed(text);
  int value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 0 || value > 255) {
    return std::nullopt;
  }
  return static_cast<std::uint8_t>(value);
}

}  // namespace

std::optional<Color> parseColor(std::string_view text) {
  text = trimmed(text);
  for (const auto& [name, color] : kNamedColors) {
    if (name == text) {
      return color;
    }
  }
  const auto first = text.find(',');
  const auto second = first == std::string_view::npos ? first : text.find(',', first + 1);
  if (second == std::string_view::npos) {
    return std::nullopt;
  }
  const auto red = parseChannel(text.substr(0, first));
  const auto green = parseChannel(text.substr(first + 1, second - first - 1));
  const auto blue = parseChannel(text.substr(second + 1));
  if (!red || !green || !blue) {
    return std::nullopt;
  }
  return Color{*red, *green, *blue};
}

const std::vector<std::string>& colorNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const auto& [name, color] : kNamedColors) {
      result.emplace_back(name);
    }
    return result;
  }();
  return names;
}

std::string toString(Color color) {
  for (const auto& [name, value] : kNamedColors) {
    if (value == color) {
      return std::string(name);
    }
  }
  return std::to_string(color.red) + "," + std::to_string(color.green) + "," + std::to_string(color.blue);
}

}  // namespace swarmanoid
