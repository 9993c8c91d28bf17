#include "swarmanoid_interface/device_type.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <regex>

#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_distance.hpp"
#include "swarmanoid_interface/devices/proximity.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"

namespace swarmanoid {
namespace {

TEST(DeviceTypeTest, EveryDeviceOfTheSuiteIsThere) {
  std::vector<std::string> names;
  for (const DeviceType* type : deviceTypes()) {
    if (type->type != "winch_of_a_test" && type->type != "outlines_of_a_test") {
      names.push_back(type->type);
    }
  }
  std::vector<std::string> expected;
  const std::regex type("kType = \"(\\w+)\"");
  for (const auto& header : std::filesystem::directory_iterator(DEVICES)) {
    std::ifstream file(header.path());
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    for (std::sregex_iterator found(text.begin(), text.end(), type); found != std::sregex_iterator(); ++found) {
      expected.push_back((*found)[1]);
    }
  }
  std::sort(expected.begin(), expected.end());
  EXPECT_GE(expected.size(), 20U);
  EXPECT_EQ(expected, names);
}

TEST(DeviceTypeTest, SaysWhichRobotHasTheDevice) {
  EXPECT_EQ("footbot", findDeviceType("footbot_wheels")->robot);
  EXPECT_EQ("eyebot", findDeviceType("eyebot_leds")->robot);
  EXPECT_EQ("", findDeviceType("winch_of_a_test")->robot) << "any robot may have it";
  const std::vector<std::string> robots = robotTypesOfDevices();
  EXPECT_TRUE(std::is_sorted(robots.begin(), robots.end()));
  for (const char* robot : {"eyebot", "footbot", "handbot"}) {
    EXPECT_EQ(1, std::count(robots.begin(), robots.end(), robot)) << robot;
  }
  EXPECT_EQ(0, std::count(robots.begin(), robots.end(), "")) << "any robot is none";
}

TEST(DeviceTypeTest, NumbersAreBroughtIntoTheRangesOfTheirFields) {
  HandbotArms arms;
  arms.left = {-9.0, 0.5, 9.0};
  limitToRanges(arms);
  EXPECT_EQ(-1.57, arms.left.shoulder);
  EXPECT_EQ(0.5, arms.left.elbow) << "is in its range";
  EXPECT_EQ(3.14, arms.left.wrist);
  FootbotProximity ring;
  ring.value[7] = 1.5F;
  limitToRanges(ring);
  EXPECT_EQ(1.0F, ring.value[7]);
  FootbotWheels wheels;
  wheels.left = 1e6;
  limitToRanges(wheels);
  EXPECT_EQ(1e6, wheels.left) << "has no range";
}

/// One closeness is worked out by hand: at 0.0613 of 0.1 m it is 0.387.
TEST(DeviceTypeTest, ProximityFallsWithTheCubeOfTheDistance) {
  EXPECT_EQ(1.0F, Proximity::response(0.0));
  EXPECT_EQ(0.0F, Proximity::response(1.0));
  EXPECT_FLOAT_EQ(0.057960603F, Proximity::response(0.613));
}

TEST(DeviceTypeTest, SaysWhereItsStructIs) {
  EXPECT_EQ("FootbotTurretState", findDeviceType("footbot_turret_state")->name);
  EXPECT_EQ("swarmanoid_interface/devices/footbot_turret.hpp", findDeviceType("footbot_turret_state")->header);
  EXPECT_EQ("Winch", findDeviceType("winch_of_a_test")->name);
  EXPECT_EQ("device_type_test.cpp", findDeviceType("winch_of_a_test")->header);
  EXPECT_EQ("my_package/sonar.hpp", includedAs("/home/me/include/my_package/include/my_package/sonar.hpp"));
  EXPECT_EQ("my_package/sonar.hpp", includedAs("include/my_package/sonar.hpp"));
  EXPECT_EQ("sonar.hpp", includedAs("sonar.hpp"));
}

std::vector<std::string> namesOf(const std::string& type) {
  std::vector<std::string> names;
  for (const DeviceNumber& name : findDeviceType(type)->numbers) {
    names.push_back(name.name);
    for (const DeviceNumber& element : name.elements) {
      names.push_back(name.name + "[]." + element.name);
    }
  }
  return names;
}

TEST(DeviceTypeTest, NumbersHaveNamesInTheOrderOfTheBytes) {
  EXPECT_EQ((std::vector<std::string>{"mode", "angle", "speed"}), namesOf("footbot_turret"));
  EXPECT_EQ((std::vector<std::string>{"left.shoulder", "left.elbow", "left.wrist", "right.shoulder", "right.elbow",
                                      "right.wrist"}),
            namesOf("handbot_arms"));
  EXPECT_EQ((std::vector<std::string>{"linear[0]", "linear[1]", "linear[2]", "yaw_rate"}), namesOf("eyebot_velocity"));
  EXPECT_EQ("joints[5].effort", namesOf("handbot_arms_state")[17]);
  EXPECT_EQ("ring[11].blue", namesOf("footbot_leds").back());
  EXPECT_EQ((std::vector<std::string>{"blobs", "blobs[].color.red", "blobs[].color.green", "blobs[].color.blue",
                                      "blobs[].bearing", "blobs[].distance", "blobs[].elevation", "blobs[].size",
                                      "overflowed"}),
            namesOf("eyebot_camera"));
}

TEST(DeviceTypeTest, NamesAreOneTextForThoseWithoutTheStruct) {
  EXPECT_EQ(fieldNames(*findDeviceType("footbot_wheels")), "left right");
  EXPECT_EQ(fieldNames(*findDeviceType("eyebot_velocity")), "linear[0] linear[1] linear[2] yaw_rate");
  EXPECT_EQ(fieldNames(*findDeviceType("footbot_camera")),
            "blobs(color.red color.green color.blue bearing distance elevation size) overflowed");
}

TEST(DeviceTypeTest, NumbersHaveTheirPlaces) {
  using Kind = DeviceNumber::Kind;
  const std::vector<DeviceNumber>& wheels = findDeviceType("footbot_wheels")->numbers;
  EXPECT_EQ(offsetof(FootbotWheels, right), wheels[1].offset);
  const DeviceType& turret = *findDeviceType("footbot_turret");
  EXPECT_EQ(Kind::kEnumeration, turret.numbers[0].kind);
  EXPECT_EQ("u1", turret.numbers[0].type);
  EXPECT_EQ(offsetof(FootbotTurret, speed), turret.numbers[2].offset);
  EXPECT_EQ("speed", turret.fields[turret.numbers[2].field].name);
  const DeviceType& camera = *findDeviceType("footbot_camera");
  ASSERT_EQ(Kind::kSpan, camera.numbers[0].kind);
  EXPECT_EQ(Kind::kTruthValue, camera.numbers[1].kind);
  const DeviceNumber& distance = camera.numbers[0].elements[4];
  EXPECT_EQ(offsetof(ColorBlob, distance), distance.offset);
  EXPECT_EQ("blobs[].distance", camera.fields[distance.field].name);
  EXPECT_TRUE(camera.fields[camera.numbers[0].elements[3].field].wraps);
  EXPECT_FALSE(camera.fields[distance.field].wraps);
  const DeviceType& proximity = *findDeviceType("proximity");
  ASSERT_EQ(2U, proximity.numbers[0].elements.size());
  EXPECT_EQ("sensors[].angle", proximity.fields[proximity.numbers[0].elements[1].field].name);
  EXPECT_TRUE(proximity.fields[proximity.numbers[0].elements[1].field].wraps);
  EXPECT_FALSE(proximity.fields[proximity.numbers[0].elements[0].field].wraps);
}

TEST(DeviceTypeTest, FieldsAreDescribed) {
  const std::vector<FieldDescription>& arms = findDeviceType("handbot_arms")->fields;
  ASSERT_EQ(6U, arms.size());
  EXPECT_EQ("right.elbow", arms[4].name);
  EXPECT_EQ("f8", arms[4].type);
  EXPECT_EQ("rad", arms[4].unit);
  EXPECT_EQ(-1.2, arms[4].range.minimum);
  EXPECT_EQ(1.2, arms[4].range.maximum);
  EXPECT_EQ(1U, arms[4].count);
  const std::vector<FieldDescription>& joints = findDeviceType("handbot_arms_state")->fields;
  ASSERT_EQ(3U, joints.size());
  EXPECT_EQ("joints[].speed", joints[1].name);
  EXPECT_EQ(6U, joints[1].count);
  const std::vector<FieldDescription>& camera = findDeviceType("footbot_camera")->fields;
  ASSERT_EQ(8U, camera.size());
  EXPECT_EQ("blobs[].color.red", camera[0].name);
  EXPECT_EQ(255.0, camera[0].range.maximum);
  EXPECT_EQ(0U, camera[0].count) << "as many as are in sight";
  EXPECT_EQ("overflowed", camera[7].name);
  EXPECT_EQ("b1", camera[7].type);
  const std::vector<FieldDescription>& ring = findDeviceType("footbot_proximity")->fields;
  ASSERT_EQ(1U, ring.size());
  EXPECT_EQ("value[]", ring[0].name);
  EXPECT_EQ("f4", ring[0].type);
  EXPECT_EQ(24U, ring[0].count);
  EXPECT_EQ("value[24]", countedName(ring[0]));
  EXPECT_EQ("joints[6].speed", countedName(joints[1]));
  EXPECT_EQ("blobs[].color.red", countedName(camera[0]));
}

/// A camera for tests that reports corners: a span of structs that contain arrays of numbers and of structs.
struct Outlines {
  static constexpr const char* kType = "outlines_of_a_test";
  struct Corner {
    float x = 0.0F;
    float y = 0.0F;
  };
  struct Outline {
    std::uint8_t kind = 0;
    std::array<Corner, 3> corners{};
    std::array<std::uint16_t, 2> tags{};
  };
  Span<const Outline> outlines;
};
template <class Visitor>
void fields(Visitor& visit, Outlines::Corner& corner) {
  visit(corner.x, {"x", "m"});
  visit(corner.y, {"y", "m"});
}
template <class Visitor>
void fields(Visitor& visit, Outlines::Outline& outline) {
  visit(outline.kind, {"kind"});
  visit(outline.corners, {"corners"});
  visit(outline.tags, {"tags"});
}
template <class Visitor>
void fields(Visitor& visit, Outlines& outlines) {
  visit(outlines.outlines, {"outlines"});
}
REGISTER_DEVICE(Outlines, kSensor, "Shapes.")

TEST(DeviceTypeTest, ElementsOfSpansMayHaveArrays) {
  const DeviceType& type = *findDeviceType("outlines_of_a_test");
  EXPECT_EQ("(u1 f4 f4 f4 f4 f4 f4 u2 u2)*", type.layout);
  EXPECT_EQ(fieldNames(type),
            "outlines(kind corners[0].x corners[0].y corners[1].x corners[1].y corners[2].x corners[2].y tags[0] "
            "tags[1])");
  const std::vector<DeviceNumber>& numbers = type.numbers[0].elements;
  ASSERT_EQ(9U, numbers.size());
  EXPECT_EQ(offsetof(Outlines::Outline, corners) + sizeof(Outlines::Corner) + offsetof(Outlines::Corner, y),
            numbers[4].offset);
  EXPECT_EQ(offsetof(Outlines::Outline, tags) + sizeof(std::uint16_t), numbers[8].offset);
  EXPECT_EQ("outlines[].tags[]", type.fields[numbers[8].field].name);
}

TEST(DeviceTypeTest, NamesSayHowManyNumbersAnElementHas) {
  std::vector<std::string> names;
  for (const FieldDescription& field : findDeviceType("outlines_of_a_test")->fields) {
    EXPECT_EQ(0U, field.count) << "as many as there are";
    names.push_back(countedName(field));
  }
  EXPECT_EQ((std::vector<std::string>{"outlines[].kind", "outlines[].corners[3].x", "outlines[].corners[3].y",
                                      "outlines[].tags[2]"}),
            names);
  const std::vector<FieldDescription>& received = findDeviceType("range_and_bearing_received")->fields;
  ASSERT_EQ(5U, received.size());
  EXPECT_EQ("messages[].payload[10]", countedName(received[3]));
  EXPECT_EQ("payload[10]", countedName(findDeviceType("range_and_bearing")->fields[0]));
  EXPECT_EQ("messages[].payload[10], uint8", describe(received[3]));
}

TEST(DeviceTypeTest, FieldsThatSayNothingMeanWhatTheyAreIn) {
  const std::vector<FieldDescription>& camera = findDeviceType("footbot_camera")->fields;
  EXPECT_EQ("of the blob", camera[2].meaning) << "blue, of a colour";
  EXPECT_EQ("horizontal, from the camera's vertical axis; NaN if it cannot know", camera[4].meaning) << "its own";
  EXPECT_EQ("more blobs were in sight than reported; the farthest are left out", camera[7].meaning);
  const std::vector<FieldDescription>& winch = findDeviceType("winch_of_a_test")->fields;
  EXPECT_EQ("on one axle", winch[0].meaning) << "elements of an array";
  EXPECT_EQ("", winch[1].meaning);
}

/// A device with a resting value that is not 0, and all kinds of fields.
struct Winch {
  static constexpr const char* kType = "winch_of_a_test";
  struct Drum {
    float radius = 0.125F;
  };
  std::array<Drum, 3> drums{};
  std::array<std::uint16_t, 2> counts{7, 9};
  double brake = 0.75;
};
template <class Visitor>
void fields(Visitor& visit, Winch::Drum& drum) {
  visit(drum.radius, {"radius", "m"});
}
template <class Visitor>
void fields(Visitor& visit, Winch& winch) {
  visit(winch.drums, {"drums", "", "on one axle"});
  visit(winch.counts, {"counts"});
  visit(winch.brake, {"brake", "", "how far it is closed", {0.0, 1.0}});
}
REGISTER_DEVICE(Winch, kActuator, "A winch.")

TEST(DeviceTypeTest, RestingValuesAreThoseOfTheStruct) {
  const DeviceType& type = *findDeviceType("winch_of_a_test");
  EXPECT_EQ("f4 f4 f4 u2 u2 f8", type.layout);
  ASSERT_EQ(3U, type.fields.size());
  EXPECT_EQ("drums[].radius", type.fields[0].name);
  EXPECT_EQ(3U, type.fields[0].count);
  EXPECT_EQ(0.125, type.fields[0].resting_value);
  EXPECT_EQ(7.0, type.fields[1].resting_value);
  EXPECT_EQ(0.75, type.fields[2].resting_value);
}

TEST(DeviceTypeTest, EveryNumberIsLookedAtForFiniteness) {
  const DeviceType& type = *findDeviceType("winch_of_a_test");
  Winch winch;
  EXPECT_TRUE(type.is_finite(&winch));
  winch.drums[2].radius = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(type.is_finite(&winch));
  winch = Winch{};
  winch.brake = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(type.is_finite(&winch));
  std::vector<ColorBlob> blobs{{colors::kRed, 0.5F, 2.0F}, {colors::kRed, 0.25F, 1.0F}};
  FootbotCamera camera;
  camera.blobs = blobs;
  const DeviceType& camera_type = *findDeviceType("footbot_camera");
  EXPECT_TRUE(camera_type.is_finite(&camera));
  blobs[1].bearing = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(camera_type.is_finite(&camera));
  EyebotVelocity velocity;
  velocity.linear.y() = -std::numeric_limits<double>::infinity();
  EXPECT_FALSE(findDeviceType("eyebot_velocity")->is_finite(&velocity));
}

/// By REP-117, distances are infinite for objects too far or too near.
TEST(DeviceTypeTest, MeasuredDistancesNeedNotBeFinite) {
  const DeviceType& type = *findDeviceType(HandbotDistance::kType);
  HandbotDistance ring;
  EXPECT_TRUE(std::isnan(ring.distance[0])) << "at rest nothing is measured";
  ring.distance[3] = std::numeric_limits<float>::infinity();
  ring.distance[4] = -std::numeric_limits<float>::infinity();
  EXPECT_TRUE(type.is_finite(&ring));
  limitToRanges(ring);
  EXPECT_EQ(std::numeric_limits<float>::infinity(), ring.distance[3]);
  EXPECT_TRUE(type.fields[0].is_distance);
  EXPECT_FALSE(type.fields[1].is_distance);
  ring.range_max = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(type.is_finite(&ring));
}

TEST(DeviceTypeTest, AnActuatorWithoutASafeStopOfItsOwnRests) {
  Winch winch;
  winch.brake = 0.25;
  const Robot robot("r", "robot", 1);
  EXPECT_TRUE(findDeviceType("winch_of_a_test")->stop(&winch, {0.0, {}, robot}));
  EXPECT_EQ(0.75, winch.brake);
  EXPECT_EQ(nullptr, findDeviceType("footbot_camera")->stop);
}

TEST(DeviceTypeTest, TheFirstOfATypeStays) {
  DeviceType other;
  other.type = "footbot_wheels";
  other.layout = "i4";
  registerDeviceType(other);
  EXPECT_EQ("f8 f8", findDeviceType("footbot_wheels")->layout);
  EXPECT_EQ(nullptr, findDeviceType("footbot_wings"));
}

}  // namespace
}  // namespace swarmanoid
