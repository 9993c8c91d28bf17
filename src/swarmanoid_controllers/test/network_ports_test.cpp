// Fields that networks read from devices and write to them: found by name in the descriptors, and scaled by their
// ranges.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../src/neural/network_inputs.hpp"
#include "../src/neural/network_outputs.hpp"
#include "elements.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/distance.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/light.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"

namespace swarmanoid::neural {
namespace {

using test::element;
using test::refusalOf;
using test::value;

/// A device type that is unknown to the libraries of the suite.
struct Nose {
  static constexpr const char* kType = "nose_of_a_test";
  enum class Mode : std::uint8_t { kSniff, kRest };
  struct Side {
    double strength = 0.0;
    bool is_blocked = false;
  };
  Side left;
  double gap = 0.0;
  Mode mode = Mode::kSniff;
};
template <class Visitor>
void fields(Visitor& visit, Nose::Side& side) {
  visit(side.strength, {"strength", "", "", {-4.0, 2.0}});
  visit(side.is_blocked, {"is_blocked"});
}
template <class Visitor>
void fields(Visitor& visit, Nose& nose) {
  visit(nose.left, {"left"});
  visit(nose.gap, orUnknown(distanceField("gap", "", {0.0, kInfinity})));
  visit(nose.mode, {"mode"});
}
REGISTER_DEVICE(Nose, kSensor, "Smells.")

class NetworkPortsTest : public testing::Test {
 protected:
  NetworkPortsTest() {
    robot.provideSensor(FootbotProximity::kType, &proximity);
    robot.provideSensor(Light::kType, &light);
    robot.provideSensor(RangeAndBearingReceived::kType, &received);
    robot.provideSensor(Nose::kType, &nose);
    robot.provideActuator(FootbotWheels::kType, &wheels);
    robot.provideActuator(FootbotGripper::kType, &gripper);
    robot.provideActuator(RangeAndBearing::kType, &sender);
  }

  std::vector<double> read(const std::vector<Configuration>& devices) {
    const NetworkInputs inputs(robot, element("inputs", devices));
    std::vector<double> values(inputs.size(), -7.0);
    inputs.read(values);
    return values;
  }
  std::string refused(const std::vector<Configuration>& devices) {
    return refusalOf([&] { NetworkInputs(robot, element("inputs", devices)); });
  }
  std::string refusedOutput(const std::vector<Configuration>& devices) {
    return refusalOf([&] { NetworkOutputs(robot, element("outputs", devices)); });
  }

