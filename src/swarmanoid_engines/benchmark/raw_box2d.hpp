/// Box2D alone, in its leanest use for a swarm: the reference for engines based on it.
///
/// Robots are one disc, or a disc and a box, in 8 units a metre (Box2D's slop is 0.6 mm then), between four walls,
/// created at their places. Only their velocities are set, once a tick: no forces, no friction with the ground, no
/// filter, no times of impact.
#pragma once

#include <box2d/box2d.h>

#include <vector>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid::benchmarks {

enum class RawRobot { kDisc, kDiscAndBox };

class RawBox2d {
 public:
  /// Makes a body for each of these entities, which are robots. @param side of the square arena [m]
  RawBox2d(const Space& space, const std::vector<Row>& robots, double side, RawRobot kind);

  /// Sets the velocity of every robot to that in the space.
  void setVelocities(const Space& space, const std::vector<Row>& robots);

  /// @param tick [s]
  void step(double tick, int steps) {
    for (int i = 0; i < steps; ++i) {
      world_.Step(static_cast<float>(tick / steps), 8, 3);
    }
  }

 private:
  void addWalls(double side);

  b2World world_{b2Vec2(0.0F, 0.0F)};
  std::vector<b2Body*> bodies_;
};

}  // namespace swarmanoid::benchmarks
