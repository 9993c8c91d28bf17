/// A device describes its fields once. The description serves the bytes between processes, the names in Python and in
/// comparisons, the checks for numbers that are not finite, and the tables of the documentation.
///
/// A function next to the struct passes the name of each field to a visitor, in the order of the bytes:
///
///     template <class Visitor>
///     void fields(Visitor& visit, MyDevice& device) {
///       visit(device.range, {"range", "m", "distance of the nearest obstacle ahead", {0.0, 1.5}});
///       visit(device.arms, {"arms"});
///     }
///
/// A field is a number, a truth value, an enumeration, an Eigen::Vector3d, a struct that has `fields` itself, a
/// std::array of one of these, or a Span of structs, which may contain arrays; the length of a span may change each
/// tick.
#pragma once

#include <Eigen/Core>
#include <algorithm>
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
  const char* meaning = "";  ///< one phrase; fields without one inherit that of their struct or list
  Range range = {};          ///< the bounds that values keep or are limited to
  bool wraps = false;        ///< an angle that wraps around at its bounds
  /// A measured distance, which need not be finite (REP-117): infinity if nothing is in range, -infinity if an object
  /// is too close, NaN if nothing is measured. Values beyond the bounds become infinite.
  bool is_distance = false;
  bool may_be_nan = false;  ///< NaN means unknown
};

/// Describes a field that is a measured distance [m].
constexpr FieldInfo distanceField(const char* name, const char* meaning, Range range) {
  return {name, "m", meaning, range, false, true};
}

/// Returns the field with NaN allowed, which means unknown.
constexpr FieldInfo orUnknown(FieldInfo info) {
  info.may_be_nan = true;
  return info;
}

/// Description of one field for readers of the device. A struct has one for each of its fields.
struct FieldDescription {
  /// "left.shoulder"; arrays and spans have brackets: "value[]", "joints[].angle", "blobs[].bearing"
  std::string name;
  std::string type;  ///< type of one number: f4, f8, b1, u1, ... i8
  std::string unit;
  std::string meaning;
  Range range;
  std::size_t count = 1;             ///< count in a device; 0 if it varies
  double resting_value = 0;          ///< initial value in a device; of the first number, if there are several
  bool wraps = false;                ///< an angle within one turn
  std::size_t count_in_element = 0;  ///< count in one element of a span; 0 outside spans
  bool is_distance = false;          ///< a measured distance, which need not be finite
  bool may_be_nan = false;           ///< NaN means unknown
};

/// Returns "value[24]", "joints[6].angle", "blobs[].bearing", "messages[].payload[10]": the name with the counts that
/// are fixed.
std::string countedName(const FieldDescription& field);
/// Returns "value[24] [rad], float32, from 0 to 1"; the range is included only if the field has one.
std::string describe(const FieldDescription& field);
/// Returns "float64", "bool", "uint8", ...: the name that ROS and NumPy use for the type.
std::string typeName(const FieldDescription& field);

/// Reads and replaces the elements of a span whose type the caller does not know.
struct SpanAccess {
  std::size_t element_size = 0;                           ///< [byte]
  Span<const std::byte> (*bytes)(const void*) = nullptr;  ///< of all elements of the span
  void (*set)(void* span, const void* elements, std::size_t count) = nullptr;
};

/// One number of a device, or one span, with its offset in the struct. A device has a list of them, in the order of its
/// bytes.
struct DeviceNumber {
  enum class Kind { kNumber, kTruthValue, kEnumeration, kSpan };

