/// The numbers of one field of a device, for drawing what a controller reads.
#pragma once

#include <cstddef>
#include <string_view>
#include <type_traits>
#include <vector>

#include "swarmanoid_interface/device_field.hpp"

namespace swarmanoid::devices {

/// Collects the numbers of all fields with a name, in the order in which they are serialised: `value` selects the
/// elements of an array `value`, and the `value` of each element of a span.
class FieldNumbers {
 public:
  /// @param numbers output; the numbers are appended
  FieldNumbers(std::string_view name, std::vector<double>& numbers) : name_(name), numbers_(numbers) {}

  template <class Value>
  void operator()(Value& value, const FieldInfo& info) {
    look(value, name_ == info.name);
  }

 private:
  template <class Value>
  void look(Value& value, bool is_meant) {
    if constexpr (std::is_arithmetic_v<Value>) {
      if (is_meant) {
        numbers_.push_back(static_cast<double>(value));
      }
    } else if constexpr (detail::IsArray<Value>::value) {
      for (auto& element : value) {
        look(element, is_meant);
      }
    } else if constexpr (detail::IsSpan<Value>::value) {
      for (auto element : value) {
        fields(*this, element);
      }
    } else if constexpr (!std::is_enum_v<Value>) {
      fields(*this, value);
    }
  }

  std::string_view name_;
  std::vector<double>& numbers_;
};

/// The numbers of the fields with that name, padded with zeros to at least `least` numbers; valid until this thread
/// calls it again.
template <class Device>
const std::vector<double>& numbersOf(Device device, std::string_view name, std::size_t least) {
  thread_local std::vector<double> numbers;
  numbers.clear();
  FieldNumbers visitor(name, numbers);
  fields(visitor, device);
  if (numbers.size() < least) {
    numbers.resize(least, 0.0);
  }
  return numbers;
}

}  // namespace swarmanoid::devices
