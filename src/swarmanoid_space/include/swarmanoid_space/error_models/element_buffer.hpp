/// A byte copy of the elements of a span.
///
/// Threads  one at a time: the object belongs to the state of one robot's device. It allocates only for a copy that is
///          larger than all previous ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "swarmanoid_interface/span.hpp"
#include "swarmanoid_interface/state_archive.hpp"

namespace swarmanoid {

class ElementBuffer {
 public:
  /// Reserves memory for a number of bytes.
  void reserve(std::size_t bytes) { words_.resize(wordsOf(bytes)); }

  /// Copies elements.
  /// @param elements as bytes; may be those of this object @param size of an element [byte] @pre size > 0
  void assign(Span<const std::byte> elements, std::size_t size) {
    if (words_.size() < wordsOf(elements.size())) {
      reserve(elements.size());
    }
    if (!elements.empty()) {
      std::memmove(words_.data(), elements.data(), elements.size());
    }
    count_ = elements.size() / size;
    size_ = elements.size();
  }

  std::byte* bytes() { return reinterpret_cast<std::byte*>(words_.data()); }
  Span<const std::byte> all() const { return {reinterpret_cast<const std::byte*>(words_.data()), size_}; }
  std::size_t count() const { return count_; }

  void archive(StateArchive& state) { state(words_, size_, count_); }

 private:
  static std::size_t wordsOf(std::size_t bytes) { return (bytes + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t); }

  std::vector<std::uint64_t> words_;  // for the alignment of elements
  std::size_t size_ = 0;              // in use [byte]
  std::size_t count_ = 0;
};

}  // namespace swarmanoid
