// The formulas of docs/reference/models.md, "Gripping" and "Ropes".
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "model_world.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"

namespace swarmanoid::test {
namespace {

const char* const kEngines[] = {"kinematics2d", "dynamics2d", "dynamics3d"};

std::string subclockOf(const std::string& engine) { return engine == "dynamics3d" ? "<subclock>10</subclock>" : ""; }

/// Position in W of a point ahead and to the left of a footbot at (5, 5) with a heading of 63 degrees.
Eigen::Vector2d fromFootbot(double ahead, double left) {
  const double cosine = std::cos(63.0 * kDegree);
  const double sine = std::sin(63.0 * kDegree);
  return {5.0 + ahead * cosine - left * sine, 5.0 + ahead * sine + left * cosine};
}

struct Strip {
  Eigen::Vector2d place;  ///< of a prey's axis, ahead and left of the footbot [m]
  double radius;
  double height;
};

/// Number of the prey that a footbot holds one tick after it closes its gripper; 0: none.
int grippedOf(const std::string& engine, const std::vector<Strip>& preys) {
  ModelWorld world;
  world.engine = engine;
  world.engine_parameters = subclockOf(engine);
  world.entities = robot("footbot", "fb", 5.0, 5.0, 0.0, 63.0);
  world.members = "fb";
  for (const Strip& strip : preys) {
    const Eigen::Vector2d at = fromFootbot(strip.place.x(), strip.place.y());
    const std::string id = join("p_", &strip - preys.data() + 1);
    world.entities += prey(id, at.x(), at.y(), strip.radius, strip.height);
    world.members += " " + id;
  }
  setProgram([](Robot& robot) { robot.actuator<FootbotGripper>().closed = true; });
  auto simulation = world.start();
  tick(*simulation);
  const Space& space = simulation->space();
  const Row gripped = space.structure.grippedBy(space.entities.find("fb"));
  return gripped == kNoRow ? 0 : std::stoi(space.entities.name[gripped].substr(2));
}

TEST(ModelsPageTest, GripperReach) {
  const auto aside = [](double gap, double radius) {
    // from the tip, 0.11 m ahead, at 50 degrees to the left
    const double way = radius + gap;
    return Eigen::Vector2d(0.11 + way * std::cos(50.0 * kDegree), way * std::sin(50.0 * kDegree));
  };
  for (const char* engine : kEngines) {
    for (const double gap : {0.0198, 0.0202}) {
      const int expected = gap < 0.02 ? 1 : 0;
      EXPECT_EQ(grippedOf(engine, {{{0.11 + 0.07 + gap, 0.0}, 0.07, 0.1}}), expected) << engine << ", " << gap;
      EXPECT_EQ(grippedOf(engine, {{aside(gap, 0.053), 0.053, 0.1}}), expected) << engine << ", aside, " << gap;
    }
    EXPECT_EQ(grippedOf(engine, {{{0.19, 0.0}, 0.07, 0.0502}}), 1) << engine << ": as high as the tip, 0.05 m";
    EXPECT_EQ(grippedOf(engine, {{{0.19, 0.0}, 0.07, 0.0498}}), 0) << engine;
    const Strip near{aside(0.013, 0.031), 0.031, 0.1};
    const Eigen::Vector2d mirrored = aside(0.017, 0.041);
    const Strip farther{{mirrored.x(), -mirrored.y()}, 0.041, 0.1};
    EXPECT_EQ(grippedOf(engine, {near, farther}), 1) << engine;
    EXPECT_EQ(grippedOf(engine, {farther, near}), 2) << engine << ": the nearest strip";
  }
}

TEST(ModelsPageTest, GripTiming) {
  for (const char* engine : {"kinematics2d", "dynamics2d"}) {
    const Eigen::Vector2d at = fromFootbot(0.11 + 0.06 + 0.004, 0.0);
    ModelWorld world;
    world.engine = engine;
    world.engine_parameters = "<subclock>5</subclock>";
    world.entities = robot("footbot", "fb", 5.0, 5.0, 0.0, 63.0) + prey("p", at.x(), at.y(), 0.06, 0.1);
    world.members = "fb p";
    int number = 0;
    setProgram([&](Robot& robot) {
      ++number;
      robot.actuator<FootbotWheels>().drive(-0.09, 0.0);
      robot.actuator<FootbotGripper>().closed = number < 8;
    });
    auto simulation = world.start();
    const auto moved = [&] {
      const Eigen::Vector3d before = poseOf(*simulation, "p").position;
      tick(*simulation);
      return (poseOf(*simulation, "p").position - before).norm();
    };
    const auto is_held = [&] {
      const Space& space = simulation->space();
      return space.structure.grippedBy(space.entities.find("fb")) != kNoRow;
    };
    EXPECT_EQ(moved(), 0.0) << engine << ": commanded to close, it has moved without the prey";
    EXPECT_TRUE(is_held()) << engine << ": and holds it at the end of the tick";
    for (int i = 2; i <= 8; ++i) {
      EXPECT_NEAR(moved(), 0.009, i == 2 ? 5e-3 : 1e-5) << engine << ", tick " << i;
    }
    EXPECT_FALSE(is_held()) << engine << ": commanded to open in tick 8, it has moved with the prey";
    EXPECT_LT(moved(), 2e-3) << engine << ": which then slides at most";
  }
}

TEST(ModelsPageTest, TurretWithoutLoad) {
  for (const char* engine : kEngines) {
    ModelWorld world;
    world.engine = engine;
    world.engine_parameters = subclockOf(engine);
    world.footbot_actuators += "<footbot_turret/>";
    world.entities = robot("footbot", "fb", 5.0, 5.0, 0.0, 63.0);
    world.members = "fb";
    double commanded = 2.3;
    setProgram([&](Robot& robot) { robot.actuator<FootbotTurret>().holdAngle(commanded); });
    auto simulation = world.start();
    const auto angle = [&] { return simulation->space().joints[simulation->space().entities.find("fb")][0].angle; };
    for (int n = 1; n <= 10; ++n) {
      tick(*simulation);
      EXPECT_NEAR(angle(), std::min(0.3 * n, commanded), 1e-9) << engine << ", tick " << n;
    }
    commanded = -2.9;  // the shorter way crosses pi
    tick(*simulation, 2);
    EXPECT_NEAR(angle(), 2.3 + 0.6, 1e-9) << engine;
    tick(*simulation);
    EXPECT_NEAR(angle(), 2.3 + 0.9 - 2.0 * M_PI, 1e-9) << engine;
  }
}

TEST(ModelsPageTest, RopeShotAndWinding) {
  const double way = 2.47 - 0.29;  // from the launcher, 0.29 m above the ground, to the lower face of the roof
  ModelWorld world;
  world.engine = "dynamics3d";
  world.engine_parameters = "<subclock>10</subclock>";
  world.clocktick = 30;
  world.entities = robot("handbot", "hb", 5.0, 5.0, 0.0, 63.0) +
                   block("roof", 5.0, 5.0, 2.57, "1,1,0.2", 0.0, "<ferromagnetic>true</ferromagnetic>");
  world.members = "hb roof";
  int number = 0;
  HandbotRopeState state;
  setProgram([&](Robot& robot) {
    state = robot.sensor<HandbotRopeState>();
    auto& rope = robot.actuator<HandbotRope>();
    rope.shot = true;
    rope.winding_speed = number >= 20 ? 0.07 : 0.0;
    ++number;
  });
  auto simulation = world.start();
  const auto hit = static_cast<int>(std::ceil(way / (10.0 * 0.03)));
  tick(*simulation, hit);
  EXPECT_FALSE(state.attached) << "as of the tick before";
  tick(*simulation);
  EXPECT_TRUE(state.attached);
  EXPECT_NEAR(state.length, way, 1e-4);
  tick(*simulation, 31 - number);
  // commanded from tick 20 on, and read in tick 30: the state after ten ticks
  EXPECT_NEAR(state.length, way - 0.07 * 0.03 * 10, 1e-4);
}

}  // namespace
}  // namespace swarmanoid::test
