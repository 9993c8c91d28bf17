/// The place of a number in a device, with functions that read, write and limit it in any instance of the device.
///
/// Units    those of its field, as the device's descriptor gives them.
/// Threads  const after construction; the bytes belong to one robot, and one thread at a time accesses them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/device_field.hpp"
#include "swarmanoid_interface/number_type.hpp"

namespace swarmanoid {

/// A number in a struct of bytes.
struct NumberPlace {
  std::size_t offset = 0;  ///< from the beginning of the device or of the element [byte]
  NumberType type = NumberType::kF8;
  bool wraps = false;        ///< an angle that is wrapped to [-pi, pi]
  bool is_distance = false;  ///< a measured distance, which may be infinite
  /// Bounds of the field. A bound that the type cannot represent is replaced by the nearest number of the type inside
  /// the bounds: single precision, for example, has no 0.7.
  Range range;

  std::size_t size() const;  ///< [byte]
  bool isReal() const { return type == NumberType::kF4 || type == NumberType::kF8; }
  /// Returns whether `limit` changes any numbers.
  bool isBounded() const { return range.minimum > -kInfinity || range.maximum < kInfinity; }

  double read(const std::byte* fields) const {
    return type == NumberType::kF4   ? readReal<float>(fields)
           : type == NumberType::kF8 ? readReal<double>(fields)
                                     : readWhole(fields);
  }
  /// Writes the nearest number of the type: integers are rounded, and finite values stay finite.
  void write(std::byte* fields, double value) const {
    const double most = type == NumberType::kF4 ? mostOf<float>() : mostOf<double>();
    const bool is_kept = std::abs(value) < most || (is_distance && std::isinf(value));
    store(fields, is_kept ? value : std::clamp(value, -most, most));
  }
  /// Limits the number to the bounds of its field. Outside of them, an angle that wraps is wrapped, a measured distance
  /// becomes infinite, and any other number becomes the nearer bound. NaN stays.
  void limit(std::byte* fields) const {
    const double value = read(fields);
    if (is_distance) {
      if (value < range.minimum || value > range.maximum) {
        store(fields, value < range.minimum ? -kInfinity : kInfinity);
      }
    } else if (isReal() && !wraps) {
      // always stored: with noise around a bound, a branch would be mispredicted
      store(fields, std::clamp(value, range.minimum, range.maximum));
    } else if (!range.contains(value)) {
      // the type can represent all values within the bounds, so none becomes infinite
      store(fields, std::clamp(wraps ? wrapAngle(value) : value, range.minimum, range.maximum));
    }
  }

 private:
  // Inline, because nearly all fields are real numbers, and these functions process each of them in each tick.
  template <class Real>
  double readReal(const std::byte* fields) const {
    Real real;
    std::memcpy(&real, fields + offset, sizeof real);
    return static_cast<double>(real);
  }
  template <class Real>
  void storeReal(std::byte* fields, double value) const {
    const Real real = static_cast<Real>(value);
    std::memcpy(fields + offset, &real, sizeof real);
  }
  template <class Real>
  static constexpr double mostOf() {
    return static_cast<double>(std::numeric_limits<Real>::max());
  }
  void store(std::byte* fields, double value) const {
    if (type == NumberType::kF4) {
      storeReal<float>(fields, value);
    } else if (type == NumberType::kF8) {
      storeReal<double>(fields, value);
    } else {
      writeWhole(fields, value);
    }
  }
  double readWhole(const std::byte* fields) const;
  void writeWhole(std::byte* fields, double value) const;
};

/// @param number of a device or of an element, not a span @param field its description
NumberPlace placeOf(const DeviceNumber& number, const FieldDescription& field);

}  // namespace swarmanoid
