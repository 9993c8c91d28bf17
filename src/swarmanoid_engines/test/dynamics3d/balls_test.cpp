// The balls on which robots with wheels stand: never ahead of the visible body.
#include <gtest/gtest.h>

#include <random>

#include "dynamics3d/collision/balls.hpp"
#include "dynamics3d/collision/solids.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Kind = CollisionShape::Kind;

CollisionShape solid(Kind kind, const Vector3d& half_extent, const Vector3d& position, double heading = 0.0) {
  return {kind, half_extent, position, Eigen::Quaterniond(Eigen::AngleAxisd(heading, Vector3d::UnitZ()))};
}

/// A robot of 1 kg without joints. @param radius of the wheels [m]; @param separation of the wheels [m]
std::shared_ptr<EntityModel> robotOf(std::vector<CollisionShape> shapes, double radius, double separation) {
  auto model = std::make_shared<EntityModel>(*robotModel("footbot"));
  model->shapes = std::move(shapes);
  model->joints.clear();
  model->holders.clear();
  model->gripper.reset();
  model->gripping_radius.reset();
  model->wheels->radius = radius;
  model->wheels->separation = separation;
  model->mass = 1.0;
  model->centre_of_mass = {0.0, 0.0, 0.02};
  model->inertia = Vector3d(1e-3, 1e-3, 1e-3).asDiagonal();
  model->body_part = {model->mass, model->centre_of_mass, model->inertia};
  model->measureShapes();
  return model;
}

std::shared_ptr<EntityModel> ePuck() {
  return robotOf({solid(Kind::kCylinder, {0.035, 0.035, 0.0245}, {0.0, 0.0, 0.0285})}, 0.0205, 0.053);
}

/// The Burger of TurtleBot3: 138 x 178 x 192 mm, axle 37 mm behind its front, a caster 81 mm behind the axle.
std::shared_ptr<EntityModel> turtleBot() {
  return robotOf({solid(Kind::kBox, {0.069, 0.069, 0.0905}, {-0.032, 0.0, 0.1015}),
                  solid(Kind::kSphere, {0.005, 0.005, 0.005}, {-0.081, 0.0, 0.005})},
                 0.033, 0.160);
}

bool covers(const CollisionShape& shape, const Vector2d& point) {
  const Vector3d local = shape.orientation.conjugate() * Vector3d(point.x() - shape.position.x(),  //
                                                                  point.y() - shape.position.y(), 0.0);
  return shape.kind == Kind::kBox ? (local.cwiseAbs() - shape.half_extent).head<2>().maxCoeff() <= 1e-9
                                  : local.head<2>().norm() <= shape.half_extent.x() + 1e-9;
}

TEST(BallsTest, AFootbotHasThoseOfItsTreels) {
  const std::vector<Ball> balls = ballsOf(*robotModel("footbot"));
  ASSERT_EQ(balls.size(), 6U);
  const double ahead[] = {0.0, 0.05075, -0.05075};
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const double y = (i < 3 ? 1.0 : -1.0) * (i % 3 == 0 ? 0.07 : 0.049);
    EXPECT_LT((balls[i].shape.position - Vector3d(ahead[i % 3], y, 0.0087)).norm(), 1e-12) << i;
    EXPECT_EQ(balls[i].side, i < 3 ? 0 : 1);
    EXPECT_EQ(balls[i].is_support, i % 3 != 0);
  }
}

TEST(BallsTest, ASmallBodyHasThemUnderIt) {
  // the ball's circle of 6.15 mm, at y = 18.55 mm, touches the body's of 35 mm from within
  const double expected = std::sqrt(0.02885 * 0.02885 - 0.01855 * 0.01855);
  const std::vector<Ball> balls = ballsOf(*ePuck());
  EXPECT_NEAR(balls[1].shape.position.x(), expected, 1e-12);
  EXPECT_NEAR(balls[5].shape.position.x(), -expected, 1e-12);
}

TEST(BallsTest, TheyReachToACaster) {
  const std::vector<Ball> balls = ballsOf(*turtleBot());
  EXPECT_NEAR(balls[1].shape.position.x(), 0.037 - 0.0099, 1e-9);
  EXPECT_NEAR(balls[2].shape.position.x(), -0.081, 1e-9);
}

