/// The types that numbers in devices may have, with the names that layouts give them: f4, f8 (floating point), b1
/// (truth value), u1 to u8 (without sign), i1 to i8; the digit is the size [byte].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace swarmanoid {

enum class NumberType : std::uint8_t { kF4, kF8, kB1, kU1, kU2, kU4, kU8, kI1, kI2, kI4, kI8 };

/// @return nothing if no type has that name
inline std::optional<NumberType> findNumberType(std::string_view name) {
  constexpr std::array<std::string_view, 11> kNames{"f4", "f8", "b1", "u1", "u2", "u4", "u8", "i1", "i2", "i4", "i8"};
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames[i] == name) {
      return static_cast<NumberType>(i);
    }
  }
  return std::nullopt;
}

/// Calls `visit` with a zero of the type. @return its result
template <class Visit>
auto withNumberType(NumberType type, Visit visit) {
  switch (type) {
    case NumberType::kF4:
      return visit(float{});
    case NumberType::kB1:
      return visit(bool{});
    case NumberType::kU1:
      return visit(std::uint8_t{});
    case NumberType::kU2:
      return visit(std::uint16_t{});
    case NumberType::kU4:
      return visit(std::uint32_t{});
    case NumberType::kU8:
      return visit(std::uint64_t{});
    case NumberType::kI1:
      return visit(std::int8_t{});
    case NumberType::kI2:
      return visit(std::int16_t{});
    case NumberType::kI4:
      return visit(std::int32_t{});
    case NumberType::kI8:
      return visit(std::int64_t{});
    case NumberType::kF8:
      break;
  }
  return visit(double{});
}

}  // namespace swarmanoid
