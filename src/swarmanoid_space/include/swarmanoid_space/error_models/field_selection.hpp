/// Which numbers and spans of a device an error acts on, and how to get at them in any instance of the device.
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

/// The device of one robot while errors act on it. It owns nothing.
struct DisturbedDevice {
  std::byte* fields = nullptr;                     ///< the struct
  std::vector<ElementBuffer>* elements = nullptr;  ///< of its spans, by span; filled are those that errors act on
};

/// A span of a device.
struct SpanPlace {
  std::size_t offset = 0;  ///< from the beginning of the device [byte]
  SpanAccess access;
};

struct FieldSelection {
  /// Bytes of the device that lie side by side.
  struct Block {
    std::size_t offset = 0;  ///< from the beginning of the device [byte]
    std::size_t size = 0;    ///< [byte]
  };
  struct Elements {
    std::size_t span = 0;  ///< index among the device's spans
    std::size_t size = 0;  ///< of an element [byte]
    std::vector<NumberPlace> numbers;
  };

  std::vector<NumberPlace> numbers;  ///< outside of spans
  std::vector<Block> blocks;         ///< the bytes of `numbers`, in as few blocks as they fill without a gap
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