  std::string name;  ///< "left.shoulder", "value[3]"; of a span: "blobs"
  Kind kind = Kind::kNumber;
  std::string type;        ///< f4, f8, b1, u1, ... i8; "" for spans
  std::size_t offset = 0;  ///< from the beginning of the device, or of the element for numbers in a span [byte]
  std::size_t field = 0;   ///< index of its description in DeviceType::fields; 0 for spans
  SpanAccess span;         ///< for spans only
  std::vector<DeviceNumber> elements;  ///< for spans only: the numbers of one element
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

/// Checks whether all numbers that must be finite are finite.
class FiniteCheck {
 public:
  template <class Value>
  void operator()(Value& value, const FieldInfo& info) {
    if constexpr (std::is_floating_point_v<Value>) {
      if (info.may_be_nan && std::isnan(value)) {
        return;
      }
    }
    if (!info.is_distance) {
      look(value);
    }
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

/// Makes the access to a span of a type.
template <class T>
SpanAccess spanAccess() {
  static_assert(std::is_trivially_copyable_v<T>, "elements of spans are copied as bytes");
  SpanAccess access;
  access.element_size = sizeof(T);
  access.bytes = [](const void* span) {
    const auto& elements = *static_cast<const Span<const T>*>(span);
    return Span<const std::byte>(reinterpret_cast<const std::byte*>(elements.data()), elements.size() * sizeof(T));
  };
  access.set = [](void* span, const void* elements, std::size_t count) {
    *static_cast<Span<const T>*>(span) = Span<const T>(static_cast<const T*>(elements), count);
  };
  return access;
}

/// Limits numbers to the ranges of their fields.
class RangeLimiter {
 public:
  template <class Value>
  void operator()(Value& value, const FieldInfo& info) {
    if (!info.is_distance) {
      limit(value, info.range);
    }
  }

 private:
  template <class Value>
  void limit(Value& value, const Range& range) {
    if constexpr (std::is_floating_point_v<Value>) {
      value = static_cast<Value>(std::clamp(static_cast<double>(value), range.minimum, range.maximum));
    } else if constexpr (IsArray<Value>::value) {
      for (auto& element : value) {
        limit(element, range);
      }
    } else if constexpr (!std::is_arithmetic_v<Value> && !std::is_enum_v<Value> && !IsSpan<Value>::value) {
      fields(*this, value);
    }
  }
};

/// Collects the descriptions of the fields, and the list of the numbers.
class FieldLister {
 public:
  /// @param device the device that `fields` is called with
  explicit FieldLister(const void* device) : origin_(static_cast<const std::byte*>(device)) {}

  template <class Value>
  void operator()(Value& value, const FieldInfo& info) {
    const std::string meaning = info.meaning;
    add(value, {outer_.number + info.name, outer_.field + info.name, meaning.empty() ? outer_.meaning : meaning}, info);
  }
  std::vector<FieldDescription> takeFields() { return std::move(fields_); }
  std::vector<DeviceNumber> takeNumbers() { return std::move(numbers_); }

 private:
  struct Name {
    std::string number;   // "joints[2].angle"; relative to the element inside of a span
    std::string field;    // "joints[].angle"
    std::string meaning;  // of the field, or of the struct or list that contains it
  };

  template <class Value>
  void add(Value& value, const Name& name, const FieldInfo& info) {
    if constexpr (std::is_enum_v<Value>) {
      using Number = std::underlying_type_t<Value>;
      addNumber<Number>(&value, static_cast<Number>(value), DeviceNumber::Kind::kEnumeration, name, info);
    } else if constexpr (std::is_arithmetic_v<Value>) {
      constexpr bool kIsBool = std::is_same_v<Value, bool>;
      addNumber<Value>(&value, value, kIsBool ? DeviceNumber::Kind::kTruthValue : DeviceNumber::Kind::kNumber, name,
                       info);
    } else if constexpr (IsArray<Value>::value) {
      std::size_t i = 0;
      for (auto& element : value) {
        add(element, {name.number + "[" + std::to_string(i++) + "]", name.field + "[]", name.meaning}, info);
      }
    } else if constexpr (IsSpan<Value>::value) {
      addSpan(value, name);
    } else {
      const Name outer = std::exchange(outer_, {name.number + ".", name.field + ".", name.meaning});
      fields(*this, value);
      outer_ = outer;
    }
  }

  template <class Number>
  void addNumber(const void* place, Number value, DeviceNumber::Kind kind, const Name& name, const FieldInfo& info) {
    const auto known = std::find_if(fields_.begin(), fields_.end(),
                                    [&](const FieldDescription& field) { return field.name == name.field; });
    const auto field = static_cast<std::size_t>(known - fields_.begin());
    if (known == fields_.end()) {
      fields_.push_back({name.field, numberType<Number>(), info.unit, name.meaning, info.range, 0,
                         static_cast<double>(value), info.wraps, 0, info.is_distance, info.may_be_nan});
    }
    ++(is_in_span_ ? fields_[field].count_in_element : fields_[field].count);
    numbers_.push_back({name.number, kind, numberType<Number>(), offsetOf(place), field, {}, {}});
  }

  template <class T>
  void addSpan(const Span<const T>& span, const Name& name) {
    T element{};
    DeviceNumber number{name.number, DeviceNumber::Kind::kSpan, "", offsetOf(&span), 0, spanAccess<T>(), {}};
    const Name outer = std::exchange(outer_, {"", name.field + "[].", name.meaning});
    const std::byte* origin = std::exchange(origin_, reinterpret_cast<const std::byte*>(&element));
    is_in_span_ = true;
    std::swap(numbers_, number.elements);
    fields(*this, element);
    std::swap(numbers_, number.elements);
    is_in_span_ = false;
    origin_ = origin;
    outer_ = outer;
    numbers_.push_back(std::move(number));
  }

  std::size_t offsetOf(const void* place) const {
    return static_cast<std::size_t>(static_cast<const std::byte*>(place) - origin_);
  }

  std::vector<FieldDescription> fields_;
  std::vector<DeviceNumber> numbers_;
  Name outer_;  // names of the visited struct, each with a trailing dot
  const std::byte* origin_;
  bool is_in_span_ = false;
};

}  // namespace detail

/// Limits the numbers of a command to the ranges of its fields: a number outside becomes the nearer bound, and so does
/// an angle that wraps (FieldInfo::wraps). Spans, integers, measured distances and NaN are left unchanged.
template <class Device>
void limitToRanges(Device& device) {
  detail::RangeLimiter limiter;
  fields(limiter, device);
}

/// Returns whether all numbers of the device are finite. Measured distances (FieldInfo::is_distance) are not checked,
/// and NaN is accepted where it means unknown (FieldInfo::may_be_nan).
template <class Device>
bool isFinite(const Device& device) {
  detail::FiniteCheck check;
  // the same list of fields serves all visitors; this visitor changes nothing
  fields(check, const_cast<Device&>(device));
  return check.isFinite();
}

}  // namespace swarmanoid
