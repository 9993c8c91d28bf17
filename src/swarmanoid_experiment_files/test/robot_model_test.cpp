// Models of the three robots of this installation.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <thread>
#include <vector>

#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/leds.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {
namespace {

using Eigen::Vector3d;
using Kind = CollisionShape::Kind;

constexpr double kTight = 1e-9;  // the files give ten digits after the point

Vector3d onRing(double radius, double angle, double height) {
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

TEST(RobotModelTest, FootbotIsBodyTwoWheelsAndGripper) {
  const auto footbot = robotModel("footbot");
  EXPECT_EQ(footbot->type, "footbot");
  EXPECT_EQ(footbot->title, "Footbot");
  EXPECT_TRUE(footbot->is_robot);
  EXPECT_TRUE(footbot->is_movable);
  ASSERT_EQ(footbot->shapes.size(), 4U);
  EXPECT_EQ(footbot->shapes[0].kind, Kind::kCylinder);
  EXPECT_EQ(footbot->shapes[0].half_extent.x(), 0.085);
  for (const std::size_t wheel : {1U, 2U}) {
    EXPECT_EQ(footbot->shapes[wheel].kind, Kind::kCylinder);
    EXPECT_NEAR(std::abs(footbot->shapes[wheel].position.y()), 0.07, kTight);
  }
  EXPECT_EQ(footbot->shapes[3].kind, Kind::kBox);
  for (const CollisionShape& shape : footbot->shapes) {
    EXPECT_TRUE((shape.orientation * Vector3d::UnitZ()).isApprox(Vector3d::UnitZ()));
  }
  EXPECT_NEAR(footbot->lowest, 0.0, kTight);
  EXPECT_NEAR(footbot->highest, 0.146, kTight);
  EXPECT_NEAR(footbot->bounding_radius, std::hypot(0.085, 0.146), kTight);
  EXPECT_NEAR(footbot->mass, 1.8, kTight);
  EXPECT_NEAR(footbot->centre_of_mass.head<2>().norm(), 0.0, kTight);
  EXPECT_NEAR(footbot->centre_of_mass.z(), (1.6 * 0.07 + 0.2 * 0.029) / 1.8, kTight);
  // a cylinder of 1.6 kg, and two wheels of 0.1 kg that roll at 7 cm from the middle
  const double wheel = 0.1 * (0.029 * 0.029 / 4.0 + 0.02 * 0.02 / 12.0 + 0.07 * 0.07);
  EXPECT_NEAR(footbot->inertia(2, 2), 1.6 * 0.075 * 0.075 / 2.0 + 2.0 * wheel, 1e-8);
  EXPECT_EQ(footbot->urdf.rfind("<?xml", 0), 0U);
}

TEST(RobotModelTest, FootbotWheelsAreThoseOfTheRealOne) {
  const auto footbot = robotModel("footbot");
  ASSERT_TRUE(footbot->wheels.has_value());
  EXPECT_EQ(footbot->wheels->radius, 0.029);
  EXPECT_EQ(footbot->wheels->separation, 0.14);
  EXPECT_DOUBLE_EQ(footbot->wheels->max_speed * footbot->wheels->radius, 0.3);
}

TEST(RobotModelTest, FootbotGripperTipIsTheFrontOfItsBox) {
  const auto footbot = robotModel("footbot");
  ASSERT_TRUE(footbot->gripper.has_value());
  EXPECT_EQ(footbot->gripper->tip, 0.11);
  EXPECT_EQ(footbot->gripper->height, 0.05);
  const CollisionShape& box = footbot->shapes[3];
  EXPECT_NEAR(box.position.x() + box.half_extent.x(), footbot->gripper->tip, kTight);
  EXPECT_EQ(box.position.z(), footbot->gripper->height);
  EXPECT_EQ(footbot->gripping_radius, 0.085);
}

TEST(RobotModelTest, FootbotProximitySensorsLookOutwardsEvery15Degrees) {
  const auto footbot = robotModel("footbot");
  for (std::size_t i = 0; i < FootbotProximity::kCount; ++i) {
    const Mount& sensor = footbot->mount("proximity_" + std::to_string(i));
    const Vector3d outwards = onRing(1.0, FootbotProximity::angle(i), 0.0);
    EXPECT_LT((sensor.orientation * Vector3d::UnitX() - outwards).norm(), kTight) << i;
    EXPECT_LT((sensor.position - onRing(0.085, FootbotProximity::angle(i), 0.06)).norm(), kTight) << i;
  }
  EXPECT_EQ(footbot->mounts.count("proximity_24"), 0U);
}

TEST(RobotModelTest, FootbotGroundSensorsLookDown) {
  const auto footbot = robotModel("footbot");
  const auto expectSpot = [&footbot](const std::string& name, const Vector3d& place) {
    const Mount& spot = footbot->mount(name);
    EXPECT_LT((spot.position - place).norm(), kTight) << name;
    EXPECT_LT((spot.orientation * Vector3d::UnitX() + Vector3d::UnitZ()).norm(), kTight) << name;
  };
  for (int i = 0; i < 8; ++i) {
    expectSpot("ground_" + std::to_string(i), onRing(0.063, (i + 0.5) * M_PI / 4.0, 0.005));
  }
  expectSpot("base_ground_0", {0.03, 0.03, 0.005});
  expectSpot("base_ground_1", {-0.03, 0.03, 0.005});
  expectSpot("base_ground_2", {-0.03, -0.03, 0.005});
  expectSpot("base_ground_3", {0.03, -0.03, 0.005});
  EXPECT_EQ(footbot->mounts.count("ground_8") + footbot->mounts.count("base_ground_4"), 0U);
}

TEST(RobotModelTest, LedsStartAheadAndGoCounterClockwise) {
  const auto footbot = robotModel("footbot");
  ASSERT_EQ(footbot->led_positions.size(), FootbotLeds::kCount);
  for (std::size_t i = 0; i < FootbotLeds::kCount; ++i) {
    EXPECT_LT((footbot->led_positions[i] - onRing(0.085, i * M_PI / 6, 0.12)).norm(), kTight) << i;
  }
  const auto eyebot = robotModel("eyebot");
  ASSERT_EQ(eyebot->led_positions.size(), EyebotLeds::kCount);
  for (std::size_t i = 0; i < EyebotLeds::kCount; ++i) {
    const double radius = eyebot->led_positions[0].x();
    EXPECT_LT((eyebot->led_positions[i] - onRing(radius, i * M_PI / 8, 0.2)).norm(), kTight) << i;
  }
}

TEST(RobotModelTest, FootbotCameraLooksOverItsBody) {
  const auto footbot = robotModel("footbot");
  EXPECT_EQ(footbot->mount("camera").position, Vector3d(0.0, 0.0, 0.28));
  EXPECT_EQ(footbot->mount("base_link").position, Vector3d::Zero());
}

TEST(RobotModelTest, EyebotIsOneCylinderThatLooksDown) {
  const auto eyebot = robotModel("eyebot");
  EXPECT_EQ(eyebot->title, "Eyebot");
  ASSERT_EQ(eyebot->shapes.size(), 1U);
  EXPECT_EQ(eyebot->shapes[0].kind, Kind::kCylinder);
  EXPECT_EQ(eyebot->shapes[0].half_extent, Vector3d(0.25, 0.25, 0.27));
  EXPECT_NEAR(eyebot->lowest, 0.0, kTight);
  EXPECT_NEAR(eyebot->highest, 0.54, kTight);
  EXPECT_NEAR(eyebot->mass, 2.0, kTight);
  EXPECT_FALSE(eyebot->wheels.has_value());
  EXPECT_FALSE(eyebot->gripper.has_value());
  EXPECT_FALSE(eyebot->gripping_radius.has_value());
  for (const char* device : {"camera", "laser_pointer"}) {
    const Vector3d direction = eyebot->mount(device).orientation * Vector3d::UnitX();
    EXPECT_LT((direction + Vector3d::UnitZ()).norm(), kTight) << device;
  }
}

TEST(RobotModelTest, HandbotIsABoxWithTwoArms) {
  const auto handbot = robotModel("handbot");
  ASSERT_EQ(handbot->shapes.size(), 7U);
  EXPECT_EQ(handbot->shapes[0].kind, Kind::kBox);
  EXPECT_LT((handbot->shapes[0].half_extent - Vector3d(0.15, 0.145, 0.145)).norm(), kTight);
  EXPECT_EQ(handbot->shapes[0].joint, -1);
  for (std::size_t i = 1; i < 7; ++i) {
    EXPECT_GE(handbot->shapes[i].joint, 0) << i;
  }
  EXPECT_NEAR(handbot->lowest, 0.0, kTight);
  EXPECT_NEAR(handbot->highest, 0.29, kTight);
  EXPECT_NEAR(handbot->mass, 2.9, kTight);
  EXPECT_EQ(handbot->gripping_radius, 0.145);
  EXPECT_FALSE(handbot->wheels.has_value());
  ASSERT_EQ(handbot->led_positions.size(), 12U);
  EXPECT_LT((handbot->led_positions[0] - Vector3d(0.05, 0.0, 0.205)).norm(), kTight) << "straight ahead";
  EXPECT_LT((handbot->led_positions[4] - Vector3d(-0.025, 0.05 * std::sqrt(0.75), 0.205)).norm(), kTight);
  for (const char* cup : {"left_cup_0", "left_cup_1", "right_cup_0", "right_cup_1"}) {
    EXPECT_NEAR(handbot->mount(cup).position.x(), 0.205, kTight) << cup;  // at the end of the hand
  }
  EXPECT_GT(handbot->mount("left_hand").position.y(), handbot->mount("right_hand").position.y());
  const Vector3d launch = handbot->mount("rope_launcher").orientation * Vector3d::UnitX();
  EXPECT_LT((launch - Vector3d::UnitZ()).norm(), kTight);
}

TEST(RobotModelTest, IsLoadedOnceAndSharedByAllThreads) {
  std::vector<std::shared_ptr<const EntityModel>> models(4);
  std::vector<std::thread> threads;
  for (auto& model : models) {
    threads.emplace_back([&model] { model = robotModel("handbot"); });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(std::set<std::shared_ptr<const EntityModel>>(models.begin(), models.end()).size(), 1U);
}

TEST(RobotModelTest, NamesTheRobotsThatThereAre) {
  try {
    robotModel("footbat");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "found no robot 'footbat', allowed are: eyebot, footbot, handbot; did you mean 'footbot'?");
  }
}

}  // namespace
}  // namespace swarmanoid
