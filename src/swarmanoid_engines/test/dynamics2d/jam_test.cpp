// Crowds that press: into a corner, through a gate, into a ring, against each other. No robot leaves the room, none is
// deep in another.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "../turned_frame.hpp"
#include "exact_overlap.hpp"

namespace swarmanoid::dynamics2d {
namespace {

using Eigen::Vector2d;

constexpr double kRoom = 6.0;       // m
constexpr double kPromised = 6e-4;  // m: what the pages promise

struct JamCase {
  const char* place;
  int count;
  int subclock;
  /// Where a robot drives. @param index of the robot
  std::function<Vector2d(int index)> target;
};

void PrintTo(const JamCase& values, std::ostream* out) {
  *out << values.count << " into a " << values.place << ", " << values.subclock << " steps";
}

/// Footbots in a room of four walls, which lies along no axis. Each drives towards its target as hard as it can.
class Jam {
 public:
  explicit Jam(const JamCase& values) : values_(values), world_({20.0, 20.0, 2.0}, values.subclock) {
    for (const double side : {-0.1, kRoom + 0.1}) {
      addWall({0.2, kRoom + 0.4}, {side, 0.5 * kRoom});
      addWall({kRoom + 0.4, 0.2}, {0.5 * kRoom, side});
    }
    const bool has_gate = std::string(values.place) == "gate";
    if (has_gate) {
      addWall({0.1, 0.5 * kRoom - 0.15}, {3.0, 0.25 * kRoom - 0.075});
      addWall({0.1, 0.5 * kRoom - 0.15}, {3.0, 0.75 * kRoom + 0.075});
    }
    const int per_line = static_cast<int>(std::ceil(std::sqrt(values.count * (has_gate ? 0.45 : 1.0))));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> some(-1.0, 1.0);
    const double distance = std::min(0.4, (has_gate ? 2.4 : 5.4) / per_line);
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
      const Vector2d way = values_.target(static_cast<int>(i)) - position(robots_[i]);
      const double heading = frame_.heading(world_.pose(robots_[i]));
      const double error = std::remainder(std::atan2(way.y(), way.x()) - heading, 2.0 * M_PI);
      world_.drive(robots_[i], 0.23, 5.0 * std::clamp(error, -1.0, 1.0));
    }
    world_.step();
  }

  /// How far the outermost robot's body is in a wall [m].
  double deepestInWall() const {
    constexpr double kBody = 0.085;  // m
    double deepest = 0.0;
    for (const Row row : robots_) {
      const Vector2d place = position(row);
      deepest = std::max({deepest, kBody - place.minCoeff(), place.maxCoeff() + kBody - kRoom});
    }
    return deepest;
  }
  double deepestInEachOther() const {
    double deepest = 0.0;
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        if ((position(robots_[i]) - position(robots_[k])).norm() < 0.225) {
          deepest = std::max(deepest, overlapOf(world_, robots_[i], robots_[k]));
        }
      }
    }
    return deepest;
  }

 private:
  Vector2d position(Row row) const { return frame_.back(world_.pose(row).position).head<2>(); }
  void addWall(const Vector2d& size, const Vector2d& centre) {
    world_.add(blockModel({size.x(), size.y(), 0.5}), frame_.at(centre.x(), centre.y(), 0.0, 0.25));
  }

  JamCase values_;
  TurnedFrame frame_{0.37, {8.0, 6.0, 0.0}};
  World world_;
  std::vector<Row> robots_;
};

class JamTest : public testing::TestWithParam<JamCase> {};

TEST_P(JamTest, NoRobotLeavesAndNoneIsDeepInAnother) {
  Jam jam(GetParam());
  double in_wall = 0.0;
  double in_others = 0.0;
  for (int i = 0; i < 300; ++i) {
    jam.tick();
    if (i % 10 == 9) {
      in_wall = std::max(in_wall, jam.deepestInWall());
      in_others = std::max(in_others, jam.deepestInEachOther());
    }
  }
  EXPECT_LT(in_wall, kPromised);
  EXPECT_LT(in_others, kPromised);
  EXPECT_GT(in_others, 1e-6) << "they do not press";
}

Vector2d corner(int /*index*/) { return {0.0, 0.0}; }
Vector2d gate(int /*index*/) { return {6.0, 3.0}; }
Vector2d ring(int /*index*/) { return {3.0, 3.0}; }
Vector2d eachOther(int index) { return index % 2 == 0 ? Vector2d(0.0, 3.0) : Vector2d(6.0, 3.0); }

INSTANTIATE_TEST_SUITE_P(Crowds, JamTest,
                         testing::Values(JamCase{"corner", 20, 1, corner}, JamCase{"corner", 150, 1, corner},
                                         JamCase{"corner", 70, 10, corner}, JamCase{"gate", 60, 4, gate},
                                         JamCase{"ring", 90, 1, ring}, JamCase{"crowd", 120, 1, eachOther}));

}  // namespace
}  // namespace swarmanoid::dynamics2d
