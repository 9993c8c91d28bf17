/// Which numbers and spans of a device an error acts on, and how to get at them in any instance of the device.
///
/// Threads  const after it is made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_space/error_models/element_buffer.hpp"

namespace swarmanoid {

/// The device of one robot while errors act on it. Elements of spans lie in buffers of the robot, by span.
struct DisturbedDevice {
  std::byte* fields = nullptr;  ///< the struct
  std::vector<ElementBuffer>* elements = nullptr;
};

/// A number in a struct of bytes.
struct NumberPlace {
  enum class Type : std::uint8_t { kF4, kF8, kB1, kU1, kU2, kU4, kU8, kI1, kI2, kI4, kI8 };

  std::size_t offset = 0;  ///< from the beginning of the device or of the element [byte]
  Type type = Type::kF8;
  Range range;         ///< of its field
  bool wraps = false;  ///< as FieldInfo::wraps

  std::size_t size() const;  ///< [byte]
  double read(const std::byte* fields) const {
    return type == Type::kF4   ? readReal<float>(fields)
           : type == Type::kF8 ? readReal<double>(fields)
                               : readWhole(fields);
  }
  /// Writes the nearest number that the type has: whole numbers are rounded, and nothing becomes infinite.
  void write(std::byte* fields, double value) const {
    if (type == Type::kF4) {
      writeReal<float>(fields, value);
    } else if (type == Type::kF8) {
      writeReal<double>(fields, value);
    } else {
      writeWhole(fields, value);
    }
  }
  /// Brings the number within the bounds of its field: wrapped if it is such an angle, else limited.
  void limit(std::byte* fields) const {
    const double value = read(fields);
    if (wraps || !(value >= range.minimum && value <= range.maximum)) {
      bringWithin(fields, value);
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
  void writeReal(std::byte* fields, double value) const {
    constexpr auto kMost = static_cast<double>(std::numeric_limits<Real>::max());
    const Real real = static_cast<Real>(value >= kMost ? kMost : value <= -kMost ? -kMost : value);
    std::memcpy(fields + offset, &real, sizeof real);
  }
  double readWhole(const std::byte* fields) const;
  void writeWhole(std::byte* fields, double value) const;
  void bringWithin(std::byte* fields, double value) const;
};

/// A span of a device.
struct SpanPlace {
  std::size_t offset = 0;  ///< from the beginning of the device [byte]
  SpanAccess access;
};

struct FieldSelection {
  struct Elements {
    std::size_t span = 0;  ///< index among the device's spans
    std::size_t size = 0;  ///< of an element [byte]
    std::vector<NumberPlace> numbers;
  };

  std::vector<NumberPlace> numbers;  ///< outside of spans
  std::vector<Elements> elements;    ///< numbers in the elements of spans
  std::vector<std::size_t> spans;    ///< whole spans, by index among the device's spans

  bool isEmpty() const { return numbers.empty() && elements.empty() && spans.empty(); }
  /// Numbers, those of elements counted once however many elements there are.
  std::size_t numberCount() const;
};

/// What a kind of error can act on.
enum class ErrorSubject {
  kNumbers,     ///< numbers, also those in elements of spans; no truth values, no enumerations
  kWholeFields  ///< all fields and whole spans; no fields of elements, which are others in the next tick
};

/// Spans of the device, in the order in which they travel.
std::vector<SpanPlace> spansOf(const DeviceType& device);

/// Finds the fields of that name that suit. `field` is a name as in the descriptor: "left", "value", "value[3]",
/// "joints[].angle", "blobs[].distance"; a name stands for all that is in it, and "" for the whole device.
/// @param kind for messages
/// @throws ConfigError if there are none, naming those that there are
FieldSelection selectFields(const DeviceType& device, const std::string& field, ErrorSubject subject,
                            const std::string& kind, const SourceLocation& location);

/// Calls `visit(place, bytes, index)` for each number: `bytes` is the struct that it lies in, `index` counts numbers,
/// the same for that number of all elements of a span.
template <class Visit>
void forEachNumber(const FieldSelection& selection, const DisturbedDevice& device, Visit visit) {
  std::size_t index = 0;
  for (const NumberPlace& place : selection.numbers) {
    visit(place, device.fields, index++);
  }
  for (const FieldSelection::Elements& elements : selection.elements) {
    ElementBuffer& buffer = (*device.elements)[elements.span];
    for (std::size_t k = 0; k < buffer.count(); ++k) {
      for (std::size_t i = 0; i < elements.numbers.size(); ++i) {
        visit(elements.numbers[i], buffer.bytes() + k * elements.size, index + i);
      }
    }
    index += elements.numbers.size();
  }
}

}  // namespace swarmanoid
