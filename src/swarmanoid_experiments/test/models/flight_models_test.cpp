// The formulas of docs/reference/models.md, "Flying".
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "model_world.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kDrag = 0.3 / 2.0;  // 1/s: N s/m on 2 kg

/// Position of the centre of mass, 0.28 m above the origin; this point follows the velocity commands.
Eigen::Vector3d centreOf(const Simulation& simulation) {
  const Pose& pose = poseOf(simulation, "eb");
  return pose.position + pose.orientation * Eigen::Vector3d(0.0, 0.0, 0.28);
}

std::unique_ptr<Simulation> eyebot(int clocktick) {
  ModelWorld world;
  world.engine = "dynamics3d";
  world.engine_parameters = "<subclock>10</subclock>";
  world.clocktick = clocktick;
  world.entities = robot("eyebot", "eb", 9.0, 9.0, 3.0);
  world.members = "eb";
  return world.start();
}

/// Speed of an eyebot on a circle as a fraction of the command, by turning itself or only its velocity.
double speedInCircle(double turn_rate, bool yaws) {
  const double commanded = 0.23;
  double direction = 0.0;
  setProgram([&](Robot& robot) {
    robot.actuator<EyebotVelocity>().linear = {commanded * std::cos(direction), commanded * std::sin(direction), 0.0};
    robot.actuator<EyebotVelocity>().yaw_rate = yaws ? turn_rate : 0.0;
    direction += yaws ? 0.0 : turn_rate * 0.01;
  });
  auto simulation = eyebot(10);
  tick(*simulation, 2500);
  double way = 0.0;
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d before = centreOf(*simulation);
    tick(*simulation);
    way += (centreOf(*simulation) - before).norm();
  }
  return way / 5.0 / commanded;
}

TEST(ModelsPageTest, EyebotInCircles) {
  using namespace std::complex_literals;
  for (const double turn_rate : {0.37, 0.5, 0.83}) {
    const std::complex<double> s = 1i * turn_rate;
    for (const bool yaws : {true, false}) {
      const std::complex<double> lag = yaws ? 1.0 : 256.0 / (s * s + 32.0 * s + 256.0);
      const std::complex<double> pull = lag * (2.0 + 3.0 * s);
      const double factor = std::abs(pull / (s * s + kDrag * s + pull));
      EXPECT_NEAR(speedInCircle(turn_rate, yaws), factor, 5e-4) << turn_rate << " rad/s";
      if (turn_rate == 0.5) {
        EXPECT_NEAR(factor, yaws ? 1.062 : 1.068, 5e-4) << "as the page says";
      }
    }
  }
}

/// Overshoot past the position of the stop command, per m/s, from the page's equations in steps of 0.1 ms.
/// @param lags whether the body must tilt first
double overshootOf(double place_gain, double speed_gain, bool lags) {
  constexpr double kStep = 1e-4;
  double x = 0.0;
  double v = 0.0;
  double a = 0.0;
  double jerk = 0.0;
  double held = 0.0;
  double most = -1.0;
  for (int i = 0; i < 300000; ++i) {
    const double commanded = i < 150000 ? 1.0 : 0.0;
    held += commanded * kStep;
    const double wanted = place_gain * (held - x) + speed_gain * (commanded - v);
    jerk += (256.0 * (wanted - a) - 32.0 * jerk) * kStep;
    a = lags ? a + jerk * kStep : wanted;
    v += (a - kDrag * v) * kStep;
    x += v * kStep;
    most = commanded == 0.0 ? std::max(most, x - held) : most;
  }
  return most;
}

TEST(ModelsPageTest, EyebotStopping) {
  const double across = overshootOf(2.0, 3.0, true);
  const double up = overshootOf(6.0, 6.0, false);
  EXPECT_NEAR(across, 0.230, 5e-4) << "as the page says";
  EXPECT_NEAR(up, 0.109, 5e-4);
  for (const int axis : {0, 1, 2}) {
    const double commanded = 0.29;
    bool goes = true;
    setProgram([&](Robot& robot) {
      auto& linear = robot.actuator<EyebotVelocity>().linear;
      linear.setZero();
      linear[axis] = goes ? commanded : 0.0;
    });
    auto simulation = eyebot(100);
    const double start = centreOf(*simulation)[axis];
    tick(*simulation, 150);
    goes = false;
    double most = 0.0;
    for (int i = 0; i < 60; ++i) {
      tick(*simulation);
      most = std::max(most, centreOf(*simulation)[axis]);
    }
    EXPECT_NEAR(most - start - 15.0 * commanded, commanded * (axis == 2 ? up : across), 1e-3) << "axis " << axis;
  }
}

}  // namespace
}  // namespace swarmanoid::test
