#include "swarmanoid_space/error_models/field_selection.hpp"

#include <algorithm>

namespace swarmanoid {
namespace {

/// Returns whether the pattern "joints[].angle" matches "joints[2].angle" or a part of it.
bool isMeant(const std::string& pattern, const std::string& name) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (at == name.size()) {
      return false;
    }
    if (pattern.compare(i, 2, "[]") == 0 && name[at] == '[') {
      at = name.find(']', at) + 1;
      ++i;
    } else if (pattern[i] != name[at++]) {
      return false;
    }
  }
  return pattern.empty() || at == name.size() || name[at] == '.' || name[at] == '[';
}

std::vector<FieldSelection::Block> blocksOf(const std::vector<NumberPlace>& numbers) {
  std::vector<FieldSelection::Block> sorted;
  for (const NumberPlace& place : numbers) {
    sorted.push_back({place.offset, place.size()});
  }
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.offset < b.offset; });
  std::vector<FieldSelection::Block> blocks;
  for (const FieldSelection::Block& block : sorted) {
    if (!blocks.empty() && blocks.back().offset + blocks.back().size == block.offset) {
      blocks.back().size += block.size;
    } else {
      blocks.push_back(block);
    }
  }
  return blocks;
}

/// Visits the numbers of a device and selects those that match the field and are suitable.
class Selector {
 public:
  Selector(const DeviceType& device, const std::string& field, ErrorSubject subject)
      : device_(device), field_(field), subject_(subject) {}

  void select() {
    for (const DeviceNumber& number : device_.numbers) {
      if (number.kind == DeviceNumber::Kind::kSpan) {
        selectSpan(number);
      } else {
        const bool suits = subject_ == ErrorSubject::kWholeFields || number.kind == DeviceNumber::Kind::kNumber;
        if (look(number.name, nameOf(number), suits, number.kind)) {
          selection.numbers.push_back(placeOf(number, device_.fields[number.field]));
        }
      }
    }
  }

  FieldSelection selection;
  std::vector<std::string> suitable;  // names of suitable fields
  std::string unsuitable;             // description of the first matching field that is not suitable; "": none

 private:
  void selectSpan(const DeviceNumber& span) {
    const bool takes_numbers = subject_ == ErrorSubject::kNumbers;
    if (!takes_numbers && look(span.name, span.name, true, DeviceNumber::Kind::kSpan)) {
      selection.spans.push_back(span_index_);
    }
    FieldSelection::Elements elements{span_index_, span.span.element_size, {}};
    for (const DeviceNumber& number : span.elements) {
      const bool suits = takes_numbers && number.kind == DeviceNumber::Kind::kNumber;
      // a field that matches the whole span does not select its elements
      const bool is_of_span = !takes_numbers && isMeant(field_, span.name);
      if (!is_of_span && look(span.name + "[]." + number.name, nameOf(number), suits, number.kind, true)) {
        elements.numbers.push_back(placeOf(number, device_.fields[number.field]));
      }
    }
    if (!elements.numbers.empty()) {
      selection.elements.push_back(std::move(elements));
    }
    ++span_index_;
  }

  /// @return whether the number is selected
  bool look(const std::string& name, const std::string& shown, bool suits, DeviceNumber::Kind kind,
            bool is_element = false) {
    if (suits && std::find(suitable.begin(), suitable.end(), shown) == suitable.end()) {
      suitable.push_back(shown);
    }
    const bool is_meant = isMeant(field_, name);
    if (is_meant && !suits && unsuitable.empty()) {
      const bool is_about_elements = is_element && subject_ == ErrorSubject::kWholeFields;
      unsuitable = is_about_elements                         ? "elements that are others in the next tick"
                   : kind == DeviceNumber::Kind::kTruthValue ? "a truth value"
                                                             : "one of several modes";
    }
    return is_meant && suits;
  }

  /// Returns "value" for "value[]": the bracket at the end may be left out.
  std::string nameOf(const DeviceNumber& number) const {
    const std::string& name = device_.fields[number.field].name;
    const bool is_array = name.size() > 2 && name.compare(name.size() - 2, 2, "[]") == 0;
    return is_array ? name.substr(0, name.size() - 2) : name;
  }

  const DeviceType& device_;
  const std::string& field_;
  const ErrorSubject subject_;
  std::size_t span_index_ = 0;
};

}  // namespace

std::size_t FieldSelection::numberCount() const {
  std::size_t count = numbers.size();
  for (const Elements& span : elements) {
    count += span.numbers.size();
  }
  return count;
}

std::vector<SpanPlace> spansOf(const DeviceType& device) {
  std::vector<SpanPlace> spans;
  for (const DeviceNumber& number : device.numbers) {
    if (number.kind == DeviceNumber::Kind::kSpan) {
      spans.push_back({number.offset, number.span});
    }
  }
  return spans;
}

FieldSelection selectFields(const DeviceType& device, const std::string& field, ErrorSubject subject,
                            const std::string& kind, const SourceLocation& location) {
  Selector selector(device, field, subject);
  selector.select();
  if (!selector.selection.isEmpty()) {
    selector.selection.blocks = blocksOf(selector.selection.numbers);
    return std::move(selector.selection);
  }
  if (selector.suitable.empty()) {
    throw ConfigError(location, "found the error kind '" + kind + "' for " + toString(device.kind) + " '" +
                                    device.type + "', which has no numbers, allowed: a kind for any field");
  }
  if (!selector.unsuitable.empty()) {
    throw ConfigError(location, "found the field '" + field + "' (" + selector.unsuitable + ") for the error kind '" +
                                    kind + "', allowed: " + joinNames(selector.suitable));
  }
  throw ConfigError(location, unknownName("the field", field, selector.suitable) + " (of " + device.type + ")");
}

}  // namespace swarmanoid
