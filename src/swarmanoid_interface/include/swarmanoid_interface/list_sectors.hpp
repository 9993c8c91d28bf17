/// Numbers from a list in a device, such as the blobs of a camera, scaled to [-1, 1]: of the first elements, or by
/// direction. Inputs of neural networks and observations of learning share these classes, so that a trained network
/// gets the numbers that it was trained with.
///
///     scaled = clamp(value, minimum, maximum) / max(|minimum|, |maximum|)       near: 1 - |scaled|; NaN: 0
///
/// Units    values and range: those of the field; results: none, from -1 to 1.
/// Threads  const after construction; the device belongs to one thread at a time.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/field_table.hpp"
#include "swarmanoid_interface/number_place.hpp"
#include "swarmanoid_interface/range.hpp"

namespace swarmanoid {

/// Bounds in the descriptor, or else those of the number's type; +-pi for angles that wrap, infinite if there are none.
Range scalingBoundsOf(const FieldDescription& field);

/// Reads names of colours with commas between, "yellow, green". @throws ConfigError
std::vector<Color> colorsIn(const Configuration& parameters, std::string_view key);

/// Scales a value of the range to [-1, 1]. @param range finite @param is_near 1 at 0, and 0 at the farthest value
inline double scaledTo(Range range, bool is_near, double value) {
  if (std::isnan(value)) {
    return 0.0;  // no reading
  }
  const double farthest = std::max(std::abs(range.minimum), std::abs(range.maximum));
  const double part = std::clamp(value, range.minimum, range.maximum) / farthest;
  return is_near ? 1.0 - std::abs(part) : part;
}

/// Bounds of scaled values.
inline Range scaledBounds(Range range, bool is_near) {
  return {is_near || range.minimum >= 0.0 ? 0.0 : -1.0, is_near || range.maximum > 0.0 ? 1.0 : 0.0};
}

/// A field of so many elements, from the first on; 0 where there is none.
class FirstElements {
 public:
  /// @param count of elements, from 1 @param range finite, minimum < maximum @param is_near as of scaledTo
  FirstElements(const ListPlaces& list, const FieldPlaces& field, std::size_t count, Range range, bool is_near);

  /// Number of results: those of the first element, then those of the next.
  std::size_t count() const { return elements_ * places_.size(); }
  Range bounds() const { return scaledBounds(range_, is_near_); }
  /// @param device that has the list @param values count() numbers
  template <class Number>
  void read(const std::byte* device, Number* values) const {
    const Span<const std::byte> bytes = access_.bytes(device + offset_);
    const std::size_t there = bytes.size() / access_.element_size;
    for (std::size_t k = 0; k < elements_; ++k) {
      const std::byte* element = bytes.data() + k * access_.element_size;
      for (const NumberPlace& place : places_) {
        *values++ = k < there ? static_cast<Number>(scaledTo(range_, is_near_, place.read(element))) : Number{0};
      }
    }
  }

 private:
  std::size_t elements_;
  Range range_;
  bool is_near_;
  std::size_t offset_;  // of the list in the device [byte]
  SpanAccess access_;
  std::vector<NumberPlace> places_;
};

/// A field by direction: the full turn is divided into equal sectors, the first one centred ahead, then
/// counter-clockwise. Each sector has one number: of the scaled values of its elements the one farthest from 0, and 0
/// without elements. With several colours, each colour has its own sectors, and other elements do not count.
class ListSectors {
 public:
  struct Options {
    std::size_t sectors = 2;    ///< from 2
    Range range;                ///< finite, minimum < maximum
    bool is_near = false;       ///< 1 for the value 0, and 0 for the farthest: for distances
    std::vector<Color> colors;  ///< each with its sectors; empty: elements of any colour
  };

  ListSectors() = default;
  /// @pre reasonAgainst(...) is empty
  ListSectors(const DeviceType& type, const ListPlaces& list, const FieldPlaces& field, const Options& options);

  /// Reason why the field of the list has no sectors, as "with ..." behind "allowed: "; an empty string if it has.
  static std::string reasonAgainst(const DeviceType& type, const ListPlaces& list, const FieldPlaces& field,
                                   bool has_colors);

  /// Number of results: the sectors of the first colour, then those of the next.
  std::size_t count() const { return options_.sectors * std::max<std::size_t>(options_.colors.size(), 1); }
  /// Bounds of each result.
  Range bounds() const { return scaledBounds(options_.range, options_.is_near); }
  /// @param device that has the list @param values count() numbers
  template <class Number>
  void read(const std::byte* device, Number* values) const {
    std::fill(values, values + count(), Number{0});
    const Span<const std::byte> bytes = access_.bytes(device + offset_);
    const auto sectors = static_cast<double>(options_.sectors);
    for (std::size_t at = 0; at < bytes.size(); at += access_.element_size) {
      const std::byte* element = bytes.data() + at;
      const double turn = direction_.read(element) / (2.0 * M_PI);
      const std::size_t color = colorOf(element);
      if (!std::isfinite(turn) || color == kOtherColor) {
        continue;
      }
      const double sector = std::floor((turn - std::floor(turn)) * sectors + 0.5);
      Number& value = values[color * options_.sectors + (sector >= sectors ? 0 : static_cast<std::size_t>(sector))];
      const auto found = static_cast<Number>(scaledTo(options_.range, options_.is_near, value_.read(element)));
      value = std::abs(found) > std::abs(value) ? found : value;
    }
  }

 private:
  static constexpr std::size_t kOtherColor = SIZE_MAX;

  /// Index of the element's colour in Options::colors; 0 if these are empty.
  std::size_t colorOf(const std::byte* element) const {
    if (options_.colors.empty()) {
      return 0;
    }
    Color color;
    std::memcpy(&color.red, element + red_, sizeof color.red);
    std::memcpy(&color.green, element + green_, sizeof color.green);
    std::memcpy(&color.blue, element + blue_, sizeof color.blue);
    const auto found = std::find(options_.colors.begin(), options_.colors.end(), color);
    return found == options_.colors.end() ? kOtherColor : static_cast<std::size_t>(found - options_.colors.begin());
  }

  Options options_;
  std::size_t offset_ = 0;  // of the list in the device [byte]
  SpanAccess access_;
  NumberPlace direction_;
  NumberPlace value_;
  std::size_t red_ = 0;  // offsets of the channels in an element [byte]
  std::size_t green_ = 0;
  std::size_t blue_ = 0;
};

}  // namespace swarmanoid
