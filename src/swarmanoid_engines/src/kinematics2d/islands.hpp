/// Islands: groups of bodies that may meet in a step, among those that do not move freely.
///
/// Bodies are numbered by their position in the list of all moving bodies; blocks are ranges of it. An island lies
/// within a block, or it is open: bodies outside the block may meet one of its bodies. Threads: each may work on a
/// block of its own.
#pragma once

#include <cstdint>
#include <vector>

namespace swarmanoid::kinematics2d {

class Islands {
 public:
  void resize(std::size_t count) {
    first_.resize(count);
    is_open_.resize(count);
  }

  /// Makes each body of a range an island of its own.
  void part(std::size_t first, std::size_t last, bool are_open) {
    for (std::size_t k = first; k < last; ++k) {
      first_[k] = static_cast<std::uint32_t>(k);
      is_open_[k] = are_open ? 1 : 0;
    }
  }
  void join(std::size_t a, std::size_t b) {
    const std::size_t first_of_a = firstOf(a);
    const std::size_t first_of_b = firstOf(b);
    is_open_[first_of_b] |= is_open_[first_of_a];
    first_[first_of_a] = static_cast<std::uint32_t>(first_of_b);
  }
  void open(std::size_t k) { is_open_[firstOf(k)] = 1; }
  bool isOpen(std::size_t k) { return is_open_[firstOf(k)] != 0; }

 private:
  /// Root of the body's island (union-find). Each call shortens the paths.
  std::size_t firstOf(std::size_t k) {
    while (first_[k] != k) {
      first_[k] = first_[first_[k]];
      k = first_[k];
    }
    return k;
  }

  std::vector<std::uint32_t> first_;  // parent in the union-find forest; a root is its own parent
  std::vector<char> is_open_;         // valid for roots
};

}  // namespace swarmanoid::kinematics2d
