// The formula of docs/reference/models.md, "Sensing": the inertial unit.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <iterator>
#include <vector>

#include "model_world.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"
#include "swarmanoid_interface/devices/imu.hpp"

namespace swarmanoid::test {
namespace {

TEST(ModelsPageTest, InertialReading) {
  const struct Drive {
    double v;
    double omega;
  } drives[] = {{0.1, 0.0}, {0.1, 0.0}, {0.17, 0.9}, {0.17, 0.9}, {-0.05, -1.7}, {0.0, 0.0}, {0.0, 0.0}};
  constexpr double kTick = 0.1;  // s
  ModelWorld world;
  world.wheels = "<differential_drive/>";
  world.footbot_sensors = "<imu/>";
  world.entities = robot("footbot", "fb", 5.0, 5.0, 0.0, 71.0);
  world.members = "fb";
  std::vector<Imu> readings;
  setProgram([&](Robot& robot) {
    const Drive& drive = drives[readings.size()];
    readings.push_back(robot.sensor<Imu>());
    robot.actuator<DifferentialDrive>().drive(drive.v, drive.omega);
  });
  auto simulation = world.start();
  tick(*simulation, static_cast<int>(std::size(drives)));
  // the velocity of a tick is that along the chord of its arc, seen from where the robot looks at its end
  const auto velocity_of = [](const Drive& drive) -> Eigen::Vector3d {
    const double half_turn = 0.5 * drive.omega * kTick;
    const double speed = drive.v * (half_turn == 0.0 ? 1.0 : std::sin(half_turn) / half_turn);
    return {speed * std::cos(half_turn), -speed * std::sin(half_turn), 0.0};
  };
  ASSERT_EQ(readings.size(), std::size(drives));
  EXPECT_EQ(readings[0].linear_acceleration, Eigen::Vector3d(0.0, 0.0, 9.81)) << "before it has moved";
  for (std::size_t k = 1; k < readings.size(); ++k) {
    const Drive before = k == 1 ? Drive{0.0, 0.0} : drives[k - 2];
    const Drive& now = drives[k - 1];
    const Eigen::Vector3d change = (velocity_of(now) - velocity_of(before)) / kTick;
    const Eigen::Vector3d mean = (velocity_of(now) + velocity_of(before)) / 2.0;
    const double turning = (now.omega + before.omega) / 2.0;
    const Eigen::Vector3d expected(change.x() - turning * mean.y(), change.y() + turning * mean.x(), 9.81);
    EXPECT_NEAR((readings[k].linear_acceleration - expected).norm(), 0.0, 1e-9) << "tick " << k;
    EXPECT_NEAR((readings[k].angular_velocity - Eigen::Vector3d(0.0, 0.0, now.omega)).norm(), 0.0, 1e-9) << k;
  }
}

}  // namespace
}  // namespace swarmanoid::test
