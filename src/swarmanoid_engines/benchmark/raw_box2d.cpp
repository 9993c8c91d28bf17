#include "raw_box2d.hpp"

#include <cmath>

namespace swarmanoid::benchmarks {
namespace {

constexpr double kUnitsPerMetre = 8.0;
// a footbot's, as its URDF has them [m]
constexpr double kRadius = 0.085;
constexpr double kGripperMiddle = 0.09;
constexpr double kGripperHalf = 0.02;

float units(double metres) { return static_cast<float>(kUnitsPerMetre * metres); }
b2Vec2 units(double x, double y) { return {units(x), units(y)}; }

}  // namespace

RawBox2d::RawBox2d(const Space& space, const std::vector<Row>& robots, double side, RawRobot kind) {
  world_.SetAllowSleeping(false);
  world_.SetContinuousPhysics(false);
  addWalls(side);
  b2CircleShape disc;
  disc.m_radius = units(kRadius);
  b2PolygonShape box;
  box.SetAsBox(units(kGripperHalf), units(kGripperHalf), units(kGripperMiddle, 0.0), 0.0F);
  for (const Row row : robots) {
    const Pose& pose = space.entities.pose[row];
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = units(pose.position.x(), pose.position.y());
    definition.angle = static_cast<float>(2.0 * std::atan2(pose.orientation.z(), pose.orientation.w()));
    b2Body* body = world_.CreateBody(&definition);
    body->CreateFixture(&disc, 1.0F);
    if (kind == RawRobot::kDiscAndBox) {
      body->CreateFixture(&box, 0.0F);
    }
    bodies_.push_back(body);
  }
}

void RawBox2d::addWalls(double side) {
  const b2BodyDef standing;
  b2Body* walls = world_.CreateBody(&standing);
  for (const bool is_upright : {false, true}) {
    for (const double at : {0.0, side}) {
      b2EdgeShape wall;
      wall.SetTwoSided(is_upright ? units(at, 0.0) : units(0.0, at), is_upright ? units(at, side) : units(side, at));
      walls->CreateFixture(&wall, 0.0F);
    }
  }
}

void RawBox2d::setVelocities(const Space& space, const std::vector<Row>& robots) {
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const Twist& twist = space.entities.twist[robots[i]];
    bodies_[i]->SetLinearVelocity(units(twist.linear.x(), twist.linear.y()));
    bodies_[i]->SetAngularVelocity(static_cast<float>(twist.angular.z()));
  }
}

}  // namespace swarmanoid::benchmarks
