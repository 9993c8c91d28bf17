// The eyebot's position controller: its commands to the flight mechanism, in ticks of 0.1 s.
#include "swarmanoid_interface/devices/eyebot_position.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "device_world.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kTick = 0.1;  // s

class PositionTest : public testing::Test {
 protected:
  /// Flies exactly as commanded, for some ticks.
  void fly(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      position.actuate();
      carryOut();
    }
  }
  void carryOut() {
    const FlightCommand& flight = world.space.flight[robot];
    Pose& pose = world.pose(robot);
    const double half_turn = 0.5 * flight.yaw_rate * kTick;
    const Eigen::Quaterniond half(Eigen::AngleAxisd(half_turn, Eigen::Vector3d::UnitZ()));
    const double chord = half_turn == 0.0 ? 1.0 : std::sin(half_turn) / half_turn;
    Eigen::Vector3d mean = pose.orientation * half * flight.linear;
    mean.head<2>() *= chord;
    const double height = pose.position.z();
    pose.position += kTick * mean;
    pose.position.z() = std::max(pose.position.z(), ground);
    pose.orientation = pose.orientation * half * half;
    Eigen::Vector3d velocity = pose.orientation * flight.linear;  // at the end of the tick
    velocity.z() = (pose.position.z() - height) / kTick;
    world.space.entities.twist[robot] = {velocity, {0.0, 0.0, flight.yaw_rate}};
    ++world.space.tick;
    const double change = (flight.linear.norm() - last_speed) / kTick;
    fastest = std::max(fastest, flight.linear.norm());
    hardest = std::max(hardest, std::abs(change));
    last_speed = flight.linear.norm();
  }
  /// Converts a position in the take-off frame to W.
  Eigen::Vector3d inArena(const Eigen::Vector3d& place) const {
    return start + Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()) * place;
  }
  void expectAt(const Eigen::Vector3d& place, double allowed, const std::string& what) {
    const Eigen::Vector3d expected = inArena(place);
    EXPECT_NEAR((world.pose(robot).position - expected).norm(), 0.0, allowed)
        << what << ": found " << world.pose(robot).position.transpose() << ", expected " << expected.transpose();
  }
  double yaw() {
    const Eigen::Vector3d ahead = world.pose(robot).orientation * Eigen::Vector3d::UnitX();
    return std::remainder(std::atan2(ahead.y(), ahead.x()) - heading, 2.0 * M_PI);
  }

  DeviceWorld world;
  double heading = 0.83;
  Eigen::Vector3d start{4.0, 5.0, 0.0};
  double ground = 0.0;
  Row robot = world.addEyebot(4.0, 5.0, 0.0, 0.83);
  ActuatorUnderTest<EyebotPosition> position{world, robot, {{"max_speed", "0.7"}, {"max_acceleration", "1.3"}}};
  double last_speed = 0.0;
  double fastest = 0.0;
  double hardest = 0.0;
};

TEST_F(PositionTest, AtRestItHoversWhereItIs) {
  EXPECT_TRUE(world.space.flight[robot].is_driven) << "from the moment when it is added";
  fly(10);
  expectAt({0.0, 0.0, 0.0}, 0.0, "hovering");
}

TEST_F(PositionTest, TakesOffGoesSomewhereAndLands) {
  position.command.takeOff(1.23);
  fly(60);
  expectAt({0.0, 0.0, 1.23}, 1e-3, "taken off");
  position.command.goTo({1.7, -0.9, 0.8}, -2.4);
  fly(90);
  expectAt({1.7, -0.9, 0.8}, 1e-3, "gone there");
  EXPECT_NEAR(yaw(), -2.4, 1e-3);
  EXPECT_LE(fastest, 0.7 + 1e-12);
  EXPECT_GT(fastest, 0.69) << "the way is long enough for its fastest";
  EXPECT_LE(hardest, 1.3 + 1e-9);
  position.command.land();
  fly(60);
  expectAt({1.7, -0.9, 0.0}, 1e-2, "landed");
  EXPECT_EQ(world.space.flight[robot].linear.z(), 0.0) << "it does not press on";
}

TEST_F(PositionTest, DoesNotOvershoot) {
  position.command.goTo({2.1, 0.0, 0.5}, 0.0);
  double farthest = 0.0;
  for (int i = 0; i < 100; ++i) {
    fly(1);
    farthest = std::max(farthest, (world.pose(robot).position - start).norm());
  }
  EXPECT_LT(farthest, std::hypot(2.1, 0.5) + 1e-3);
}

