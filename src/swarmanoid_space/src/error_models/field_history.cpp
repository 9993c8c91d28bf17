#include "swarmanoid_space/error_models/field_history.hpp"

namespace swarmanoid {

FieldHistory::FieldHistory(const FieldSelection& fields, std::size_t slots, const std::byte* resting,
                           const std::vector<SpanPlace>& spans, std::size_t most_elements)
    : slots_(slots) {
  for (const NumberPlace& place : fields.numbers) {
    slot_size_ += place.size();
  }
  numbers_.resize(slots * slot_size_);
  std::byte* to = numbers_.data();
  for (std::size_t slot = 0; slot < slots; ++slot) {
    for (const NumberPlace& place : fields.numbers) {
      std::memcpy(to, resting + place.offset, place.size());
      to += place.size();
    }
  }
  elements_.resize(slots * fields.spans.size());
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    elements_[i].reserve(most_elements * spans[fields.spans[i % fields.spans.size()]].access.element_size);
  }
}

void FieldHistory::keep(std::size_t slot, const FieldSelection& fields, const std::vector<SpanPlace>& spans,
                        const DisturbedDevice& device) {
  std::byte* to = numbers_.data() + slot * slot_size_;
  for (const NumberPlace& place : fields.numbers) {
    std::memcpy(to, device.fields + place.offset, place.size());
    to += place.size();
  }
  for (std::size_t i = 0; i < fields.spans.size(); ++i) {
    const std::size_t span = fields.spans[i];
    elements_[slot * fields.spans.size() + i].assign((*device.elements)[span].all(), spans[span].access.element_size);
  }
}

void FieldHistory::restore(std::size_t slot, const FieldSelection& fields, const std::vector<SpanPlace>& spans,
                           const DisturbedDevice& device) const {
  const std::byte* from = numbers_.data() + slot * slot_size_;
  for (const NumberPlace& place : fields.numbers) {
    std::memcpy(device.fields + place.offset, from, place.size());
    from += place.size();
  }
  for (std::size_t i = 0; i < fields.spans.size(); ++i) {
    const std::size_t span = fields.spans[i];
    (*device.elements)[span].assign(elements_[slot * fields.spans.size() + i].all(), spans[span].access.element_size);
  }
}

}  // namespace swarmanoid
