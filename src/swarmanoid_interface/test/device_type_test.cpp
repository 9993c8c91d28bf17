#include "swarmanoid_interface/device_type.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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
#include "swarmanoid_interface/devices/proximity.hpp"

namespace swarmanoid {
namespace {

Bytes bytesOf(const DeviceType& type, const void* device) {
  Bytes bytes;
  ByteWriter out(bytes);
  type.write(device, out);
  return bytes;
}

template <class Device>
Bytes bytesOf(const Device& device) {
  return bytesOf(*findDeviceType(Device::kType), &device);
}

std::string problemOf(const std::string& type, const Bytes& bytes) {
  const DeviceType* found = findDeviceType(type);
  const auto device = found->make();
  VariableParts parts;
  ByteReader in(bytes);
  try {
    found->read(in, device.get(), parts);
  } catch (const ByteError& error) {
    return error.what();
  }
  return "";
}

TEST(DeviceTypeTest, EveryDeviceOfTheSuiteIsThere) {
  std::vector<std::string> names;
  for (const DeviceType* type : deviceTypes()) {
    if (type->type != "winch_of_a_test") {
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

/// The size of the fixed fields that a layout names [bytes].
std::size_t sizeOf(const std::string& layout) {
  std::size_t size = 0;
  for (std::size_t i = 0; i < layout.size(); ++i) {
    if (layout[i] == '(') {
      size += sizeof(std::uint32_t);
      i = layout.find('*', i);
    } else if (layout[i] >= '1' && layout[i] <= '8') {
      size += static_cast<std::size_t>(layout[i] - '0');
    }
  }
  return size;
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

/// A device that is read from arbitrary bytes is written as the same bytes: no field is left out, doubled or rounded.
TEST(DeviceTypeTest, EveryFieldGoesThereAndBack) {
  for (const DeviceType* type : deviceTypes()) {
    const bool has_span = type->layout[0] == '(';
    Bytes bytes(sizeOf(type->layout), 1);
    for (std::size_t i = has_span ? sizeof(std::uint32_t) : 0; i < bytes.size(); ++i) {
      const bool has_bool = type->layout.find('b') != std::string::npos || type->layout[0] == 'u';
      bytes[i] = has_bool ? 1 : static_cast<std::uint8_t>(3 * i + 5);
    }
    if (has_span) {
      std::fill_n(bytes.begin(), sizeof(std::uint32_t), std::uint8_t{0});
    }
    const auto device = type->make();
    VariableParts parts;
    ByteReader in(bytes);
    type->read(in, device.get(), parts);
    EXPECT_EQ(0U, in.left()) << type->type;
    EXPECT_EQ(bytes, bytesOf(*type, device.get())) << type->type;
  }
}

TEST(DeviceTypeTest, LayoutsNameTheFields) {
  EXPECT_EQ("f8 f8", findDeviceType("footbot_wheels")->layout);
  EXPECT_EQ("(u1 u1 u1 f4 f4)* b1", findDeviceType("footbot_camera")->layout);
  EXPECT_EQ("u1 f8 f8", findDeviceType("footbot_turret")->layout);
  EXPECT_EQ("b1 f8 f8", findDeviceType("eyebot_laser")->layout);
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
                                      "blobs[].bearing", "blobs[].distance", "overflowed"}),
            namesOf("eyebot_camera"));
}

TEST(DeviceTypeTest, NamesAreOneTextForThoseWithoutTheStruct) {
  EXPECT_EQ(fieldNames(*findDeviceType("footbot_wheels")), "left right");
  EXPECT_EQ(fieldNames(*findDeviceType("eyebot_velocity")), "linear[0] linear[1] linear[2] yaw_rate");
  EXPECT_EQ(fieldNames(*findDeviceType("footbot_camera")),
            "blobs(color.red color.green color.blue bearing distance) overflowed");
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
  const DeviceNumber& distance = camera.numbers[0].elements.back();
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

TEST(DeviceTypeTest, SpansAreReadAndSetAsBytes) {
  const std::vector<ColorBlob> blobs{{colors::kYellow, 0.5F, 2.0F}, {colors::kRed, -3.0F, 0.25F}};
  FootbotCamera camera;
  camera.blobs = blobs;
  const DeviceNumber& span = findDeviceType("footbot_camera")->numbers[0];
  auto* place = reinterpret_cast<std::byte*>(&camera) + span.offset;
  EXPECT_EQ(2 * sizeof(ColorBlob), span.span.bytes(place).size());
  span.span.set(place, &blobs[1], 1);
  ASSERT_EQ(1U, camera.blobs.size());
  EXPECT_EQ(&blobs[1], camera.blobs.data());
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
  ASSERT_EQ(6U, camera.size());
  EXPECT_EQ("blobs[].color.red", camera[0].name);
  EXPECT_EQ(255.0, camera[0].range.maximum);
  EXPECT_EQ(0U, camera[0].count) << "as many as are in sight";
  EXPECT_EQ("overflowed", camera[5].name);
  EXPECT_EQ("b1", camera[5].type);
  const std::vector<FieldDescription>& ring = findDeviceType("footbot_proximity")->fields;
  ASSERT_EQ(1U, ring.size());
  EXPECT_EQ("value[]", ring[0].name);
  EXPECT_EQ("f4", ring[0].type);
  EXPECT_EQ(24U, ring[0].count);
  EXPECT_EQ("value[24]", countedName(ring[0]));
  EXPECT_EQ("joints[6].speed", countedName(joints[1]));
  EXPECT_EQ("blobs[].color.red", countedName(camera[0]));
}

TEST(DeviceTypeTest, FieldsThatSayNothingMeanWhatTheyAreIn) {
  const std::vector<FieldDescription>& camera = findDeviceType("footbot_camera")->fields;
  EXPECT_EQ("of the thing that is seen", camera[2].meaning) << "blue, of a colour";
  EXPECT_EQ("horizontal, from the camera's vertical axis", camera[4].meaning) << "its own";
  EXPECT_EQ("more was in sight than is reported; what is farthest is left out", camera[5].meaning);
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

TEST(DeviceTypeTest, AnActuatorWithoutASafeStopOfItsOwnRests) {
  Winch winch;
  winch.brake = 0.25;
  const Robot robot("r", "robot", 1);
  EXPECT_TRUE(findDeviceType("winch_of_a_test")->stop(&winch, {0.0, {}, robot}));
  EXPECT_EQ(0.75, winch.brake);
  EXPECT_EQ(nullptr, findDeviceType("footbot_camera")->stop);
}

TEST(DeviceTypeTest, NumbersKeepTheirBits) {
  FootbotWheels wheels;
  wheels.setAngularVelocity(-0.0, std::numeric_limits<double>::denorm_min());
  const Bytes bytes = bytesOf(wheels);
  EXPECT_EQ((Bytes{0, 0, 0, 0, 0, 0, 0, 0x80, 1, 0, 0, 0, 0, 0, 0, 0}), bytes);
}

TEST(DeviceTypeTest, BlobsComeWithTheirCamera) {
  const std::vector<ColorBlob> blobs{{colors::kYellow, 0.5F, 2.0F}, {colors::kRed, -3.0F, 0.25F}};
  FootbotCamera sent;
  sent.blobs = blobs;
  sent.overflowed = true;
  const Bytes bytes = bytesOf(sent);
  FootbotCamera received;
  VariableParts parts;
  const DeviceType* type = findDeviceType("footbot_camera");
  for (int time = 0; time < 2; ++time) {
    ByteReader in(bytes);
    type->read(in, &received, parts);
  }
  ASSERT_EQ(2U, received.blobs.size());
  EXPECT_EQ(colors::kRed, received.blobs[1].color);
  EXPECT_EQ(-3.0F, received.blobs[1].bearing);
  EXPECT_EQ(0.25F, received.blobs[1].distance);
  EXPECT_TRUE(received.overflowed);
  EXPECT_EQ(bytes, bytesOf(received));
}

TEST(DeviceTypeTest, BytesThatEndTooEarlyAreRefused) {
  EXPECT_EQ("found 7 bytes, expected at least 8", problemOf("footbot_wheels", Bytes(7)));
  EXPECT_EQ("found 0 bytes, expected at least 8", problemOf("footbot_wheels", Bytes(8)));
  EXPECT_EQ("found a length of 16843009, allowed: at most 2, the bytes that are left",
            problemOf("footbot_camera", Bytes(6, 1)));
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
