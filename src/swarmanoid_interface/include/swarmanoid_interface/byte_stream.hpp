/// Converts values to bytes and back, for frames between processes. Numbers are little-endian and in full precision;
/// texts and blocks are preceded by their lengths.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "swarmanoid_interface/device_field.hpp"
#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_interface/span.hpp"

namespace swarmanoid {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "bytes are copied as they stand");

using Bytes = std::vector<std::uint8_t>;

/// The bytes do not have the layout that the reader expects.
class ByteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Visits all values in turn: numbers, enumerations, arrays, spans, and structs that have `fields`.
template <class Stream, class... Values>
void all(Stream& stream, Values&... values);

/// Appends to a byte vector that the caller owns.
class ByteWriter {
 public:
  explicit ByteWriter(Bytes& out) : out_(out) {}

  /// Writes a field of a device.
  template <class Value>
  void operator()(Value& value, const FieldInfo& /*info*/) {
    all(*this, value);
  }

  template <class Number>
  void number(Number value) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(&value);
    out_.insert(out_.end(), bytes, bytes + sizeof value);
  }
  template <class T>
  void span(const Span<const T>& values) {
    number(static_cast<std::uint32_t>(values.size()));
    for (const T& value : values) {
      all(*this, const_cast<T&>(value));
    }
  }
  void text(const std::string& text) {
    number(static_cast<std::uint32_t>(text.size()));
    out_.insert(out_.end(), text.begin(), text.end());
  }

  /// Begins a block, which closeBlock ends; its length is stored in front of it. @return the argument for closeBlock
  std::size_t openBlock() {
    number(std::uint32_t{0});
    return out_.size();
  }
  void closeBlock(std::size_t begin) {
    const auto length = static_cast<std::uint32_t>(out_.size() - begin);
    std::memcpy(&out_[begin - sizeof length], &length, sizeof length);
  }

 private:
  Bytes& out_;
};

/// Stores the elements of spans that are read from bytes.
class VariableParts {
 public:
  /// Returns memory for `count` elements with their initial values, valid until clear.
  template <class T>
  T* room(std::size_t count) {
    static_assert(std::is_trivially_destructible_v<T> && alignof(T) <= alignof(std::uint64_t));
    if (used_ == buffers_.size()) {
      buffers_.emplace_back();
    }
    std::vector<std::uint64_t>& buffer = buffers_[used_++];
    buffer.resize((count * sizeof(T) + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t));
    T* first = reinterpret_cast<T*>(buffer.data());
    for (std::size_t i = 0; i < count; ++i) {
      new (first + i) T{};
    }
    return first;
  }
  void clear() { used_ = 0; }

 private:
  std::vector<std::vector<std::uint64_t>> buffers_;
  std::size_t used_ = 0;
};

/// Reads the bytes of a ByteWriter. @throws ByteError where the bytes end too early
class ByteReader {
 public:
  explicit ByteReader(Span<const std::uint8_t> in) : in_(in) {}

  /// Reads a field of a device.
  template <class Value>
  void operator()(Value& value, const FieldInfo& /*info*/) {
    all(*this, value);
  }

  template <class Number>
  void number(Number& value) {
    const Span<const std::uint8_t> bytes = take(sizeof value);
    if constexpr (std::is_same_v<Number, bool>) {
      value = bytes[0] != 0;
    } else {
      std::memcpy(&value, bytes.data(), sizeof value);
    }
  }
  template <class Number>
  Number number() {
    Number value{};
    number(value);
    return value;
  }
  template <class T>
  void span(Span<const T>& values) {
    const auto count = number<std::uint32_t>();
    if (count > in_.size()) {  // each element has at least one byte
      throw ByteError("found a length of " + std::to_string(count) + ", allowed: at most " +
                      std::to_string(in_.size()) + ", the bytes that are left");
    }
    SWARMANOID_EXPECTS(parts_ != nullptr);
    T* first = parts_->room<T>(count);
    for (std::size_t i = 0; i < count; ++i) {
      all(*this, first[i]);
    }
    values = Span<const T>(first, count);
  }
  std::string text() {
    const Span<const std::uint8_t> bytes = take(number<std::uint32_t>());
    return {bytes.begin(), bytes.end()};
  }
  /// Returns a block as a reader of its own.
  ByteReader block() { return ByteReader(take(number<std::uint32_t>())); }
  std::size_t left() const { return in_.size(); }

  /// Sets where the elements of spans are stored from now on. @pre set before a span is read
  void keepVariablePartsIn(VariableParts& parts) { parts_ = &parts; }

 private:
  Span<const std::uint8_t> take(std::size_t count) {
    if (count > in_.size()) {
      throw ByteError("found " + std::to_string(in_.size()) + " bytes, expected at least " + std::to_string(count));
    }
    const Span<const std::uint8_t> taken = in_.subspan(0, count);
    in_ = in_.subspan(count, in_.size() - count);
    return taken;
  }

  Span<const std::uint8_t> in_;
  VariableParts* parts_ = nullptr;
};

/// Writes the layout of the fields as text: "f8 f8 u1", spans as "(f4 f4)*".
class LayoutWriter {
 public:
  /// Adds a field of a device.
  template <class Value>
  void operator()(Value& value, const FieldInfo& /*info*/) {
    all(*this, value);
  }
  template <class Number>
  void number(Number) {
    separate();
    text_ += detail::numberType<Number>();
  }
  template <class T>
  void span(const Span<const T>&) {
    T element{};
    LayoutWriter inner;
    all(inner, element);
    separate();
    text_ += "(" + inner.text() + ")*";
  }
  const std::string& text() const { return text_; }

 private:
  void separate() { text_ += text_.empty() ? "" : " "; }

  std::string text_;
};

namespace detail {

template <class Stream, class Value>
void one(Stream& stream, Value& value) {
  if constexpr (std::is_arithmetic_v<Value>) {
    stream.number(value);
  } else if constexpr (std::is_enum_v<Value>) {
    auto number = static_cast<std::underlying_type_t<Value>>(value);
    stream.number(number);
    value = static_cast<Value>(number);
  } else if constexpr (IsArray<Value>::value) {
    for (auto& element : value) {
      one(stream, element);
    }
  } else if constexpr (IsSpan<Value>::value) {
    stream.span(value);
  } else {
    fields(stream, value);
  }
}

}  // namespace detail

template <class Stream, class... Values>
void all(Stream& stream, Values&... values) {
  (detail::one(stream, values), ...);
}

}  // namespace swarmanoid