  Robot robot{"fb", "footbot", 1};
  FootbotProximity proximity;
  Light light;
  RangeAndBearingReceived received;
  Nose nose;
  FootbotWheels wheels;
  FootbotGripper gripper;
  RangeAndBearing sender;
};

TEST_F(NetworkPortsTest, ArraysAreReadWholeOrAsMeansOfGroups) {
  for (std::size_t i = 0; i < FootbotProximity::kCount; ++i) {
    proximity.value[i] = static_cast<float>(i) / 32.0F;
  }
  const std::vector<double> all = read({element("footbot_proximity", {value("value")})});
  ASSERT_EQ(all.size(), 24U);
  EXPECT_EQ(all[5], 5.0 / 32.0);
  const std::vector<double> groups = read({element("footbot_proximity", {element("value", {value("groups", "8")})})});
  ASSERT_EQ(groups.size(), 8U);
  EXPECT_EQ(groups[1], 4.0 / 32.0);  // mean over readings 3, 4 and 5
  EXPECT_EQ(read({element("footbot_proximity", {element("value", {value("count", "2")})})}),
            (std::vector<double>{0.0, 1.0 / 32.0}));
}

TEST_F(NetworkPortsTest, ZeroStaysZeroAndTheFartherBoundBecomesOne) {
  const std::vector<Configuration> devices{
      element(Nose::kType, {element("left", {value("strength"), value("is_blocked")})})};
  nose.left = {2.0, true};
  EXPECT_EQ(read(devices), (std::vector<double>{0.5, 1.0}));
  nose.left = {-4.0, false};
  EXPECT_EQ(read(devices), (std::vector<double>{-1.0, 0.0}));
  nose.left.strength = -9.0;
  EXPECT_EQ(read(devices)[0], -1.0) << "what is beyond the range is at its end";
  const std::vector<Configuration> narrow{
      element(Nose::kType, {element("left", {element("strength", {value("maximum", "1"), value("minimum", "-2")})})})};
  nose.left.strength = 1.0;
  EXPECT_EQ(read(narrow)[0], 0.5);
}

TEST_F(NetworkPortsTest, DistancesMayBeInfiniteOrUnknown) {
  const auto gap = [&](double found, const std::vector<Configuration>& attributes) {
    nose.gap = found;
    return read({element(Nose::kType, {element("gap", attributes)})})[0];
  };
  const Configuration maximum = value("maximum", "4");
  EXPECT_EQ(gap(1.0, {maximum}), 0.25);
  EXPECT_EQ(gap(kInfinity, {maximum}), 1.0);
  EXPECT_EQ(gap(std::numeric_limits<double>::quiet_NaN(), {maximum}), 0.0);
  const Configuration near = value("near", "true");
  EXPECT_EQ(gap(1.0, {maximum, near}), 0.75);
  EXPECT_EQ(gap(kInfinity, {maximum, near}), 0.0);
  EXPECT_EQ(gap(std::numeric_limits<double>::quiet_NaN(), {maximum, near}), 0.0);
}

TEST_F(NetworkPortsTest, ListsAreReadBySectorsAroundTheRobot) {
  std::vector<LightReading> readings{{0.25F, 0.1F}, {0.5F, -0.1F}, {0.75F, 1.5F}, {1.0F, -3.1F}, {0.125F, 3.1F}};
  light.sensors = readings;
  const std::vector<Configuration> devices{
      element("light", {element("sensors", {element("value", {value("sectors", "4")})})})};
  EXPECT_EQ(read(devices), (std::vector<double>{0.5, 0.75, 1.0, 0.0})) << "ahead, left, behind, right";
  light.sensors = {};
  EXPECT_EQ(read(devices), std::vector<double>(4, 0.0));
}

TEST_F(NetworkPortsTest, EachColourHasItsSectors) {
  std::vector<ColorBlob> blobs(4);
  blobs[0] = {colors::kYellow, 0.1F, 1.5F};
  blobs[1] = {colors::kGreen, 3.0F, 0.5F};
  blobs[2] = {colors::kYellow, -3.0F, 1.75F};
  blobs[3] = {colors::kRed, 0.0F, 0.25F};
  FootbotCamera camera;
  camera.blobs = blobs;
  robot.provideSensor(FootbotCamera::kType, &camera);
  const auto read_colors = [&](const std::string& names) {
    return element("footbot_camera",
                   {element("blobs", {element("distance", {value("sectors", "2"), value("maximum", "2"),
                                                           value("near", "true"), value("colors", names)})})});
  };
  EXPECT_EQ(read({read_colors("green, yellow")}), (std::vector<double>{0.0, 0.75, 0.25, 0.125}));
  EXPECT_EQ(refused({read_colors("green, yelow")}).find("file.xml:8: colors: found 'yelow', allowed: "), 0U);
  EXPECT_EQ(refused({element(
                "light", {element("sensors", {element("value", {value("sectors", "4"), value("colors", "red")})})})}),
            "file.xml:7: found the field 'sensors.value' of light in sectors, allowed: without colors, which its "
            "elements lack");
}

TEST_F(NetworkPortsTest, TheNearestOfASectorCounts) {
  std::vector<RangeAndBearingMessage> messages(3);
  messages[0].range = 3.0F;
  messages[1].range = 1.0F;
  messages[2].range = 2.0F;
  messages[2].bearing = static_cast<float>(M_PI);
  received.messages = messages;
  const std::vector<Configuration> attributes{value("sectors", "2"), value("maximum", "4"), value("near", "true")};
  EXPECT_EQ(read({element("range_and_bearing_received", {element("messages", {element("range", attributes)})})}),
            (std::vector<double>{0.75, 0.5}));
}

TEST_F(NetworkPortsTest, TheFirstOfAListAreReadInTheirOrder) {
  std::vector<RangeAndBearingMessage> messages(1);
  messages[0].payload[0] = 255;
  messages[0].payload[9] = 51;
  received.messages = messages;
  const std::vector<double> values =
      read({element("range_and_bearing_received", {element("messages", {element("payload", {value("count", "2")})})})});
  ASSERT_EQ(values.size(), 20U);
  EXPECT_EQ(values[0], 1.0);
  EXPECT_EQ(values[9], 0.2);
  EXPECT_EQ(values[10], 0.0) << "a second message that is not there";
}

TEST_F(NetworkPortsTest, TheOrderIsThatOfTheDevicesWhateverTheFileSays) {
  proximity.value[0] = 0.5F;
  nose.left = {2.0, true};
  const Configuration first = element("footbot_proximity", {element("value", {value("count", "1")})});
  const Configuration second = element(Nose::kType, {element("left", {value("is_blocked"), value("strength")})});
  EXPECT_EQ(read({first, second}), (std::vector<double>{0.5, 0.5, 1.0}));
  EXPECT_EQ(read({second, first}), read({first, second}));
}

TEST_F(NetworkPortsTest, OutputsFillTheRangesOfTheirFields) {
  const std::vector<Configuration> bounds{value("minimum", "-5"), value("maximum", "10")};
  const NetworkOutputs outputs(
      robot,
      element("outputs", {element("range_and_bearing", {element("payload", {value("count", "1")}), value("sends")}),
                          element("footbot_wheels", {element("left", bounds), element("right", bounds)}),
                          element("footbot_gripper", {value("closed")})}));
  ASSERT_EQ(outputs.size(), 5U);
  outputs.write({0.75, 0.0, 0.5, 0.2, 0.25});
  EXPECT_TRUE(gripper.closed);
  EXPECT_EQ(wheels.left, -5.0);
  EXPECT_EQ(wheels.right, 2.5);
  EXPECT_EQ(sender.payload[0], 51);
  EXPECT_FALSE(sender.sends);
  outputs.write({0.5, 1.0, 1.0, 0.0, 1.0});
  EXPECT_FALSE(gripper.closed);
  EXPECT_EQ(wheels.left, 10.0);
  EXPECT_TRUE(sender.sends);
}

TEST_F(NetworkPortsTest, ConstantsAreCommandedByNoNeuron) {
  const NetworkOutputs outputs(
      robot, element("outputs", {element("range_and_bearing", {element("payload", {value("constant", "7")}),
                                                               element("sends", {value("constant", "1")})}),
                                 element("footbot_gripper", {value("closed")})}));
  ASSERT_EQ(outputs.size(), 1U);
  outputs.write({0.0});
  EXPECT_TRUE(sender.sends);
  EXPECT_EQ(sender.payload[9], 7);
  EXPECT_EQ(refusedOutput({element("range_and_bearing", {element("sends", {value("constant", "2")})})}),
            "file.xml:8: constant: found '2', allowed: a number from 0 to 1");
  EXPECT_EQ(refusedOutput({element("range_and_bearing", {element("sends", {value("constant", "1")})})}),
            "file.xml:7: found <outputs> without a field that the network commands, allowed: at least one");
}

TEST_F(NetworkPortsTest, MistakesAreToldWithTheirPlace) {
  EXPECT_EQ(refused({element("footbot_camera", {value("blobs")})}),
            "file.xml:7: 'footbot_camera' is not known in <inputs>; allowed: footbot_proximity, light, nose_of_a_test, "
            "range_and_bearing_received");
  EXPECT_EQ(refused({element("footbot_wheels", {value("left")})}),
            "file.xml:7: 'footbot_wheels' is not known in <inputs>; allowed: footbot_proximity, light, nose_of_a_test, "
            "range_and_bearing_received");
  EXPECT_EQ(refused({element("footbot_proximity", {value("valeu")})}),
            "file.xml:8: 'valeu' is not known in <footbot_proximity>; allowed: value; did you mean 'value'?");
  EXPECT_EQ(refused({value("light")}), "file.xml:8: found <light> without a field, allowed: sensors");
  EXPECT_EQ(refused({value("light", "all")}), "file.xml:8: found the text 'all' in <light>, allowed: none");
  EXPECT_EQ(refused({}),
            "file.xml:7: found <inputs> without a device, allowed: footbot_proximity, light, nose_of_a_test, "
            "range_and_bearing_received");
  EXPECT_EQ(refused({element("footbot_proximity", {element("value", {value("groups", "5")})})}),
            "file.xml:7: found the field 'value' of footbot_proximity in 5 groups, allowed: as many as divide its 24");
  EXPECT_EQ(refused({element("light", {element("sensors", {value("value")})})}),
            "file.xml:8: found the field 'sensors.value' of light, which is in a list, allowed: with either count or "
            "sectors");
  EXPECT_EQ(
      refused({element(Nose::kType, {value("gap")})}),
      "file.xml:8: found the field 'gap' of nose_of_a_test, whose values are at least 0, allowed: with minimum and "
      "maximum");
  EXPECT_EQ(refused({element(Nose::kType, {value("mode")})}),
            "file.xml:8: found the field 'mode' of nose_of_a_test (one of several modes), allowed: numbers and truth "
            "values");
  EXPECT_EQ(refused({element(Nose::kType, {element("left", {element("strength", {value("maximum", "3")})})})}),
            "file.xml:8: maximum: found '3', allowed: a number from -4 to 2");
  EXPECT_EQ(refused({element("footbot_proximity", {value("value"), value("value")})}),
            "file.xml:8: 'value' stands in <footbot_proximity> twice");
  EXPECT_EQ(refusedOutput({element("footbot_wheels", {value("left")})}),
            "file.xml:8: found the field 'left' of footbot_wheels, whose values are any number, allowed: with minimum "
            "and maximum");
  EXPECT_EQ(
      refusedOutput({element(
          "footbot_wheels", {element("left", {value("groups", "1"), value("minimum", "-1"), value("maximum", "1")})})}),
      "file.xml:8: 'groups' is not known in <left>; allowed: minimum, maximum, count, constant");
}

}  // namespace
}  // namespace swarmanoid::neural
