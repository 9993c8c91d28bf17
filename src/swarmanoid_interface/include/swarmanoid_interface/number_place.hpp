/// Where a number of a device lies, and how to read, write and limit it in any instance of the device.
///
/// Units    those of its field, as the device's descriptor gives them.
/// Threads  const after it is made; the bytes belong to one robot, and one thread at a time works on them.
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
  bool wraps = false;        ///< an angle, which is kept from -pi to pi
  bool is_distance = false;  ///< a measured distance, which may be infinite
  /// The bounds of its field, or the numbers next to them inside if the type does not have the bounds themselves:
  /// single precision has no 0.7, and what is stored for it is less than that.
  Range range;

  std::size_t size() const;  ///< [byte]
  bool isReal() const { return type == NumberType::kF4 || type == NumberType::kF8; }
  /// Whether there are numbers that `limit` changes.
  bool isBounded() const { return range.minimum > -kInfinity || range.maximum < kInfinity; }

  double read(const std::byte* fields) const {
    return type == NumberType::kF4   ? readReal<float>(fields)
           : type == NumberType::kF8 ? readReal<double>(fields)
                                     : readWhole(fields);
  }
  /// Writes the nearest number that the type has: whole numbers are rounded, and nothing finite becomes infinite.
  void write(std::byte* fields, double value) const {
    const double most = type == NumberType::kF4 ? mostOf<float>() : mostOf<double>();
    const bool is_kept = std::abs(value) < most || (is_distance && std::isinf(value));
    store(fields, is_kept ? value : std::clamp(value, -most, most));
  }
  /// Brings the number within the bounds of its field: wrapped if it is such an angle, infinite if it is a measured
  /// distance, else limited. NaN stays.
  void limit(std::byte* fields) const {
    const double value = read(fields);
    if (is_distance) {
      if (value < range.minimum || value > range.maximum) {
        store(fields, value < range.minimum ? -kInfinity : kInfinity);
      }
    } else if (isReal() && !wraps) {
      // stored in any case: whether noise around a bound is beyond it is a branch that no processor predicts
      store(fields, std::clamp(value, range.minimum, range.maximum));
    } else if (!range.contains(value)) {
      // the type has what lies within the bounds, so nothing can become infinite
      store(fields, std::clamp(wraps ? wrapAngle(value) : value, range.minimum, range.maximum));
    }
  }

 private:
  // Nearly all fields are real numbers, and each of them passes here in each tick: these are inline.
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
