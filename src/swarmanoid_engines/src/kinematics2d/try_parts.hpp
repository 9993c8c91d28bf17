/// How much of a way or of a turn is free.
#pragma once

namespace swarmanoid::kinematics2d {

/// Goes from 0 towards 1 by a half, a quarter, and so on, as far as `try_part(part)` says that it has gone there. A way
/// of 3 cm ends within 1 mm of the contact.
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
