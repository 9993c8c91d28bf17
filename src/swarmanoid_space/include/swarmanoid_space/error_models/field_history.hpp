/// Values of fields of one robot's device at several times, one slot for each time.
///
/// The constructor allocates all slots. Later only a span that is longer than all previous ones allocates.
///
/// Threads  one at a time: the object belongs to the state of one robot's device.
#pragma once

#include <cstddef>
#include <vector>

#include "swarmanoid_space/error_models/field_selection.hpp"

namespace swarmanoid {

class FieldHistory {
 public:
  FieldHistory() = default;
  /// All slots hold the values of a device at rest, with empty spans.
  /// @param fields the whole fields to keep, the same in all later calls @param slots number of times
  /// @param resting the struct of a device at rest @param spans of the device, the same in all later calls
  /// @param most_elements of a span; memory is reserved for this many
  FieldHistory(const FieldSelection& fields, std::size_t slots, const std::byte* resting,
               const std::vector<SpanPlace>& spans, std::size_t most_elements);

  /// Copies the fields to a slot. @pre slot < number of slots
  void keep(std::size_t slot, const FieldSelection& fields, const std::vector<SpanPlace>& spans,
            const DisturbedDevice& device);
  /// Copies a slot to the fields. @pre slot < number of slots
  void restore(std::size_t slot, const FieldSelection& fields, const std::vector<SpanPlace>& spans,
               const DisturbedDevice& device) const;

  void archive(StateArchive& state) { state(slot_size_, numbers_, elements_); }

 private:
  std::size_t slot_size_ = 0;  // of the numbers [byte]
  std::vector<std::byte> numbers_;
  std::vector<ElementBuffer> elements_;  // slot by slot, in each span by span
};

}  // namespace swarmanoid
