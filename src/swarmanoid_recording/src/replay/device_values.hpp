/// Converts the bytes of a device to numbers for people, by its layout ("f8 f8 (f4 u1)*") alone.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_interface/byte_stream.hpp"
#include "swarmanoid_interface/frames.hpp"

namespace swarmanoid::replay {

/// A field: a number, or a variable part with its elements.
struct Field {
  std::string number;  ///< short and exact: reading it gives the same bits
  bool is_finite = true;
  bool is_variable = false;
  std::vector<std::vector<Field>> elements;
};

/// @throws ByteError if the bytes are not of that layout
std::vector<Field> decode(const std::string& layout, Span<const std::uint8_t> bytes);

/// Returns "0.15 -0.15 [(1 2) (3 4)]".
std::string toText(const std::vector<Field>& fields);

/// Returns each number with its name: "left", "value[3]", "blobs[0].bearing". If no device of that type and layout is
/// registered in this process, the name is the position: "1" for the second field; "2[0].1" for the second number of
/// the first element of the third field.
std::vector<std::pair<std::string, std::string>> named(const std::vector<Field>& fields, const DeviceLayout& device);

bool isFinite(const std::vector<Field>& fields);

}  // namespace swarmanoid::replay
