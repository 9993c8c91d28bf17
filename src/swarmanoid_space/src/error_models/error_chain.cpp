#include "swarmanoid_space/error_models/error_chain.hpp"

#include <algorithm>

#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid {
namespace {

/// Adds the numbers that have bounds, without duplicates.
void addBounded(const std::vector<NumberPlace>& numbers, std::vector<NumberPlace>& known) {
  for (const NumberPlace& place : numbers) {
    const auto is_same = [&](const NumberPlace& other) { return other.offset == place.offset; };
    if (place.isBounded() && std::none_of(known.begin(), known.end(), is_same)) {
      known.push_back(place);
    }
  }
}

}  // namespace

const DeviceType& requireDeviceType(const std::string& type, const SourceLocation& location) {
  const DeviceType* device = findDeviceType(type);
  if (device == nullptr) {
    throw ConfigError(location, "found an error of '" + type + "', allowed: of a device with REGISTER_DEVICE");
  }
  return *device;
}

ErrorChain::ErrorChain(const DeviceType& device, ErrorOrigin origin)
    : device_(device), origin_(origin), spans_(spansOf(device)) {}

void ErrorChain::addAlias(const std::string& kind, const std::string& field, const std::string& parameter,
                          double value) {
  SWARMANOID_EXPECTS(!hasListed());
  const ErrorKind* found = findErrorKind(kind);
  SWARMANOID_EXPECTS(found != nullptr);
  Configuration parameters("error", "", {});
  for (const Parameter& known : found->description.parameters) {
    parameters.set(known.name, known.name == parameter ? numberText(value) : known.value.value_or(""));
  }
  Entry& entry = append(*found, parameters, selectFields(device_, field, found->subject, kind, {}));
  entry.stream_index = 0;
  ++alias_count_;
}

void ErrorChain::add(const ErrorModelDescription& description) {
  const ErrorKind* found = findErrorKind(description.kind);
  if (found == nullptr) {
    throw ConfigError(description.location, unknownName("the error kind", description.kind, errorKindNames()));
  }
  Entry& entry =
      append(*found, description.parameters,
             selectFields(device_, description.field, found->subject, description.kind, description.field_location));
  entry.from_tick = description.from_tick;
  // an <error> keeps its random numbers when others are added before or after it, except others of the same kind and
  // field
  const char* const origin = origin_ == ErrorOrigin::kFault ? " fault " : " error ";
  const std::string name = device_.type + origin + description.kind + " " + description.field;
  const auto is_same = [&](const Entry& other) { return other.stream.rfind(name + " #", 0) == 0; };
  entry.stream = name + " #" + std::to_string(std::count_if(entries_.begin(), entries_.end(), is_same));
  entry.stream_index = entries_.size() - alias_count_;
}

ErrorChain::Entry& ErrorChain::append(const ErrorKind& kind, const Configuration& parameters, FieldSelection fields) {
  Entry entry{kind.make(parameters), std::move(fields), 0, "", 0, memory_size_, 0};
  entry.memory_size = entry.model->keepsMemory() ? entry.fields.numberCount() : 0;
  memory_size_ += entry.memory_size;
  useSpans(entry.fields);
  if (kind.subject == ErrorSubject::kNumbers) {
    limit(entry.fields);
  }
  entries_.push_back(std::move(entry));
  return entries_.back();
}

void ErrorChain::useSpans(const FieldSelection& fields) {
  const auto use = [&](std::size_t span) {
    if (std::find(used_spans_.begin(), used_spans_.end(), span) == used_spans_.end()) {
      used_spans_.push_back(span);
    }
  };
  for (const std::size_t span : fields.spans) {
    use(span);
  }
  for (const FieldSelection::Elements& elements : fields.elements) {
    use(elements.span);
  }
}

