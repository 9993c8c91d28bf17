/// Search for the free part of a way or a turn.
#pragma once

namespace swarmanoid::kinematics2d {

/// Goes from 0 towards 1 by a half, a quarter, and so on; `try_part(part)` moves there if that part is free, and
/// returns whether it did. A way of 3 cm ends within 1 mm of the contact.
template <class TryPart>
void tryParts(TryPart try_part) {
  constexpr int kHalvings = 5;
  double done = 0.0;
  double part = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    part *= 0.5;
    if (try_part(done + part)) {
      done += part;
    }
  }
}

}  // namespace swarmanoid::kinematics2d
