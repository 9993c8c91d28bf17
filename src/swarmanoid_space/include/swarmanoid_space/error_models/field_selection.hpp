/// The numbers and spans of a device on which an error acts, with access to them in any instance of the device.
///
/// Threads  const after it is made.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/number_place.hpp"
#include "swarmanoid_space/error_models/element_buffer.hpp"

namespace swarmanoid {

/// The device of one robot while errors act on it. Owns no memory.
struct DisturbedDevice {
  std::byte* fields = nullptr;                     ///< the struct
  std::vector<ElementBuffer>* elements = nullptr;  ///< by index of the span; filled only for spans with errors
};

/// A span of a device.
struct SpanPlace {
  std::size_t offset = 0;  ///< from the beginning of the device [byte]
  SpanAccess access;
};

struct FieldSelection {
  /// Contiguous bytes of the device.
  struct Block {
    std::size_t offset = 0;  ///< from the beginning of the device [byte]
    std::size_t size = 0;    ///< [byte]
  };
  struct Elements {
    std::size_t span = 0;  ///< index among the device's spans
    std::size_t size = 0;  ///< of an element [byte]
    std::vector<NumberPlace> numbers;
  };

  std::vector<NumberPlace> numbers;  ///< outside spans
  std::vector<Block> blocks;         ///< the bytes of `numbers`, as few blocks as possible
  std::vector<Elements> elements;    ///< numbers in the elements of spans
  std::vector<std::size_t> spans;    ///< whole spans, by index among the device's spans

  bool isEmpty() const { return numbers.empty() && elements.empty() && spans.empty(); }
  /// Count of numbers; a number of a span's elements counts once, for any number of elements.
  std::size_t numberCount() const;
};

/// The fields on which a kind of error can act.
enum class ErrorSubject {
  kNumbers,     ///< numbers, also those in elements of spans; no truth values, no enumerations
  kWholeFields  ///< all fields and whole spans; no fields of elements, since elements change from tick to tick
};

/// Spans of the device, in the order of transmission.
std::vector<SpanPlace> spansOf(const DeviceType& device);

/// Finds the fields of that name that suit the subject. `field` is a name as in the descriptor: "left", "value",
/// "value[3]", "joints[].angle", "blobs[].distance". A name includes all of its parts; "" means the whole device.
/// @param kind for messages
/// @throws ConfigError if no field suits; the message names the suitable ones
FieldSelection selectFields(const DeviceType& device, const std::string& field, ErrorSubject subject,
                            const std::string& kind, const SourceLocation& location);

/// Calls `visit(place, bytes, index)` for each number: `bytes` is the struct that contains it. `index` counts numbers;
/// it is the same for one number in all elements of a span.
template <class Visit>
void forEachNumber(const FieldSelection& selection, DisturbedDevice device, Visit visit) {
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
