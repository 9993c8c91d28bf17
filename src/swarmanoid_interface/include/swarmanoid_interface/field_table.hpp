/// Offsets of the numbers of a device, field by field, so that each field of many devices can be copied to one array
/// and back. The table is derived from the device's descriptor (swarmanoid_interface/device_field.hpp).
///
/// Threads  any; tables are made once per device type and only read afterwards.
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
  std::vector<std::size_t> offsets;  ///< of its numbers, last index fastest [byte]
  std::vector<std::size_t> shape;    ///< of one record; empty: a single number
  std::size_t description = 0;       ///< index in DeviceType::fields
  /// A contiguous run of the field's bytes in a record; the runs in this order make up the field.
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
  /// Names that may follow a prefix such as "" or "joints.": "value", "joints", sorted.
  std::vector<std::string> namesBehind(const std::string& prefix) const;
};

/// A list in a device; its length may change each tick.
struct ListPlaces {
  std::string name;  ///< "blobs"
  std::size_t offset = 0;
  SpanAccess access;
  FieldTable elements;
};

/// @return a table that is never destroyed
const FieldTable& fieldTableOf(const DeviceType& type);

/// Returns the size of a number of that type [byte].
std::size_t sizeOf(NumberType type);

}  // namespace swarmanoid
