// Occlusion of LEDs in cameras, found with boxes around entities and few rays, equals that of one ray to each LED, bit
// for bit.
#include <gtest/gtest.h>

#include <random>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_space/testing/plain_rays.hpp"

namespace swarmanoid::test {
namespace {

/// A world of entities at random poses: robots of all types, some tilted, walls at any angle, preys and lamps.
class CrowdedWorld {
 public:
  explicit CrowdedWorld(std::uint64_t seed) : random_(seed) {
    for (int i = 0; i < 14; ++i) {
      lightUp(world.addFootbot(uniform(3.0, 6.0), uniform(3.0, 6.0), uniform(-3.1, 3.1)), i % 5 == 0);
    }
    for (int i = 0; i < 5; ++i) {
      lightUp(world.addEyebot(uniform(3.0, 6.0), uniform(3.0, 6.0), uniform(0.0, 2.4), uniform(-3.1, 3.1)), i == 3);
      const Row handbot = world.add(robotModel("handbot"), place(0.0), uniform(-3.1, 3.1));
      for (JointState& joint : world.space.joints[handbot]) {
        joint.angle = uniform(-1.0, 1.0);
      }
      world.addWall({uniform(0.02, 0.6), uniform(0.02, 2.0), uniform(0.05, 2.0)}, place(0.0).head<2>());
      tilt(world.add(blockModel({uniform(0.02, 1.0), uniform(0.02, 1.0), 0.1}), place(uniform(0.0, 2.5))), 1.5);
      world.addPrey(uniform(3.0, 6.0), uniform(3.0, 6.0), anyColor());
      world.add(lightModel(), place(uniform(0.0, 2.9)), 0.0, anyColor());
    }
  }

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Eigen::Vector3d place(double z) { return {uniform(3.0, 6.0), uniform(3.0, 6.0), z}; }

  DeviceWorld world;

 private:
  Color anyColor() {
    return {static_cast<std::uint8_t>(random_() % 255 + 1), static_cast<std::uint8_t>(random_() % 256), 7};
  }
  void tilt(Row row, double most) {
    Pose& pose = world.pose(row);
    const Eigen::Vector3d axis(uniform(-1.0, 1.0), uniform(-1.0, 1.0), 0.1);
    pose.orientation = Eigen::AngleAxisd(uniform(0.0, most), axis.normalized()) * pose.orientation;
  }
  void lightUp(Row row, bool is_tilted) {
    for (Color& color : world.space.leds[row]) {
      color = random_() % 4 == 0 ? colors::kBlack : anyColor();
    }
    if (is_tilted) {
      tilt(row, 1.2);
    }
  }

  std::mt19937_64 random_;
};

TEST(NearObstaclesTest, LeaveTheSameLedsInSightAsARayToEach) {
  std::size_t in_sight = 0;
  std::size_t lit = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CrowdedWorld crowd(seed);
    DeviceWorld& world = crowd.world;
    const double range = crowd.uniform(0.2, 2.5);
    const Row watcher = world.addFootbot(crowd.uniform(3.0, 6.0), crowd.uniform(3.0, 6.0));
    SensorUnderTest<FootbotCamera> camera(world, watcher, {{"range", numberText(range)}, {"max_blobs", "1000"}});
    // from below the ground, among the robots, and from above the arena
    for (const double z : {-0.3, 0.0, 0.07, 0.9, 2.3, 6.0}) {
      world.pose(watcher).position.z() = z;
      const Eigen::Vector3d eye = world.pose(watcher).toWorld({0.0, 0.0, FootbotCamera::kMount});
      const auto expected = ledsByPlainRays(world.space, watcher, eye, range);
      EXPECT_EQ(ledsOf(camera.sense()), expected) << "world " << seed << ", at " << z << " m";
      in_sight += expected.size();
      lit += 14U * 9U;
    }
  }
  EXPECT_GT(in_sight, 1000U);
  EXPECT_LT(in_sight, lit / 2U) << "something hides many";
}

TEST(NearObstaclesTest, HideASpotOnTheGroundAsARayWould) {
  DeviceWorld world;
  const Row watcher = world.addFootbot(5.0, 5.0);
  world.space.laser_spots.push_back({EntityNumber{1}, Eigen::Vector3d::Zero(), {6.0, 5.3, 0.0}, colors::kRed});
  SensorUnderTest<FootbotCamera> camera(world, watcher);
  EXPECT_EQ(camera.sense().blobs.size(), 1U);
  // the line from 0.28 m is 0.14 m high half way, at (5.5, 5.15)
  const Row low = world.addWall({0.02, 0.02, 0.13}, {5.5, 5.15});
  EXPECT_EQ(camera.sense().blobs.size(), 1U);
  world.remove(low);
  const Row wall = world.addWall({0.02, 0.02, 0.16}, {5.5, 5.15});
  EXPECT_EQ(camera.sense().blobs.size(), 0U);
  world.pose(wall).position.y() = 5.18;
  EXPECT_EQ(camera.sense().blobs.size(), 1U) << "beside it";
}

}  // namespace
}  // namespace swarmanoid::test
