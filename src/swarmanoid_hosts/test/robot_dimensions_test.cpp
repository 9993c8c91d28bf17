// Dimensions and motor limits in device headers are equal to those in the robots' URDF.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/eyebot_distance.hpp"
#include "swarmanoid_interface/devices/eyebot_laser.hpp"
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_ground.hpp"
#include "swarmanoid_interface/devices/footbot_microphones.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_distance.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"

namespace swarmanoid {
namespace {

constexpr double kRounding = 1e-9;

std::string urdfOf(const std::string& robot) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(DESCRIPTION)) {
    if (entry.path().filename() == robot + ".urdf") {
      std::ifstream in(entry.path());
      return {std::istreambuf_iterator<char>(in), {}};
    }
  }
  ADD_FAILURE() << "there is no " << robot << ".urdf in " << DESCRIPTION;
  return "";
}

/// The element of a joint.
std::string jointOf(const std::string& robot, const std::string& name) {
  const std::string urdf = urdfOf(robot);
  const auto begin = urdf.find("<joint name=\"" + name + "\"");
  EXPECT_NE(std::string::npos, begin) << robot << " has no joint " << name;
  return begin == std::string::npos ? "" : urdf.substr(begin, urdf.find("</joint>", begin) - begin);
}

/// The numbers of an attribute of the joint.
std::vector<double> numbersOf(const std::string& robot, const std::string& joint, const std::string& attribute) {
  const std::string element = jointOf(robot, joint);
  std::smatch found;
  if (!std::regex_search(element, found, std::regex(attribute + R"re(="([^"]*)")re"))) {
    ADD_FAILURE() << robot << ": " << joint << " has no " << attribute;
    return {0.0, 0.0, 0.0};
  }
  std::istringstream words(found[1]);
  return {std::istream_iterator<double>(words), {}};
}

TEST(RobotDimensions, OfFootbots) {
  const std::vector<double> wheel = numbersOf("footbot", "left_wheel", "xyz");
  EXPECT_NEAR(FootbotWheels::kSeparation / 2.0, wheel[1], kRounding);
  EXPECT_NEAR(FootbotWheels::kRadius, wheel[2], kRounding) << "the wheel stands on the ground";
  EXPECT_NEAR(FootbotWheels::kFastest, numbersOf("footbot", "left_wheel", "velocity")[0], kRounding);
  EXPECT_NEAR(FootbotTurret::kFastest, numbersOf("footbot", "turret", "velocity")[0], kRounding);
  EXPECT_NEAR(FootbotGripper::kReach, numbersOf("footbot", "gripper_tip_joint", "xyz")[0], kRounding);
  for (std::size_t i = 0; i < FootbotProximity::kCount; ++i) {
    const std::vector<double> sensor = numbersOf("footbot", "proximity_" + std::to_string(i) + "_joint", "xyz");
    EXPECT_NEAR(FootbotProximity::kRingRadius * std::cos(FootbotProximity::angle(i)), sensor[0], kRounding) << i;
    EXPECT_NEAR(FootbotProximity::kRingRadius * std::sin(FootbotProximity::angle(i)), sensor[1], kRounding) << i;
  }
}

TEST(RobotDimensions, OfTheMicrophonesOfFootbots) {
  for (std::size_t i = 0; i < FootbotMicrophones::kCount; ++i) {
    const std::vector<double> place = numbersOf("footbot", "microphone_" + std::to_string(i) + "_joint", "xyz");
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(FootbotMicrophones::place(i)[static_cast<Eigen::Index>(k)], place[k], kRounding) << i;
    }
  }
}

/// The spots of a footbot's ground sensor are where its links are.
template <class Spots>
void expectPlaces(const std::string& link) {
  for (std::size_t i = 0; i < Spots::kCount; ++i) {
    const std::vector<double> spot = numbersOf("footbot", link + "_" + std::to_string(i) + "_joint", "xyz");
    EXPECT_NEAR(Spots::place(i).x(), spot[0], kRounding) << link << i;
    EXPECT_NEAR(Spots::place(i).y(), spot[1], kRounding) << link << i;
  }
}

TEST(RobotDimensions, OfTheGroundSensorsOfFootbots) {
  expectPlaces<FootbotGround>("ground");
  expectPlaces<FootbotBaseGround>("base_ground");
}

/// The distance sensors around a robot are where its links are.
template <class Device>
void expectRing(const std::string& robot, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::string joint = "distance_" + std::to_string(i) + "_joint";
    const std::vector<double> sensor = numbersOf(robot, joint, "xyz");
    EXPECT_NEAR(Device::kRingRadius * std::cos(Device::angle(i)), sensor[0], kRounding) << joint;
    EXPECT_NEAR(Device::kRingRadius * std::sin(Device::angle(i)), sensor[1], kRounding) << joint;
    EXPECT_NEAR(Device::angle(i), numbersOf(robot, joint, "rpy")[2], kRounding) << joint;
  }
}

TEST(RobotDimensions, OfDistanceSensors) {
  expectRing<EyebotDistance>("eyebot", EyebotDistance::kAround);
  EXPECT_NEAR(EyebotDistance::kUpHeight, numbersOf("eyebot", "distance_16_joint", "xyz")[2], kRounding);
  EXPECT_NEAR(EyebotDistance::kDownHeight, numbersOf("eyebot", "distance_17_joint", "xyz")[2], kRounding);
  expectRing<HandbotDistance>("handbot", HandbotDistance::kCount);
}

TEST(RobotDimensions, OfEyebots) {
  EXPECT_NEAR(EyebotCamera::kMount, numbersOf("eyebot", "camera_joint", "xyz")[2], kRounding);
  EXPECT_NEAR(EyebotOmnidirectionalCamera::kMount, numbersOf("eyebot", "omnidirectional_camera_joint", "xyz")[2],
              kRounding);
  EXPECT_NEAR(EyebotMagnet::kMount, numbersOf("eyebot", "magnet_joint", "xyz")[2], kRounding);
  const std::vector<double> laser = numbersOf("eyebot", "laser_pointer_joint", "xyz");
  for (std::size_t axis = 0; axis < laser.size(); ++axis) {
    EXPECT_NEAR(EyebotLaser::kMount[axis], laser[axis], kRounding);
  }
}

/// Cameras with a lens are not on the axis.
template <class Camera>
void expectMount(const std::string& link) {
  const std::vector<double> mount = numbersOf(Camera::kRobot, link + "_joint", "xyz");
  for (std::size_t axis = 0; axis < mount.size(); ++axis) {
    EXPECT_NEAR(Camera::kMount[axis], mount[axis], kRounding) << link << ", axis " << axis;
  }
}

TEST(RobotDimensions, OfCamerasWithALens) {
  expectMount<EyebotPanTiltCamera>("pan_tilt_camera");
  expectMount<FootbotFrontCamera>("front_camera");
  expectMount<HandbotCamera>("camera");
  EXPECT_NEAR(FootbotCamera::kMount, numbersOf("footbot", "camera_joint", "xyz")[2], kRounding);
}

TEST(RobotDimensions, OfHandbots) {
  EXPECT_NEAR(HandbotRope::kMount, numbersOf("handbot", "rope_launcher_joint", "xyz")[2], kRounding);
  const DeviceType& arms = *findDeviceType(HandbotArms::kType);
  ASSERT_EQ(HandbotArmsState::kJoints, arms.fields.size());
  for (std::size_t i = 0; i < HandbotArmsState::kJoints; ++i) {
    const std::string joint = HandbotArmsState::kNames[i];
    EXPECT_NEAR(HandbotArms::kFastest, numbersOf("handbot", joint, "velocity")[0], kRounding);
    EXPECT_NEAR(arms.fields[i].range.minimum, numbersOf("handbot", joint, "lower")[0], kRounding) << joint;
    EXPECT_NEAR(arms.fields[i].range.maximum, numbersOf("handbot", joint, "upper")[0], kRounding) << joint;
  }
}

}  // namespace
}  // namespace swarmanoid
