/// Where the numbers of a device lie, field by field, so that each field of many devices can be copied to one array and
/// back. It follows from the device's descriptor (swarmanoid_interface/device_field.hpp).
///
/// Threads  any; tables are made once a type of device, and only read afterwards.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/number_type.hpp"

namespace swarmanoid {

/// A field of a record; a record is a device, or an element of a list in a device.
struct FieldPlaces {
  std::string name;  ///< "value", "left.shoulder": without brackets
  NumberType type = NumberType::kF8;
  std::vector<std::size_t> offsets;  ///< of its numbers, the last index fastest [byte]
  std::vector<std::size_t> shape;    ///< of one record; empty: a single number
  std::size_t description = 0;       ///< index in DeviceType::fields
  /// The same numbers as few pieces of bytes, one behind the other in a record.
  struct Piece {
    std::size_t offset = 0;
    std::size_t size = 0;
  };
  std::vector<Piece> pieces;
};

struct ListPlaces;

struct FieldTable {
  std::vector<FieldPlaces> fields;
  std::vector<ListPlaces> lists;

  const FieldPlaces* findField(const std::string& name) const;
  const ListPlaces* findList(const std::string& name) const;
  /// What may follow a prefix such as "" or "joints.": "value", "joints", sorted.
  std::vector<std::string> namesBehind(const std::string& prefix) const;
};

/// A list in a device: as many elements as there are in that tick.
struct ListPlaces {
  std::string name;  ///< "blobs"
  std::size_t offset = 0;
  SpanAccess access;
  FieldTable elements;
};

/// @return valid for ever
const FieldTable& fieldTableOf(const DeviceType& type);

/// Returns the size of a number of that type [byte].
std::size_t sizeOf(NumberType type);

}  // namespace swarmanoid
