/// Names the types of numbers in devices as layouts do: f4, f8 (floating point), b1 (truth value), u1 to u8 (without
/// sign), i1 to i8; the digit is the size [byte].
#pragma once

#include <cstdint>
#include <string>

namespace swarmanoid {

/// Calls `visit` with a zero of the type. @return whether there is such a type
template <class Visit>
bool withNumberType(const std::string& type, Visit visit) {
  if (type == "f4") {
    visit(float{});
  } else if (type == "f8") {
    visit(double{});
  } else if (type == "b1") {
    visit(bool{});
  } else if (type == "u1") {
    visit(std::uint8_t{});
  } else if (type == "u2") {
    visit(std::uint16_t{});
  } else if (type == "u4") {
    visit(std::uint32_t{});
  } else if (type == "u8") {
    visit(std::uint64_t{});
  } else if (type == "i1") {
    visit(std::int8_t{});
  } else if (type == "i2") {
    visit(std::int16_t{});
  } else if (type == "i4") {
    visit(std::int32_t{});
  } else if (type == "i8") {
    visit(std::int64_t{});
  } else {
    return false;
  }
  return true;
}

}  // namespace swarmanoid
