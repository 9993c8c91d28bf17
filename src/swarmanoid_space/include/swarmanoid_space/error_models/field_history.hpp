/// Values of fields of one robot's device at several moments, one slot a moment.
///
/// Threads  as its owner. All slots are allocated when it is made; spans may need more when they are longer than ever.
#pragma once

#include <cstddef>
#include <vector>

#include "swarmanoid_space/error_models/field_selection.hpp"

namespace swarmanoid {

class FieldHistory {
 public:
  FieldHistory() = default;
  /// All slots hold the values of a device at rest, with empty spans.
  /// @param resting the struct @param spans of the device @param most_elements room for so many in each span
  FieldHistory(const FieldSelection& fields, std::size_t slots, const std::byte* resting,
               const std::vector<SpanPlace>& spans, std::size_t most_elements);

  /// Copies the fields to a slot.
  void keep(std::size_t slot, const FieldSelection& fields, const std::vector<SpanPlace>& spans,
            const DisturbedDevice& device);
  /// Copies a slot to the fields.
  void restore(std::size_t slot, const FieldSelection& fields, const std::vector<SpanPlace>& spans,
               const DisturbedDevice& device) const;

 private:
  std::size_t slot_size_ = 0;  // of the numbers [byte]
  std::vector<std::byte> numbers_;
  std::vector<ElementBuffer> elements_;  // slot by slot, in each span by span
};

}  // namespace swarmanoid
