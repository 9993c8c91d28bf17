/// Saves the state of objects as bytes, and loads it into objects that were made in the same way: the basis of
/// snapshots of a run.
///
/// A class has one function for both directions, so that it loads what it saves:
///
///     void archive(StateArchive& state) override { state(phase_, ticks_left_, last_position_); }
///
/// It names every member that changes after the object was made and that later results depend on. Members that follow
/// from the configuration, references to devices, and memory that each tick fills anew are left out.
///
/// Values   numbers, truth values, enumerations, texts, times, matrices of fixed size, structs of numbers and such
///          matrices, containers of the standard library, and classes that have such a function themselves. Structs
///          without the function are copied as bytes: they must have no pointers.
/// Bytes    those of this process and this machine; not a format of files.
/// Errors   `refuse` throws a StateNotDefined; loading more than was saved throws a std::runtime_error.
/// Threads  one for each object.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <deque>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "swarmanoid_interface/span.hpp"

namespace swarmanoid {

/// An object does not define its state.
class StateNotDefined : public std::runtime_error {
 public:
  StateNotDefined() : std::runtime_error("does not define its state (StateArchive)") {}
};

class StateArchive {
  template <class Value, class = void>
  struct HasArchive : std::false_type {};
  template <class Value>
  struct HasArchive<Value, std::void_t<decltype(std::declval<Value&>().archive(std::declval<StateArchive&>()))>>
      : std::true_type {};

  template <class Value, class = void>
  struct DeclaresArchive : std::false_type {};
  template <class Value>
  struct DeclaresArchive<Value, std::enable_if_t<HasArchive<Value>::value>>
      : std::is_same<decltype(&Value::archive), void (Value::*)(StateArchive&)> {};

 public:
  /// An archive that saves: values are appended to `bytes`, which outlives it.
  explicit StateArchive(std::vector<std::byte>& bytes) : saved_(&bytes) {}
  /// An archive that loads values in the order in which they were saved. @param bytes outlive it
  explicit StateArchive(Span<const std::byte> bytes) : rest_(bytes) {}

  bool isLoading() const { return saved_ == nullptr; }
  /// Whether all saved bytes were loaded.
  bool isAtEnd() const { return rest_.empty(); }

  /// Saves or loads values, in their order.
  template <class... Values>
  void operator()(Values&... values) {
    (value(values), ...);
  }

  /// Saves or loads plain memory, such as a struct without pointers. @param size [byte]
  void bytes(void* memory, std::size_t size) {
    if (size == 0) {
      return;
    }
    if (saved_ != nullptr) {
      const auto* const first = static_cast<const std::byte*>(memory);
      saved_->insert(saved_->end(), first, first + size);
      return;
    }
    if (rest_.size() < size) {
      throw std::runtime_error("a snapshot has less state than it should have");
    }
    std::memcpy(memory, rest_.data(), size);
    rest_ = rest_.subspan(size, rest_.size() - size);
  }

  /// Whether a class has the function `archive`.
  template <class Value>
  static constexpr bool kIsDefinedBy = HasArchive<Value>::value;

  /// Whether a class itself, and not only a base, has it.
  template <class Value>
  static constexpr bool kIsDeclaredBy = DeclaresArchive<Value>::value;

  /// For classes that do not define their state. @throws StateNotDefined
  [[noreturn]] static void refuse() { throw StateNotDefined(); }

 private:
  template <class Value>
  void value(Value& value) {
    static_assert(!std::is_pointer_v<Value>, "a pointer is not state: archive what identifies its object");
    static_assert(!std::is_const_v<Value>, "a constant is not state");
    if constexpr (HasArchive<Value>::value) {
      value.archive(*this);
    } else {
      // matrices of Eigen can be copied as bytes, although they have constructors
      static_assert(std::is_trivially_destructible_v<Value> && !std::is_polymorphic_v<Value>,
                    "the class needs a function archive(StateArchive&)");
      bytes(&value, sizeof(value));
    }
  }
  void value(std::string& text) {
    size(text);
    bytes(text.data(), text.size());
  }
  template <class Value>
  void value(std::vector<Value>& values) {
    size(values);
    each(values);
  }
  template <class Value>
  void value(std::deque<Value>& values) {
    size(values);
    each(values);
  }
  void value(std::vector<bool>& values) {
    size(values);
    for (auto&& one : values) {
      bool truth = one;
      (*this)(truth);
      one = truth;
    }
  }
  template <class Value, std::size_t kCount>
  void value(std::array<Value, kCount>& values) {
    each(values);
  }
  template <class Value>
  void value(std::optional<Value>& optional) {
    bool has_value = optional.has_value();
    (*this)(has_value);
    if (!has_value) {
      optional.reset();
      return;
    }
    if (!optional) {
      optional.emplace();
    }
    (*this)(*optional);
  }
  template <class First, class Second>
  void value(std::pair<First, Second>& pair) {
    (*this)(pair.first, pair.second);
  }
  template <class Key, class Value>
  void value(std::map<Key, Value>& map) {
    std::size_t count = map.size();
    (*this)(count);
    if (!isLoading()) {
      for (auto& [key, mapped] : map) {
        Key copy = key;
        (*this)(copy, mapped);
      }
      return;
    }
    map.clear();
    for (std::size_t i = 0; i < count; ++i) {
      std::pair<Key, Value> entry;
      (*this)(entry);
      map.insert(std::move(entry));
    }
  }

  template <class Container>
  void size(Container& container) {
    std::size_t count = container.size();
    (*this)(count);
    if (count != container.size()) {
      container.resize(count);
    }
  }
  template <class Container>
  void each(Container& container) {
    using Value = typename Container::value_type;
    constexpr bool kIsContiguous = !std::is_same_v<Container, std::deque<Value>>;
    if constexpr (kIsContiguous && (std::is_arithmetic_v<Value> || std::is_same_v<Value, std::byte>)) {
      bytes(container.data(), container.size() * sizeof(Value));
    } else {
      for (Value& one : container) {
        (*this)(one);
      }
    }
  }

  std::vector<std::byte>* saved_ = nullptr;  // null: the archive loads
  Span<const std::byte> rest_;               // to be loaded
};

}  // namespace swarmanoid
