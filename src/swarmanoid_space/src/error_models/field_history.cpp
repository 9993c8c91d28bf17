#include "swarmanoid_space/error_models/field_history.hpp"

#include <cstring>

namespace swarmanoid {

FieldHistory::FieldHistory(const FieldSelection& fields, std::size_t slots, const std::byte* resting,
                           const std::vector<SpanPlace>& spans, std::size_t most_elements) {
  for (const FieldSelection::Block& block : fields.blocks) {
    slot_size_ += block.size;
  }
  numbers_.resize(slots * slot_size_);
  std::byte* to = numbers_.data();
  for (std::size_t slot = 0; slot < slots; ++slot) {
    for (const FieldSelection::Block& block : fields.blocks) {
      std::memcpy(to, resting + block.offset, block.size);
      to += block.size;
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
  for (const FieldSelection::Block& block : fields.blocks) {
    std::memcpy(to, device.fields + block.offset, block.size);
    to += block.size;
  }
  for (std::size_t i = 0; i < fields.spans.size(); ++i) {
    const std::size_t span = fields.spans[i];
    elements_[slot * fields.spans.size() + i].assign((*device.elements)[span].all(), spans[span].access.element_size);
  }
}

void FieldHistory::restore(std::size_t slot, const FieldSelection& fields, const std::vector<SpanPlace>& spans,
                           const DisturbedDevice& device) const {
  const std::byte* from = numbers_.data() + slot * slot_size_;
  for (const FieldSelection::Block& block : fields.blocks) {
    std::memcpy(device.fields + block.offset, from, block.size);
    from += block.size;
  }
  for (std::size_t i = 0; i < fields.spans.size(); ++i) {
    const std::size_t span = fields.spans[i];
    (*device.elements)[span].assign(elements_[slot * fields.spans.size() + i].all(), spans[span].access.element_size);
  }
}

}  // namespace swarmanoid
