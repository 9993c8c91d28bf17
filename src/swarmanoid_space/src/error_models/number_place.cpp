#include "swarmanoid_space/error_models/number_place.hpp"

#include <cmath>
#include <map>
#include <string>
#include <type_traits>

namespace swarmanoid {
namespace {

/// Calls `visit` with a number of that type.
template <class Visit>
auto withType(NumberPlace::Type type, Visit visit) {
  using Type = NumberPlace::Type;
  switch (type) {
    case Type::kF4:
      return visit(float{});
    case Type::kB1:
    case Type::kU1:
      return visit(std::uint8_t{});
    case Type::kU2:
      return visit(std::uint16_t{});
    case Type::kU4:
      return visit(std::uint32_t{});
    case Type::kU8:
      return visit(std::uint64_t{});
    case Type::kI1:
      return visit(std::int8_t{});
    case Type::kI2:
      return visit(std::int16_t{});
    case Type::kI4:
      return visit(std::int32_t{});
    case Type::kI8:
      return visit(std::int64_t{});
    case Type::kF8:
      break;
  }
  return visit(double{});
}

template <class Number>
Number nearest(double value) {
  using Limits = std::numeric_limits<Number>;
  if (value >= static_cast<double>(Limits::max())) {
    return Limits::max();  // the double nearest to the greatest whole number may be greater than that
  }
  if (value <= static_cast<double>(Limits::lowest())) {
    return Limits::lowest();
  }
  return static_cast<Number>(std::is_floating_point_v<Number> ? value : std::nearbyint(value));
}

/// The least and the greatest number of a type within bounds; infinite bounds stay.
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
  return withType(type, [](auto number) { return sizeof number; });
}

double NumberPlace::readWhole(const std::byte* fields) const {
  return withType(type, [&](auto number) {
    std::memcpy(&number, fields + offset, sizeof number);
    return static_cast<double>(number);
  });
}

void NumberPlace::writeWhole(std::byte* fields, double value) const {
  withType(type, [&](auto number) {
    number = nearest<decltype(number)>(value);
    std::memcpy(fields + offset, &number, sizeof number);
  });
}

NumberPlace placeOf(const DeviceNumber& number, const FieldDescription& field) {
  using Type = NumberPlace::Type;
  static const std::map<std::string, Type> types{
      {"f4", Type::kF4}, {"f8", Type::kF8}, {"b1", Type::kB1}, {"u1", Type::kU1}, {"u2", Type::kU2}, {"u4", Type::kU4},
      {"u8", Type::kU8}, {"i1", Type::kI1}, {"i2", Type::kI2}, {"i4", Type::kI4}, {"i8", Type::kI8}};
  const Range range = field.wraps ? Range{-M_PI, M_PI} : field.range;
  NumberPlace place{number.offset, types.at(number.type), field.wraps, {}};
  place.range = withType(place.type, [&](auto type) { return boundsIn<decltype(type)>(range); });
  return place;
}

}  // namespace swarmanoid
