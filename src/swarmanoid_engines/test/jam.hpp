/// Crowds under pressure: in a corner, a gate, a ring, against each other.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "exact_overlap.hpp"
#include "turned_frame.hpp"

namespace swarmanoid::jam {

using Eigen::Vector2d;

struct JamCase {
  const char* place;
  int count;
  int subclock;
  /// Target of a robot, in sides of the room. @param index of the robot
  std::function<Vector2d(int index)> target;
};

inline void PrintTo(const JamCase& values, std::ostream* out) {
  *out << values.count << " into a " << values.place << ", " << values.subclock << " steps";
}

inline Vector2d corner(int /*index*/) { return {0.0, 0.0}; }
inline Vector2d gate(int /*index*/) { return {1.0, 0.5}; }
inline Vector2d ring(int /*index*/) { return {0.5, 0.5}; }
inline Vector2d eachOther(int index) { return index % 2 == 0 ? Vector2d(0.0, 0.5) : Vector2d(1.0, 0.5); }

/// Footbots in a room of four walls, which lies along no axis. Each drives towards its target as hard as it can.
/// @tparam World of the tests of an engine
template <class World>
class Jam {
 public:
  /// @param world empty, with an arena of 25 m x 25 m
  Jam(const JamCase& values, World& world)
      : values_(values), room_(std::max(6.0, 0.6 + 0.32 * std::sqrt(values.count))), world_(world) {
    for (const double side : {-0.1, room_ + 0.1}) {
      addWall({0.2, room_ + 0.4}, {side, 0.5 * room_});
      addWall({room_ + 0.4, 0.2}, {0.5 * room_, side});
    }
    const bool has_gate = std::string(values.place) == "gate";
    if (has_gate) {
      addWall({0.1, 0.5 * room_ - 0.15}, {0.5 * room_, 0.25 * room_ - 0.075});
      addWall({0.1, 0.5 * room_ - 0.15}, {0.5 * room_, 0.75 * room_ + 0.075});
    }
    const int per_line = static_cast<int>(std::ceil(std::sqrt(values.count * (has_gate ? 0.45 : 1.0))));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> some(-1.0, 1.0);
    const double distance = std::min(0.4, ((has_gate ? 0.5 : 1.0) * room_ - 0.6) / per_line);
    for (int i = 0; i < values.count; ++i) {
      const Vector2d place =
          Vector2d(0.3 + 0.5 * distance, 0.3 + 0.5 * distance) + distance * Vector2d(i % per_line, i / per_line);
      const Vector2d jitter = (0.5 * distance - 0.12) * Vector2d(some(random), some(random));
      const Vector2d start = place + jitter;
      robots_.push_back(world_.addFootbot(frame_.at(start.x(), start.y(), 3.0 * some(random))));
    }
  }

  void tick() {
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      const Vector2d way = room_ * values_.target(static_cast<int>(i)) - position(robots_[i]);
      const double heading = frame_.heading(world_.pose(robots_[i]));
      const double error = std::remainder(std::atan2(way.y(), way.x()) - heading, 2.0 * M_PI);
      world_.drive(robots_[i], 0.23, 5.0 * std::clamp(error, -1.0, 1.0));
    }
    world_.step();
  }

  /// Depth of the outermost robot's body in a wall [m].
  double deepestInWall() const {
    constexpr double kBody = 0.085;  // m
    double deepest = 0.0;
    for (const Row row : robots_) {
      const Vector2d place = position(row);
      deepest = std::max({deepest, kBody - place.minCoeff(), place.maxCoeff() + kBody - room_});
    }
    return deepest;
  }
  double deepestInEachOther() const { return deepestOverlap(world_.space, robots_); }
  /// Distance between the axes of the two nearest robots [m].
  double nearestPair() const {
    double nearest = HUGE_VAL;
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        nearest = std::min(nearest, (position(robots_[i]) - position(robots_[k])).norm());
      }
    }
    return nearest;
  }

 private:
  Vector2d position(Row row) const {
    const Eigen::Vector3d place = frame_.back(world_.pose(row).position);
    return place.head<2>();
  }
  void addWall(const Vector2d& size, const Vector2d& centre) {
    world_.add(blockModel({size.x(), size.y(), 0.5}), frame_.at(centre.x(), centre.y(), 0.0, 0.25));
  }

  JamCase values_;
  double room_;  ///< its sides [m]
  TurnedFrame frame_{0.37, {8.0, 6.0, 0.0}};
  World& world_;
  std::vector<Row> robots_;
};

/// The deepest overlaps during a run [m].
struct Depths {
  double in_wall = 0.0;
  double in_others = 0.0;
  double nearest = HUGE_VAL;  ///< least distance of two robots' axes
};

template <class World>
Depths press(const JamCase& values, World& world, int ticks = 300) {
  Jam<World> jam(values, world);
  Depths depths;
  for (int i = 0; i < ticks; ++i) {
    jam.tick();
    if (i % 10 == 9) {
      depths.in_wall = std::max(depths.in_wall, jam.deepestInWall());
      depths.in_others = std::max(depths.in_others, jam.deepestInEachOther());
      depths.nearest = std::min(depths.nearest, jam.nearestPair());
    }
  }
  return depths;
}

/// Expects that robots have touched, and that none was deeper than this in a wall or in another one [m].
inline void expectDepths(const Depths& depths, double in_wall, double in_others) {
  EXPECT_LT(depths.in_wall, in_wall);
  EXPECT_LT(depths.in_others, in_others);
  EXPECT_LT(depths.nearest, 0.2)
      << "they do not press: two bodies that touch are 0.17 m apart, at the start over 0.23 m";
}

}  // namespace swarmanoid::jam