TEST(BallsTest, NoneIsSeenFromAboveWhateverTheBody) {
  std::mt19937_64 random(4);  // NOLINT(cert-msc51-cpp): the same in every run
  const auto between = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(random); };
  int out = 0;
  int on_axle = 0;
  for (int i = 0; i < 10000; ++i) {
    std::vector<CollisionShape> shapes;
    const int count = 1 + i % 4;
    for (int k = 0; k < count; ++k) {
      shapes.push_back(solid(k % 2 == 0 ? Kind::kBox : Kind::kCylinder, Vector3d::Constant(between(0.005, 0.15)),
                             {between(-0.1, 0.1), between(-0.05, 0.05), between(0.0, 0.3)}, between(-3.2, 3.2)));
    }
    const auto model = robotOf(shapes, between(0.01, 0.08), between(0.03, 0.3));
    for (const Ball& ball : ballsOf(*model)) {
      if (!ball.is_support) {
        continue;
      }
      if (ball.shape.position.x() == 0.0) {
        ++on_axle;
        continue;
      }
      const auto holds = [&](const CollisionShape& shape) {
        for (int k = 0; k < 16; ++k) {
          const double angle = k * M_PI / 8.0;
          const Vector2d edge = ball.shape.half_extent.x() * Vector2d(std::cos(angle), std::sin(angle));
          if (!covers(shape, ball.shape.position.head<2>() + edge)) {
            return false;
          }
        }
        return true;
      };
      out += std::any_of(model->shapes.begin(), model->shapes.end(), holds) ? 0 : 1;
    }
  }
  EXPECT_EQ(out, 0);
  EXPECT_LT(on_axle, 20000);  // of 40,000: most bodies cover some ground
}

TEST(BallsTest, ARobotStopsWhereItsBodyMeetsTheWall) {
  struct Case {
    std::shared_ptr<EntityModel> model;
    double front;  // m
    double direction;
  };
  for (const Case& test : {Case{ePuck(), 0.035, 1.0}, Case{ePuck(), 0.035, -1.0}, Case{turtleBot(), 0.037, 1.0},
                           Case{turtleBot(), 0.101, -1.0}}) {
    World world({{"subclock", "20"}});
    const double heading = 0.37;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(heading, Vector3d::UnitZ()));
    world.addBlock({0.1, 2.0, 0.5}, 0.0,
                   {Vector3d(5.0, 5.0, 0.25) + turn * Vector3d(test.direction * 0.3, 0.0, 0.0), turn});
    const Row robot = world.addRobot<FootbotWheels>(test.model, flatPose(5.0, 5.0, heading));
    const double speed = test.direction * 0.1 / test.model->wheels->radius;
    world.space.actuation.bank<FootbotWheels>().find(robot)->setAngularVelocity(speed, speed);
    world.step(50);
    const Vector3d way = turn.conjugate() * (world.pose(robot).position - Vector3d(5.0, 5.0, 0.0));
    EXPECT_NEAR(test.direction * way.x(), 0.25 - test.front, 1e-3) << test.front;
    EXPECT_NEAR(way.y(), 0.0, 1e-3) << test.front;
    EXPECT_LT(tiltOf(world.pose(robot)), 0.5 * kDegree) << test.front;
  }
}

TEST(BallsTest, LyingWheelsAndCastersDoNotBrake) {
  const Eigen::Quaterniond lying(Eigen::AngleAxisd(M_PI / 2.0, Vector3d::UnitX()));
  auto model = turtleBot();
  for (const double y : {0.08, -0.08}) {
    model->shapes.push_back({Kind::kCylinder, {0.033, 0.033, 0.009}, {0.0, y, 0.033}, lying});
  }
  model->measureShapes();
  World world({{"subclock", "10"}});
  const Row robot = world.addRobot<FootbotWheels>(model, flatPose(2.0, 3.0, -0.9));
  world.space.actuation.bank<FootbotWheels>().find(robot)->setAngularVelocity(0.17 / 0.033, 0.17 / 0.033);
  world.step(100);
  EXPECT_NEAR((world.pose(robot).position - Vector3d(2.0, 3.0, 0.0)).norm(), 1.7, 8e-3);
  EXPECT_NEAR(headingOf(world.pose(robot)), -0.9, 0.5 * kDegree);
}

TEST(BallsTest, NothingElseStandsOnTheGround) {
  const Eigen::Quaterniond lying(Eigen::AngleAxisd(M_PI / 2.0, Vector3d::UnitX()));
  auto model = turtleBot();  // its caster is as small as the clearance
  model->shapes.push_back({Kind::kCylinder, {0.033, 0.033, 0.009}, {0.0, 0.08, 0.033}, lying});
  model->shapes.push_back(solid(Kind::kSphere, Vector3d::Constant(0.003), {0.02, 0.0, 0.003}));
  for (const auto& robot : {std::shared_ptr<const EntityModel>(model), robotModel("footbot")}) {
    const std::vector<CollisionShape> shapes = shapesOnGround(*robot);
    for (std::size_t i = 0; i + 6 < shapes.size(); ++i) {  // the last six are the balls
      EXPECT_GE(shapes[i].position.z() - shapes[i].reachAlong(Vector3d::UnitZ()), 5e-3 - 1e-12) << i;
    }
  }
}

TEST(BallsTest, TheyAreDrawn) {
  World world;
  world.addRobot<FootbotWheels>(ePuck(), flatPose(1.0, 2.0, 0.6));
  EngineDrawing drawing;
  world.engine.draw(drawing);
  // a cylinder of two rings of 16 and four lines, and six balls of three rings
  EXPECT_EQ(drawing.lines(EngineDrawing::Kind::kShape).size(), 36U + 6U * 48U);
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
