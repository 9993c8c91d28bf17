// Devices of any robot, of a mock robot: they show its motion and its world.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "mock_bench.hpp"
#include "swarmanoid_interface/devices/battery.hpp"
#include "swarmanoid_interface/devices/bluetooth.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"
#include "swarmanoid_interface/devices/floor_color.hpp"
#include "swarmanoid_interface/devices/footbot_microphones.hpp"
#include "swarmanoid_interface/devices/ground.hpp"
#include "swarmanoid_interface/devices/holders.hpp"
#include "swarmanoid_interface/devices/imu.hpp"
#include "swarmanoid_interface/devices/joints.hpp"
#include "swarmanoid_interface/devices/light.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"
#include "swarmanoid_interface/devices/rfid.hpp"
#include "swarmanoid_interface/devices/wifi.hpp"

namespace swarmanoid::mock {
namespace {

TEST(MockRangeAndBearing, HearsBeaconsThatSaySomething) {
  World world;
  world.beacons.push_back({"mute", {0.5, 0.0, 0.0}, colors::kRed, false});
  world.beacons.push_back({"nest", {0.6, 0.8, 1.0}, colors::kGreen, false, {7, 255}});
  world.beacons.push_back({"far", {-3.01, 0.0, 0.0}, colors::kGreen, false, {9}});
  Bench bench({"differential_drive", "range_and_bearing", "range_and_bearing_received"}, world);
  const RangeAndBearingReceived& received = bench.reading<RangeAndBearingReceived>();
  ASSERT_EQ(1U, received.messages.size());
  EXPECT_NEAR(std::sqrt(2.0), received.messages[0].range, 1e-6);
  EXPECT_NEAR(0.927295, received.messages[0].bearing, 1e-6) << "4 to the left for each 3 ahead";
  EXPECT_NEAR(M_PI / 4.0, received.messages[0].elevation, 1e-6) << "1 m away and 1 m up";
  EXPECT_EQ((RangeAndBearing::Payload{7, 255}), received.messages[0].payload);
  EXPECT_FALSE(received.overflowed);
  bench.command<RangeAndBearing>().send({1});
  bench.command<DifferentialDrive>().drive(-0.1, 0.0);
  bench.advance(1.0);
  ASSERT_EQ(2U, received.messages.size()) << "it does not hear itself";
  EXPECT_NEAR(2.91, received.messages[1].range, 1e-6);
  EXPECT_EQ(static_cast<float>(M_PI), received.messages[1].bearing);
  EXPECT_EQ(9, received.messages[1].payload[0]);
}

TEST(MockRadios, HearBeaconsByTheAddressesOfTheirNames) {
  World world;
  world.beacons.push_back({"mute", {0.5, 0.0, 0.0}, colors::kRed, false});
  world.beacons.push_back({"nest", {-6.0, 7.9, 1.0}, colors::kGreen, false, {7, 255}});
  world.beacons.push_back({"far", {-6.0, 8.1, 0.0}, colors::kGreen, false, {9}});
  Bench bench({"bluetooth_received", "wifi", "wifi_received"}, world);
  bench.command<Wifi>().send({1});
  bench.advance(0.1);
  const Span<const BluetoothMessage> near = bench.reading<BluetoothReceived>().messages;
  ASSERT_EQ(1U, near.size()) << "within 10 m";
  EXPECT_EQ(addressOf("nest"), near[0].sender);
  EXPECT_EQ((Bluetooth::Payload{7, 255}), near[0].payload);
  const Span<const WifiMessage> all = bench.reading<WifiReceived>().messages;
  ASSERT_EQ(2U, all.size()) << "it does not hear itself";
  EXPECT_EQ(addressOf("far"), all[1].sender);
  EXPECT_EQ(9, all[1].payload[0]);
}

TEST(MockRangeAndBearing, IsAnsweredByBeaconsThatDo) {
  World world;
  world.beacons.push_back({"nest", {0.6, 0.8, 0.0}, colors::kGreen, false, {}, 0.0, 1000.0, true});
  Bench bench(std::vector<std::string>{"range_and_bearing", "range_and_bearing_received"}, world);
  const RangeAndBearingReceived& received = bench.reading<RangeAndBearingReceived>();
  bench.advance(kStep);
  EXPECT_EQ(0U, received.messages.size()) << "nothing was said";
  RangeAndBearing::Payload said{1, 0xF0};
  bench.command<RangeAndBearing>().send(said);
  bench.advance(kStep);
  ASSERT_EQ(1U, received.messages.size());
  EXPECT_NEAR(1.0, received.messages[0].range, 1e-6);
  EXPECT_EQ((std::array<std::uint8_t, 3>{0xFE, 0x0F, 0xFF}),
            (std::array<std::uint8_t, 3>{received.messages[0].payload[0], received.messages[0].payload[1],
                                         received.messages[0].payload[2]}));
  bench.command<RangeAndBearing>().fallSilent();
  bench.advance(kStep);
  EXPECT_EQ(0U, received.messages.size());
}

TEST(MockRadios, AreAnsweredByTheRobotThatTheyTalkTo) {
  World world;
  world.beacons.push_back({"nest", {0.6, 0.8, 0.0}, colors::kGreen, false, {}, 0.0, 1000.0, true});
  Bench bench(std::vector<std::string>{"wifi", "wifi_received"}, world);
  const auto answersTo = [&bench](RadioAddress to) {
    bench.command<Wifi>().send({1}, to);
    bench.advance(kStep);
    return bench.reading<WifiReceived>().messages.size();
  };
  EXPECT_EQ(1U, answersTo(kEverybody));
  EXPECT_EQ(addressOf("nest"), bench.reading<WifiReceived>().messages[0].sender);
  EXPECT_EQ(1U, answersTo(addressOf("nest")));
  EXPECT_EQ(0U, answersTo(addressOf("another")));
}

TEST(MockAntenna, ReadsAndWritesTheTagsInReachTheNearestFirst) {
  World world;
  world.tags = {{{0.05, 0.0}, 20, 5}, {{0.01, 0.0}, 7, 1234}, {{0.3, 0.0}, 9, 0}};
  Bench bench({"differential_drive", "rfid_reader", "rfid_writer"}, world);
  bench.advance(kStep);
  const RfidReader& reader = bench.reading<RfidReader>();
  ASSERT_EQ(2U, reader.tags.size());
  EXPECT_EQ(7U, reader.tags[0].id);
  EXPECT_EQ(1234U, reader.tags[0].data);
  EXPECT_EQ(20U, reader.tags[1].id);
  bench.command<RfidWriter>().write(99);
  bench.advance(kStep);
  EXPECT_EQ(99U, reader.tags[0].data);
  bench.command<RfidWriter>().write(98, 20);
  bench.advance(kStep);
  EXPECT_EQ(98U, reader.tags[1].data);
  bench.command<RfidWriter>().write(97, 9);
  bench.command<DifferentialDrive>().drive(0.15, 0.0);
  bench.advance(1.0);
  EXPECT_EQ(0U, reader.tags.size()) << "between the tags";
  bench.advance(1.0);
  ASSERT_EQ(1U, reader.tags.size());
  EXPECT_EQ(97U, reader.tags[0].data);
}

TEST(MockRobotOfAnyType, UsesUpItsBatteryAndMoreOfItInMotion) {
  Bench bench(std::vector<std::string>{"differential_drive", "battery"});
  const Battery& battery = bench.reading<Battery>();
  EXPECT_EQ(1.0F, battery.fraction());
  EXPECT_EQ(3.7F, battery.voltage);
  bench.advance(10.0);
  EXPECT_NEAR(133200.0F - 32.0F, battery.charge, 0.05F) << "3.2 W";
  bench.command<DifferentialDrive>().drive(0.1, 0.0);
  bench.advance(10.0);
  EXPECT_NEAR(7.2F, battery.power, 1e-5F);
  EXPECT_NEAR(133200.0F - 104.0F, battery.charge, 0.5F) << "7.2 W, but for the first moment of the motion";
}

/// The simulator's sensor has the same law: its own test compares it with the same formula.
TEST(MockRobotOfAnyType, FeelsTheLightOfBeacons) {
  Bench bench(std::vector<std::string>{Light::kType}, worldWith({"lamp", {0.0, 0.535, 0.0}, colors::kWhite, false}));
  const Light& light = bench.reading<Light>();
  ASSERT_EQ(8U, light.sensors.size());
  EXPECT_NEAR(M_PI / 2.0, light.sensors[2].angle, 1e-6);
  EXPECT_NEAR(0.04F, light.sensors[2].value, 1e-6F) << "0.5 m straight ahead of it";
  // 45 degrees aside the sensor is 0.510851 m away from the beacon, which it sees at a cosine of 0.672020
  EXPECT_NEAR(0.0257510F, light.sensors[1].value, 1e-6F);
  EXPECT_NEAR(0.0257510F, light.sensors[3].value, 1e-6F);
  EXPECT_EQ(0.0F, light.sensors[0].value);
  EXPECT_EQ(0.0F, light.sensors[6].value);
  bench.robot->place({{0.0, -1.6, 0.0}, 0.0});
  EXPECT_EQ(0.0F, light.sensors[2].value) << "2.1 m away";
}

World worldThatSounds() {
  World world;
  world.beacons.push_back({"mute", {0.5, 0.0, 0.0}, colors::kRed, false});
  world.beacons.push_back({"horn", {0.6, 0.8, 0.5}, colors::kGreen, false, {}, 70.0, 440.0});
  world.beacons.push_back({"siren", {-4.9, 0.0, 0.0}, colors::kGreen, false, {}, 80.0, 990.0});
  return world;
}

/// The levels are 10 lg of the sum of 10^(L / 10) / d^2 over horn, siren and 30 dB.
TEST(MockRobotOfAnyType, HearsBeaconsThatSound) {
  World world = worldThatSounds();
  world.ring = {3, 0.05};
  Bench bench(std::vector<std::string>{Microphones::kType}, world);
  const Microphones& heard = bench.reading<Microphones>();
  ASSERT_EQ(3U, heard.sensors.size());
  EXPECT_NEAR(70.957954, heard.sensors[0].level, 1e-5);
  EXPECT_NEAR(70.952031, heard.sensors[1].level, 1e-5);
  EXPECT_NEAR(70.646851, heard.sensors[2].level, 1e-5);
  EXPECT_NEAR(-0.025, heard.sensors[1].x, 1e-6);
  EXPECT_NEAR(0.0433013, heard.sensors[1].y, 1e-6);
  EXPECT_NEAR(0.927295, heard.loudest.bearing, 1e-6);
  EXPECT_NEAR(0.657574, heard.loudest.confidence, 1e-6);
  EXPECT_EQ(440.0F, heard.loudest.frequency);
}

TEST(MockRobotOfAnyType, HearsNothingFromAfar) {
  Bench bench(std::vector<std::string>{FootbotMicrophones::kType}, worldThatSounds());
  bench.robot->place({{5.0, -3.0, 0.0}, 1.0});
  const FootbotMicrophones& heard = bench.reading<FootbotMicrophones>();
  for (const float level : heard.level) {
    EXPECT_NEAR(30.0, level, 1e-5);
  }
  EXPECT_EQ(0.0F, heard.loudest.frequency);
  bench.robot->place({{2.0, -1.0, 0.0}, 1.0});
  EXPECT_NEAR(1.231839, heard.loudest.bearing, 1e-6) << "1.8 to the left and 1.4 behind, before it turns";
  EXPECT_EQ(440.0F, heard.loudest.frequency);
}

TEST(MockRobotOfAnyType, ReadsTheFloorUnderIt) {
  World world = worldWithDiscs();
  world.ring = {5, 0.05};
  Bench bench(std::vector<std::string>{Ground::kType}, world);
  bench.robot->place({{0.13, 0.27, 0.0}, 0.83});
  const Ground& ground = bench.reading<Ground>();
  ASSERT_EQ(5U, ground.sensors.size());
  EXPECT_NEAR(0.05 * std::cos(0.4 * M_PI), ground.sensors[1].x, 1e-7);
  EXPECT_NEAR(0.05 * std::sin(0.4 * M_PI), ground.sensors[1].y, 1e-7);
  const float expected[] = {128.0F / 255.0F, 1.0F, 1.0F / 3.0F, 1.0F / 3.0F, 128.0F / 255.0F};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(expected[i], ground.sensors[i].value, 1e-6) << i;
  }
  bench.robot->place({{0.13, 0.27, 0.049}, 0.83});
  EXPECT_EQ(1.0F, ground.sensors[1].value);
  bench.robot->place({{0.13, 0.27, 0.051}, 0.83});
  EXPECT_EQ(0.0F, ground.sensors[1].value) << "too high over it";
}

TEST(MockRobotOfAnyType, ReadsTheColourOfTheFloorUnderIt) {
  Bench bench(std::vector<std::string>{FloorColor::kType}, worldWithDiscs());
  const FloorColor& floor = bench.reading<FloorColor>();
  for (const auto& [x, color] : {std::pair(0.06, colors::kGreen), std::pair(0.144, colors::kGreen),
                                 std::pair(0.146, colors::kGray), std::pair(0.231, colors::kWhite)}) {
    bench.robot->place({{x, 0.25, 0.0}, 0.83});
    EXPECT_EQ(color, floor.color) << x;
  }
  bench.robot->place({{0.1, 0.25, 0.051}, 0.83});
  EXPECT_EQ(colors::kBlack, floor.color) << "too high over it";
}

TEST(MockRobotOfAnyType, FeelsGravityAndItsOwnTurning) {
  Bench bench(std::vector<std::string>{Imu::kType, DifferentialDrive::kType});
  const Imu& imu = bench.reading<Imu>();
  EXPECT_EQ(0.0, imu.angular_velocity.norm());
  EXPECT_EQ(Eigen::Vector3d(0.0, 0.0, 9.81), imu.linear_acceleration);
  bench.command<DifferentialDrive>().drive(0.2, -1.5);
  bench.advance(0.1);
  EXPECT_EQ(Eigen::Vector3d(0.0, 0.0, -1.5), imu.angular_velocity);
  EXPECT_NEAR(-0.3, imu.linear_acceleration.y(), 1e-12) << "speed times turn rate, to the right";
  EXPECT_NEAR(0.0, imu.linear_acceleration.x(), 1e-12);
  EXPECT_NEAR(9.81, imu.linear_acceleration.z(), 1e-12);
}

TEST(MockRobotOfAnyType, TurnsItsJoints) {
  World world;
  world.joints = {3, 1.5};
  Bench bench(std::vector<std::string>{Joints::kType, JointStates::kType}, world);
  const Span<const JointStates::Joint> joints = bench.reading<JointStates>().joints;
  ASSERT_EQ(3U, joints.size());
  bench.command<Joints>().joints[0].holdAngle(0.7);
  bench.command<Joints>().joints[1].turnAt(-0.4);
  bench.command<Joints>().joints[2].turnAt(9.0);
  bench.advance(0.2);
  EXPECT_NEAR(0.3, joints[0].angle, 1e-9) << "at 1.5 rad/s";
  EXPECT_NEAR(-0.08, joints[1].angle, 1e-9);
  EXPECT_NEAR(0.3, joints[2].angle, 1e-9) << "no faster than its motor";
  EXPECT_NEAR(1.5, joints[2].speed, 1e-9);
  bench.command<Joints>().joints[2].letTurn();
  bench.advance(0.4);
  EXPECT_NEAR(0.7, joints[0].angle, 1e-9);
  EXPECT_NEAR(-0.24, joints[1].angle, 1e-9);
  EXPECT_NEAR(0.3, joints[2].angle, 1e-9);
  EXPECT_EQ(0.0, joints[2].speed);
  EXPECT_EQ(0.0, joints[0].effort);
}

TEST(MockRobotOfAnyType, HoldsAndWinds) {
  World world;
  world.holders = {2, 1.6};
  Bench bench(std::vector<std::string>{Holders::kType, HolderStates::kType}, world);
  const Span<const HolderStates::Holder> holders = bench.reading<HolderStates>().holders;
  ASSERT_EQ(2U, holders.size());
  bench.command<Holders>().holders[1].holds = true;
  bench.advance(0.1);
  EXPECT_FALSE(holders[0].is_holding);
  EXPECT_TRUE(holders[1].is_holding);
  EXPECT_NEAR(1.6, holders[1].length, 1e-9);
  EXPECT_GT(holders[1].force, 0.0);
  bench.command<Holders>().holders[1].winding_speed = 0.15;
  bench.advance(2.0);
  EXPECT_NEAR(1.3, holders[1].length, 1e-9);
  bench.command<Holders>().holders[1].winding_speed = -5.0;
  bench.advance(1.0);
  EXPECT_NEAR(1.5, holders[1].length, 1e-9) << "at 0.2 m/s";
  bench.advance(1.0);
  EXPECT_NEAR(1.6, holders[1].length, 1e-9) << "there is no more on the winch";
  bench.command<Holders>().holders[1].holds = false;
  bench.advance(0.1);
  EXPECT_FALSE(holders[1].is_holding);
  EXPECT_EQ(0.0, holders[1].length);
}

}  // namespace
}  // namespace swarmanoid::mock
