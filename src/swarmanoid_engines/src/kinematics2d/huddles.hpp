/// Who may meet whom in a step, of the bodies that do not move freely: those that may are in one huddle.
///
/// Bodies are numbered as they are in a list of all that move, which blocks are stretches of. A huddle lies within a
/// block, or else is open: somebody outside may meet one of it. Threads: each may work on a block of its own.
#pragma once

#include <cstdint>
#include <vector>

namespace swarmanoid::kinematics2d {

class Huddles {
 public:
  void resize(std::size_t count) {
    first_.resize(count);
    is_open_.resize(count);
  }

  /// Each of a stretch is alone.
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
  /// The one that stands for a huddle. Ways to it get shorter each time.
  std::size_t firstOf(std::size_t k) {
    while (first_[k] != k) {
      first_[k] = first_[first_[k]];
      k = first_[k];
    }
    return k;
  }

  std::vector<std::uint32_t> first_;  // of the same huddle, nearer to the one that stands for it; itself if that is it
  std::vector<char> is_open_;         // of those that stand for a huddle
};

}  // namespace swarmanoid::kinematics2d
