#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_space/error_models/field_selection.hpp"

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

void NumberPlace::bringWithin(std::byte* fields, double value) const {
  write(fields, wraps ? wrapAngle(value) : std::clamp(value, range.minimum, range.maximum));
  const double written = read(fields);
  if (written < range.minimum || written > range.maximum) {
    // single precision has rounded it out of the range again
    const auto inward = std::nextafter(static_cast<float>(written), 0.0F);
    write(fields, static_cast<double>(inward));
  }
}

}  // namespace swarmanoid
