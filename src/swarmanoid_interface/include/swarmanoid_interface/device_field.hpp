/// A device describes its fields once. The description serves the bytes between processes, the names in Python and in
/// comparisons, the checks for numbers that are not finite, and the tables of the documentation.
///
/// A function beside the struct passes the name of each field to a visitor, in the order in which the fields travel:
///
///     template <class Visitor>
///     void fields(Visitor& visit, MyDevice& device) {
///       visit(device.range, {"range", "m", "of what is ahead", {0.0, 1.5}});
///       visit(device.arms, {"arms"});
///     }
///
/// A field is a number, a truth value, an enumeration, an Eigen::Vector3d, a struct that has `fields` itself, a
/// std::array of one of these, or a Span of structs (as many as there are in that tick).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "swarmanoid_interface/range.hpp"
#include "swarmanoid_interface/span.hpp"

namespace swarmanoid {

/// The description that a device gives of one field.
struct FieldInfo {
  const char* name;          ///< the name of the member
  const char* unit = "";     ///< "rad/s"; "" for none
  const char* meaning = "";  ///< one phrase
  Range range = {};          ///< the bounds that values keep or are limited to
};

/// The description of one field for readers of the device; a struct gives one for each of its fields.
struct FieldDescription {
  /// "left.shoulder"; arrays and spans have brackets: "value[]", "joints[].angle", "blobs[].bearing"
  std::string name;
  std::string type;  ///< of one number: f4, f8, b1, u1, ... i8
  std::string unit;
  std::string meaning;
  Range range;
  std::size_t count = 1;     ///< count in a device; 0: it varies
  double resting_value = 0;  ///< value in a device that was just made; of the first number, if there are several
};

/// Returns "value[24] [rad], float32, from 0 to 1"; the range stands there only if the field has one.
std::string describe(const FieldDescription& field);
/// Returns "float64", "bool", "uint8", ...: the name that ROS and NumPy use for the type.
std::string typeName(const FieldDescription& field);

/// The names of the numbers of a device in the order in which they travel.
struct NumberName {
  std::string name;                  ///< "left.shoulder", "value[3]"; of a span: "blobs"
  std::vector<NumberName> elements;  ///< for spans only: the numbers of one element
};

namespace detail {

template <class T>
struct IsArray : std::false_type {};
template <class T, std::size_t n>
struct IsArray<std::array<T, n>> : std::true_type {};
template <>
struct IsArray<Eigen::Vector3d> : std::true_type {};
template <class T>
struct IsSpan : std::false_type {};
template <class T>
struct IsSpan<Span<const T>> : std::true_type {};

/// "f8"
template <class Number>
std::string numberType() {
  const char kind = std::is_same_v<Number, bool>       ? 'b'
                    : std::is_floating_point_v<Number> ? 'f'
                    : std::is_unsigned_v<Number>       ? 'u'
                                                       : 'i';
  return kind + std::to_string(sizeof(Number));
}

/// Checks whether all numbers are finite.
class FiniteCheck {
 public:
  template <class Value>
  void operator()(Value& value, const FieldInfo& /*info*/) {
    look(value);
  }
  bool isFinite() const { return is_finite_; }

 private:
  template <class Value>
  void look(Value& value) {
    if constexpr (std::is_floating_point_v<Value>) {
      is_finite_ = is_finite_ && std::isfinite(value);
    } else if constexpr (IsArray<Value>::value) {
      for (auto& element : value) {
        look(element);
      }
    } else if constexpr (IsSpan<Value>::value) {
      for (auto& element : value) {
        look(const_cast<std::remove_const_t<std::remove_reference_t<decltype(element)>>&>(element));
      }
    } else if constexpr (!std::is_arithmetic_v<Value> && !std::is_enum_v<Value>) {
      fields(*this, value);
    }
  }

  bool is_finite_ = true;
};

/// Collects the list of descriptions.
class FieldLister {
 public:
  template <class Value>
  void operator()(Value& value, const FieldInfo& info) {
    add(value, prefix_ + info.name, info, 1);
  }
  std::vector<FieldDescription> take() { return std::move(fields_); }

 private:
  template <class Value>
  void add(Value& value, const std::string& name, const FieldInfo& info, std::size_t count) {
    if constexpr (std::is_enum_v<Value>) {
      auto number = static_cast<std::underlying_type_t<Value>>(value);
      add(number, name, info, count);
    } else if constexpr (std::is_arithmetic_v<Value>) {
      fields_.push_back(
          {name, numberType<Value>(), info.unit, info.meaning, info.range, count_ * count, static_cast<double>(value)});
    } else if constexpr (IsArray<Value>::value) {
      add(*value.begin(), name + "[]", info, count * static_cast<std::size_t>(value.size()));
    } else if constexpr (IsSpan<Value>::value) {
      std::remove_const_t<std::remove_pointer_t<decltype(value.data())>> element{};
      add(element, name + "[]", info, 0);
    } else {
      const std::string outer = std::move(prefix_);
      const std::size_t outer_count = count_;
      prefix_ = name + ".";
      count_ *= count;
      fields(*this, value);
      prefix_ = outer;
      count_ = outer_count;
    }
  }

  std::vector<FieldDescription> fields_;
  std::string prefix_;
  std::size_t count_ = 1;  // number of structs like the one that is visited
};

/// Collects the list of names.
class NameLister {
 public:
  template <class Value>
  void operator()(Value& value, const FieldInfo& info) {
    add(value, prefix_ + info.name);
  }
  std::vector<NumberName> take() { return std::move(names_); }

 private:
  template <class Value>
  void add(Value& value, const std::string& name) {
    if constexpr (std::is_arithmetic_v<Value> || std::is_enum_v<Value>) {
      names_.push_back({name, {}});
    } else if constexpr (IsArray<Value>::value) {
      std::size_t i = 0;
      for (auto& element : value) {
        add(element, name + "[" + std::to_string(i++) + "]");
      }
    } else if constexpr (IsSpan<Value>::value) {
      std::remove_const_t<std::remove_pointer_t<decltype(value.data())>> element{};
      NameLister inner;
      fields(inner, element);
      names_.push_back({name, inner.take()});
    } else {
      const std::string outer = std::move(prefix_);
      prefix_ = name + ".";
      fields(*this, value);
      prefix_ = outer;
    }
  }

  std::vector<NumberName> names_;
  std::string prefix_;
};

}  // namespace detail

/// Returns whether no number of the device is NaN or infinite.
template <class Device>
bool isFinite(const Device& device) {
  detail::FiniteCheck check;
  // the same list of fields serves all visitors; this visitor changes nothing
  fields(check, const_cast<Device&>(device));
  return check.isFinite();
}

}  // namespace swarmanoid
