/// Diffusion as the shortest possible program: discs in arrays, one grid, no space, no devices, no controllers. A
/// reference for the speed of a simulator.
///
/// The same as in the experiment: 24 rays of 10 cm from each disc, read by the law of proximity sensors; straight on if
/// no obstacle is ahead, else turning away; no overlaps. Only discs, the arena's walls, ticks of 100 ms, metres.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace swarmanoid {

class BareDiffusion {
 public:
  BareDiffusion(int robots, double area_per_robot)
      : side_(std::sqrt(robots * area_per_robot)), per_axis_(std::max(1, static_cast<int>(side_ / kCell))) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(0.15, side_ - 0.15);
    std::uniform_real_distribution<double> angle(-M_PI, M_PI);
    for (int k = 0; k < kRays; ++k) {
      const double at = 2.0 * M_PI * (k <= kRays / 2 ? k : k - kRays) / kRays;
      rays_[static_cast<std::size_t>(k)] = {std::cos(at), std::sin(at), std::abs(at) <= 1.5};
    }
    for (int i = 0; i < robots; ++i) {
      Disc disc;
      do {
        disc.x = place(random);
        disc.y = place(random);
      } while (
          std::any_of(discs_.begin(), discs_.end(), [&](const Disc& other) { return areOverlapping(disc, other); }));
      disc.heading = angle(random);
      disc.cosine = std::cos(disc.heading);
      disc.sine = std::sin(disc.heading);
      discs_.push_back(disc);
    }
  }

  void tick() {
    sortIn();
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      control(i);
    }
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      move(i);
    }
  }

 private:
  static constexpr int kRays = 24;
  static constexpr double kRadius = 0.085;
  static constexpr double kRange = 0.1;
  static constexpr double kCell = 0.4;  // maximum distance at which moving discs detect or touch each other
  static constexpr double kTick = 0.1;
  static constexpr double kSpeed = 0.1;
  static constexpr double kTurnRate = 1.5;
  static constexpr double kThreshold = 0.05;

  struct Disc {
    double x = 0.0;
    double y = 0.0;
    double heading = 0.0;
    double cosine = 1.0;
    double sine = 0.0;
    double turn_rate = 0.0;
  };
  struct Ray {
    double x = 0.0;
    double y = 0.0;
    bool is_ahead = false;
  };

  static bool areOverlapping(const Disc& one, const Disc& other) {
    const double x = one.x - other.x;
    const double y = one.y - other.y;
    return x * x + y * y < 4.0 * kRadius * kRadius;
  }
  int cellOf(double coordinate) const { return std::clamp(static_cast<int>(coordinate / kCell), 0, per_axis_ - 1); }

  void sortIn() {
    first_.assign(static_cast<std::size_t>(per_axis_) * static_cast<std::size_t>(per_axis_) + 1, 0);
    cell_.resize(discs_.size());
    items_.resize(discs_.size());
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      cell_[i] = static_cast<std::size_t>(cellOf(discs_[i].y) * per_axis_ + cellOf(discs_[i].x));
      ++first_[cell_[i]];
    }
    std::size_t sum = 0;
    for (std::size_t& first : first_) {
      sum += first;
      first = sum;
    }
    for (std::size_t i = discs_.size(); i-- > 0;) {
      items_[--first_[cell_[i]]] = i;
    }
  }

  template <class Visit>
  void visitOthers(std::size_t i, Visit visit) const {
    const int column = cellOf(discs_[i].x);
    const int line = cellOf(discs_[i].y);
    const int left = std::max(column - 1, 0);
    const int right = std::min(column + 1, per_axis_ - 1);
    for (int y = std::max(line - 1, 0); y <= std::min(line + 1, per_axis_ - 1); ++y) {
      const std::size_t last = first_[static_cast<std::size_t>(y * per_axis_ + right) + 1];
      for (std::size_t k = first_[static_cast<std::size_t>(y * per_axis_ + left)]; k < last; ++k) {
        if (items_[k] != i) {
          visit(discs_[items_[k]]);
        }
      }
    }
  }

  void control(std::size_t i) {
    Disc& disc = discs_[i];
    std::array<double, kRays> way;  // distance to the hit of each ray
    way.fill(kRange);
    bool is_near = false;
    visitOthers(i, [&](const Disc& other) {
      const double x = other.x - disc.x;
      const double y = other.y - disc.y;
      constexpr double kReach = 2.0 * kRadius + kRange;
      if (x * x + y * y < kReach * kReach) {
        is_near = true;
        meetDisc(disc.cosine * x + disc.sine * y, disc.cosine * y - disc.sine * x, way);
      }
    });
    constexpr double kToWall = kRadius + kRange;
    if (std::min({disc.x, disc.y, side_ - disc.x, side_ - disc.y}) < kToWall) {
      is_near = true;
      meetWalls(disc, way);
    }
    double x = 0.0;
    double y = 0.0;
    for (std::size_t k = 0; is_near && k < kRays; ++k) {
      const double closeness = 1.0 - way[k] / kRange;
      const double value = rays_[k].is_ahead ? closeness * closeness * closeness : 0.0;
      x += value * rays_[k].x;
      y += value * rays_[k].y;
    }
    if (x * x + y * y <= kThreshold * kThreshold) {
      disc.turn_rate = 0.0;
    } else if (disc.turn_rate == 0.0) {
      disc.turn_rate = y > 0.0 ? -kTurnRate : kTurnRate;
    }
  }

  /// @param x, y of the other disc's centre in the frame of the disc that senses
  void meetDisc(double x, double y, std::array<double, kRays>& way) const {
    for (std::size_t k = 0; k < kRays; ++k) {
      const double along = x * rays_[k].x + y * rays_[k].y;
      const double across = x * rays_[k].y - y * rays_[k].x;
      const double inside = kRadius * kRadius - across * across;
      if (along > 0.0 && inside > 0.0) {
        way[k] = std::min(way[k], std::max(0.0, along - std::sqrt(inside) - kRadius));
      }
    }
  }

  void meetWalls(const Disc& disc, std::array<double, kRays>& way) const {
    for (std::size_t k = 0; k < kRays; ++k) {
      const double x = disc.cosine * rays_[k].x - disc.sine * rays_[k].y;
      const double y = disc.sine * rays_[k].x + disc.cosine * rays_[k].y;
      const double to_x = ((x > 0.0 ? side_ : 0.0) - disc.x) / x;
      const double to_y = ((y > 0.0 ? side_ : 0.0) - disc.y) / y;
      way[k] = std::min(way[k], std::max(0.0, std::min(to_x, to_y) - kRadius));
    }
  }

  void move(std::size_t i) {
    Disc& disc = discs_[i];
    if (disc.turn_rate != 0.0) {
      disc.heading = std::remainder(disc.heading + disc.turn_rate * kTick, 2.0 * M_PI);
      disc.cosine = std::cos(disc.heading);
      disc.sine = std::sin(disc.heading);
      return;
    }
    Disc there = disc;
    there.x += kTick * kSpeed * disc.cosine;
    there.y += kTick * kSpeed * disc.sine;
    bool is_free = std::min({there.x, there.y, side_ - there.x, side_ - there.y}) >= kRadius;
    visitOthers(i, [&](const Disc& other) { is_free = is_free && !areOverlapping(there, other); });
    if (is_free) {
      disc = there;
    }
  }

  double side_;
  int per_axis_;
  std::array<Ray, kRays> rays_;
  std::vector<Disc> discs_;
  std::vector<std::size_t> first_;  // by cell
  std::vector<std::size_t> cell_;   // by disc
  std::vector<std::size_t> items_;  // discs by cell
};

}  // namespace swarmanoid
