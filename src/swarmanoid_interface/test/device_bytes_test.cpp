// Devices as bytes: a process reads the values that another one wrote, to the last bit.
#include <gtest/gtest.h>

#include <cstddef>
#include <limits>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/holders.hpp"
#include "swarmanoid_interface/devices/joints.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"

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

/// A device that is read from arbitrary bytes is written as the same bytes: no field is left out, doubled or rounded.
TEST(DeviceBytesTest, EveryFieldGoesThereAndBack) {
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

TEST(DeviceBytesTest, LayoutsNameTheFields) {
  EXPECT_EQ("f8 f8", findDeviceType("footbot_wheels")->layout);
  EXPECT_EQ("(u1 u1 u1 f4 f4 f4 f4)* b1", findDeviceType("footbot_camera")->layout);
  EXPECT_EQ("u1 f8 f8", findDeviceType("footbot_turret")->layout);
  EXPECT_EQ("b1 f8 f8", findDeviceType("eyebot_laser")->layout);
  EXPECT_EQ("(f8 f8 f8)*", findDeviceType("joint_states")->layout);
  EXPECT_EQ("(b1 f8 f8)*", findDeviceType("holder_states")->layout);
  EXPECT_EQ("u1 u1 u1 u1 u1 u1 u1 u1 u1 u1 b1", findDeviceType("range_and_bearing")->layout);
  EXPECT_EQ("(f4 f4 f4 u1 u1 u1 u1 u1 u1 u1 u1 u1 u1)* b1", findDeviceType("range_and_bearing_received")->layout);
}

TEST(DeviceBytesTest, SpansAreReadAndSetAsBytes) {
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

TEST(DeviceBytesTest, NumbersKeepTheirBits) {
  FootbotWheels wheels;
  wheels.setAngularVelocity(-0.0, std::numeric_limits<double>::denorm_min());
  const Bytes bytes = bytesOf(wheels);
  EXPECT_EQ((Bytes{0, 0, 0, 0, 0, 0, 0, 0x80, 1, 0, 0, 0, 0, 0, 0, 0}), bytes);
}

TEST(DeviceBytesTest, BlobsComeWithTheirCamera) {
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

TEST(DeviceBytesTest, JointsAndHoldersComeOneAfterTheOther) {
  Joints joints;
  joints.joints[15].turnAt(-0.5);
  const Bytes commands = bytesOf(joints);
  ASSERT_EQ(16U * 17U, commands.size()) << "a mode and two numbers each";
  EXPECT_EQ(0, commands[0]);
  EXPECT_EQ(1, commands[15 * 17]);
  EXPECT_EQ((Bytes{0, 0, 0, 0, 0, 0, 0xe0, 0xbf}), Bytes(commands.end() - 8, commands.end())) << "-0.5";

  const std::vector<HolderStates::Holder> holders{{false, 0.0, 0.0}, {true, 1.5, -2.0}};
  HolderStates states;
  states.holders = holders;
  const Bytes readings = bytesOf(states);
  EXPECT_EQ(4U + 2U * 17U, readings.size());
  EXPECT_EQ(2, readings[0]);
  EXPECT_EQ(0, readings[4]);
  EXPECT_EQ(1, readings[4 + 17]);
  HolderStates received;
  VariableParts parts;
  ByteReader in(readings);
  findDeviceType("holder_states")->read(in, &received, parts);
  ASSERT_EQ(2U, received.holders.size());
  EXPECT_TRUE(received.holders[1].is_holding);
  EXPECT_EQ(1.5, received.holders[1].length);
  EXPECT_EQ(-2.0, received.holders[1].force);
}

TEST(DeviceBytesTest, MessagesComeWithTheirBytes) {
  std::vector<RangeAndBearingMessage> messages(2);
  messages[0].payload = {255, 0, 1, 2, 3, 4, 5, 6, 7, 128};
  messages[1] = {2.5F, -1.25F, 0.75F, {9, 8, 7}};
  RangeAndBearingReceived sent;
  sent.messages = messages;
  sent.overflowed = true;
  const Bytes bytes = bytesOf(sent);
  EXPECT_EQ(4U + 2U * (12U + 10U) + 1U, bytes.size()) << "no padding";
  EXPECT_EQ(128, bytes[4 + 12 + 9]);
  EXPECT_EQ(7, bytes[4 + 22 + 12 + 2]);
  RangeAndBearingReceived received;
  VariableParts parts;
  ByteReader in(bytes);
  findDeviceType("range_and_bearing_received")->read(in, &received, parts);
  ASSERT_EQ(2U, received.messages.size());
  EXPECT_EQ(messages[0].payload, received.messages[0].payload);
  EXPECT_EQ(messages[1].payload, received.messages[1].payload);
  EXPECT_EQ(-1.25F, received.messages[1].bearing);
  EXPECT_EQ(0.75F, received.messages[1].elevation);
  EXPECT_TRUE(received.overflowed);
  EXPECT_EQ(bytes, bytesOf(received));
}

TEST(DeviceBytesTest, BytesThatEndTooEarlyAreRefused) {
  EXPECT_EQ("found 7 bytes, expected at least 8", problemOf("footbot_wheels", Bytes(7)));
  EXPECT_EQ("found 0 bytes, expected at least 8", problemOf("footbot_wheels", Bytes(8)));
  EXPECT_EQ("found a length of 16843009, allowed: at most 2, the bytes that are left",
            problemOf("footbot_camera", Bytes(6, 1)));
}

}  // namespace
}  // namespace swarmanoid