void ErrorChain::limit(const FieldSelection& fields) {
  if (device_.kind == DeviceKind::kActuator) {
    return;
  }
  addBounded(fields.numbers, limited_.numbers);
  for (const FieldSelection::Elements& elements : fields.elements) {
    auto known = std::find_if(limited_.elements.begin(), limited_.elements.end(),
                              [&](const FieldSelection::Elements& other) { return other.span == elements.span; });
    if (known == limited_.elements.end()) {
      known = limited_.elements.insert(known, {elements.span, elements.size, {}});
    }
    addBounded(elements.numbers, known->numbers);
    if (known->numbers.empty()) {
      limited_.elements.erase(known);
    }
  }
}

ErrorState ErrorChain::makeState(std::uint64_t seed, std::string_view entity, std::size_t most_elements) const {
  const std::shared_ptr<void> resting = device_.make();
  ErrorState state;
  state.streams.emplace_back(seed, entity, device_.type);
  state.memory.resize(memory_size_);
  for (const Entry& entry : entries_) {
    if (!entry.stream.empty()) {
      state.streams.emplace_back(seed, entity, entry.stream);
    }
    RandomStream& random = state.streams[entry.stream_index];
    random.startTick(0);
    for (std::size_t i = 0; i < entry.memory_size; ++i) {
      state.memory[entry.memory_begin + i] = entry.model->firstMemory(random);
    }
    state.histories.emplace_back(entry.fields, entry.model->historySlots(),
                                 static_cast<const std::byte*>(resting.get()), spans_, most_elements);
  }
  state.memory_before = state.memory;
  state.elements.resize(spans_.size());
  for (const std::size_t span : used_spans_) {
    state.elements[span].reserve(most_elements * spans_[span].access.element_size);
  }
  return state;
}

void ErrorChain::startTick(ErrorState& state, std::uint64_t tick) const {
  if (memory_size_ > 0) {
    // a repeated tick starts from the memory after the previous tick
    const bool is_again = tick == state.tick;
    const std::vector<double>& from = is_again ? state.memory_before : state.memory;
    std::copy(from.begin(), from.end(), (is_again ? state.memory : state.memory_before).begin());
  }
  state.tick = tick;
  state.first_tick = std::min(state.first_tick, tick);
  for (RandomStream& stream : state.streams) {
    stream.startTick(tick);
  }
}

void ErrorChain::takeElements(const std::byte* device, ErrorState& state) const {
  for (const std::size_t span : used_spans_) {
    const SpanPlace& place = spans_[span];
    state.elements[span].assign(place.access.bytes(device + place.offset), place.access.element_size);
  }
}

void ErrorChain::deliverElements(std::byte* device, ErrorState& state) const {
  for (const std::size_t span : used_spans_) {
    const SpanPlace& place = spans_[span];
    place.access.set(device + place.offset, state.elements[span].bytes(), state.elements[span].count());
  }
}

void ErrorChain::apply(void* device, ErrorState& state, std::uint64_t tick, std::size_t first_entry) const {
  SWARMANOID_EXPECTS(state.histories.size() == entries_.size());
  startTick(state, tick);
  ErrorStep step;
  step.tick = tick;
  step.spans = &spans_;
  step.device = {static_cast<std::byte*>(device), &state.elements};
  if (!used_spans_.empty()) {
    takeElements(step.device.fields, state);
  }
  FieldHistory* history = state.histories.data() + first_entry;
  const Entry* const end = entries_.data() + entries_.size();
  for (const Entry* entry = entries_.data() + first_entry; entry != end; ++entry, ++history) {
    step.first_tick = std::max(entry->from_tick, state.first_tick);
    step.fields = &entry->fields;
    step.random = &state.streams[entry->stream_index];
    step.memory = state.memory.data() + entry->memory_begin;
    step.history = history;
    entry->model->apply(step);
  }
  forEachNumber(limited_, step.device,
                [](const NumberPlace& place, std::byte* bytes, std::size_t /*index*/) { place.limit(bytes); });
  if (!used_spans_.empty()) {
    deliverElements(step.device.fields, state);
  }
}

}  // namespace swarmanoid