TEST_F(PositionTest, HoversWhereItCanComeToRest) {
  position.command.goTo({5.0, 0.0, 0.5}, 0.0);
  fly(20);
  const Eigen::Vector3d before = world.pose(robot).position;
  position.command.hover();
  fly(40);
  const double way = (world.pose(robot).position - before).norm();
  EXPECT_NEAR(way, 0.7 * 0.7 / 2.0 / 1.3, 0.05) << "v^2 / (2 a)";
  EXPECT_NEAR(world.space.flight[robot].linear.norm(), 0.0, 1e-2);
}

TEST_F(PositionTest, TheFrameIsThatOfTheLastTakeOffAndIsMovedWithTheRobot) {
  position.command.goTo({1.0, 0.5, 0.6}, 1.1);
  fly(80);
  world.pose(robot).position += Eigen::Vector3d(2.0, 1.0, 0.0);  // teleported from outside
  world.space.placed[robot] = world.space.tick;
  fly(10);
  start += Eigen::Vector3d(2.0, 1.0, 0.0);
  expectAt({1.0, 0.5, 0.6}, 1e-3, "it did not notice");
  position.command.land();
  fly(60);
  start = world.pose(robot).position;
  heading += yaw();
  position.command.takeOff(0.5);
  fly(60);
  position.command.goTo({0.4, 0.3, 0.7}, 0.0);
  fly(60);
  expectAt({0.4, 0.3, 0.7}, 2e-3, "from the second take-off");
  EXPECT_NEAR(yaw(), 0.0, 2e-3);
}

TEST_F(PositionTest, ALandingThatIsBrokenOffKeepsTheFrame) {
  position.command.takeOff(2.0);
  fly(80);
  position.command.goTo({0.6, -0.4, 2.0}, 0.7);
  fly(60);
  position.command.land();
  fly(20);
  EXPECT_GT(world.pose(robot).position.z(), 1.0) << "it still sinks";
  position.command.takeOff(1.8);
  fly(60);
  expectAt({0.6, -0.4, 1.8}, 2e-3, "1.8 m above the take-off, not above where it broke off");
  position.command.goTo({0.0, 0.0, 0.9}, 0.0);
  fly(80);
  expectAt({0.0, 0.0, 0.9}, 2e-3, "over the take-off");
}

TEST_F(PositionTest, StopsSafelyByHoveringThenLanding) {
  position.command.takeOff(1.5);
  fly(60);
  const auto stopFor = [&](double from, int ticks) {
    bool is_over = false;
    for (int i = 0; i < ticks; ++i) {
      position.actuate();
      is_over = position.stop(from + i * kTick);
      carryOut();
    }
    return is_over;
  };
  EXPECT_FALSE(stopFor(0.0, 19));
  expectAt({0.0, 0.0, 1.5}, 1e-3, "hovering");
  EXPECT_FALSE(stopFor(2.0, 79));
  expectAt({0.0, 0.0, 0.0}, 1e-9, "on the ground");
  EXPECT_TRUE(stopFor(10.0, 1));
  EXPECT_EQ(position.command.mode, EyebotPosition::Mode::kLand);
}

TEST_F(PositionTest, FarPlacesAreCutAndWhatIsNotFiniteIsRefused) {
  position.command.goTo({1e300, -1e300, 0.5}, 1e3);
  EXPECT_EQ(position.actuate().position, Eigen::Vector3d(1e6, -1e6, 0.5));
  EXPECT_TRUE(world.space.flight[robot].linear.allFinite());
  position.command.position.x() = std::nan("");
  position.actuate();
  EXPECT_EQ(position.faulty.size(), 1U);
}

TEST_F(PositionTest, ActuatingAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  position.command.goTo({1.0, 0.5, 0.6}, 1.1);
  std::vector<Row> faulty;
  const long before = heap_allocations;
  for (int i = 0; i < 3; ++i) {
    position.actuator->actuate(world.space, ActuateAccess(world.space), faulty);
    ++world.space.tick;
  }
  EXPECT_EQ(heap_allocations - before, 0);
}

}  // namespace
}  // namespace swarmanoid::test
