#include "swarmanoid_interface/number_place.hpp"

#include <cmath>
#include <type_traits>

namespace swarmanoid {
namespace {

template <class Number>
Number nearest(double value) {
  using Limits = std::numeric_limits<Number>;
  if (value >= static_cast<double>(Limits::max())) {
    return Limits::max();  // the double nearest to the greatest integer may be greater than that
  }
  if (value <= static_cast<double>(Limits::lowest())) {
    return Limits::lowest();
  }
  return static_cast<Number>(std::is_floating_point_v<Number> ? value : std::nearbyint(value));
}

/// The smallest and the largest number of a type within bounds; infinite bounds stay.
template <class Number>
Range boundsIn(const Range& range) {
  if constexpr (std::is_floating_point_v<Number>) {
    constexpr Number kInfinite = std::numeric_limits<Number>::infinity();
    auto minimum = static_cast<Number>(range.minimum);
    auto maximum = static_cast<Number>(range.maximum);
    if (static_cast<double>(minimum) < range.minimum) {
      minimum = std::nextafter(minimum, kInfinite);
    }
    if (static_cast<double>(maximum) > range.maximum) {
      maximum = std::nextafter(maximum, -kInfinite);
    }
    return {static_cast<double>(minimum), static_cast<double>(maximum)};
  } else {
    return {std::ceil(range.minimum), std::floor(range.maximum)};
  }
}

}  // namespace

std::size_t NumberPlace::size() const {
  return withNumberType(type, [](auto number) { return sizeof number; });
}

double NumberPlace::readWhole(const std::byte* fields) const {
  return withNumberType(type, [&](auto number) {
    std::memcpy(&number, fields + offset, sizeof number);
    return static_cast<double>(number);
  });
}

void NumberPlace::writeWhole(std::byte* fields, double value) const {
  withNumberType(type, [&](auto number) {
    number = nearest<decltype(number)>(value);
    std::memcpy(fields + offset, &number, sizeof number);
  });
}

NumberPlace placeOf(const DeviceNumber& number, const FieldDescription& field) {
  const Range range = field.wraps ? Range{-M_PI, M_PI} : field.range;
  NumberPlace place{number.offset, findNumberType(number.type).value(), field.wraps, field.is_distance, {}};
  place.range = withNumberType(place.type, [&](auto type) { return boundsIn<decltype(type)>(range); });
  return place;
}

}  // namespace swarmanoid
