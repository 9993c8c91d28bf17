/// The part of a line between two points after clipping to solids. Inline: rays spend most of their time here.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace swarmanoid {

/// A part of the line start + t * step, from one fraction t to another. Initially the part between the two points.
struct LinePart {
  double from = 0.0;
  double to = 1.0;

  /// The whole line, including the parts beyond both points.
  static LinePart whole() {
    constexpr double kEnd = std::numeric_limits<double>::infinity();
    return {-kEnd, kEnd};
  }

  bool isEmpty() const { return from > to; }
  void clear() {
    from = std::numeric_limits<double>::infinity();
    to = -from;
  }
  void clip(double low, double high) {
    from = std::max(from, low);
    to = std::min(to, high);
  }

  /// Clips to the part in which one coordinate is from `low` to `high`.
  void clipToSlab(double start, double step, double low, double high) {
    if (step == 0.0) {
      if (start < low || start > high) {
        clear();
      }
      return;
    }
    const double a = (low - start) / step;
    const double b = (high - start) / step;
    clip(std::min(a, b), std::max(a, b));
  }

  /// Clips to the part within `radius` of the origin, in as many dimensions as the vectors have.
  template <class Vector>
  void clipToRound(const Vector& start, const Vector& step, double radius) {
    const double a = step.squaredNorm();
    const double b = start.dot(step);
    const double c = start.squaredNorm() - radius * radius;
    if (a == 0.0) {
      if (c > 0.0) {
        clear();
      }
      return;
    }
    const double discriminant = b * b - a * c;
    if (discriminant < 0.0) {
      clear();
      return;
    }
    const double root = std::sqrt(discriminant);
    clip((-b - root) / a, (-b + root) / a);
  }
};

}  // namespace swarmanoid
