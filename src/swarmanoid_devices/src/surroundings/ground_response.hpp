/// Reading of an infrared ground sensor over a floor of a given colour.
///
/// Ideal: the mean of the channels' codes (Ground::reflection). As a printed floor: the experiment's colours are sRGB,
/// so the codes are linearised first (IEC 61966-2-1). Near infrared differs from visible light: printed black (soot)
/// absorbs it, while cyan, magenta and yellow inks let most of it through to the paper. A printer mixes colours other
/// than grey from these inks, and adds as much black as the brightest channel leaves. With the linear channels r, g, b
///
///     value = black + (1 - black) (t max(r, g, b) + (1 - t) (r + g + b) / 3)
///
/// where t is the transmission of coloured inks in the infrared, and `black` the reflection of printed black relative
/// to white paper.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "swarmanoid_interface/devices/ground.hpp"

namespace swarmanoid::devices {

class GroundResponse {
 public:
  static constexpr double kUsualTransparency = 0.9;
  static constexpr double kUsualBlack = 0.05;

  /// The ideal response.
  GroundResponse() = default;
  /// The response of a printed floor. @param ink_transparency and @param black from 0 to 1
  GroundResponse(double ink_transparency, double black)
      : is_printed_(true), ink_transparency_(ink_transparency), black_(black) {}

  float operator()(Color color) const { return is_printed_ ? printed(color) : Ground::reflection(color); }

 private:
  /// Linear intensity of each code of a channel, from 0 to 1.
  static const std::array<double, 256>& linearCodes() {
    static const std::array<double, 256> codes = [] {
      std::array<double, 256> light{};
      for (std::size_t code = 0; code < light.size(); ++code) {
        const double value = static_cast<double>(code) / 255.0;
        light[code] = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
      }
      return light;
    }();
    return codes;
  }

  float printed(Color color) const {
    const std::array<double, 256>& light = linearCodes();
    const double red = light[color.red];
    const double green = light[color.green];
    const double blue = light[color.blue];
    const double let_through = ink_transparency_ * std::max({red, green, blue});
    const double seen = (1.0 - ink_transparency_) * (red + green + blue) / 3.0;
    return static_cast<float>(black_ + (1.0 - black_) * (let_through + seen));
  }

  bool is_printed_ = false;
  double ink_transparency_ = 0.0;
  double black_ = 0.0;
};

}  // namespace swarmanoid::devices
