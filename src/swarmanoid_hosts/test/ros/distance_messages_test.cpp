// Converts distance sensors and the rotating scanner to messages and back. Distances need not be finite (REP-117).
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "message_bench.hpp"
#include "swarmanoid_hosts/ros/device_fields.hpp"
#include "swarmanoid_hosts/ros/devices/distance.hpp"
#include "swarmanoid_hosts/ros/devices/footbot_scanner.hpp"
#include "swarmanoid_hosts/ros/devices/lidar.hpp"

namespace swarmanoid {
namespace {

using test::bytesOf;
using test::expectNothingLost;
using test::refusalOf;

constexpr float kNothing = std::numeric_limits<float>::infinity();
constexpr float kNotMeasured = std::numeric_limits<float>::quiet_NaN();

TEST(DistanceMessages, KeepThoseOfAnyRobot) {
  const std::array<DistanceReading, 3> sensors{DistanceReading{0.25F, 0.5F, -0.125F},
                                               DistanceReading{kNothing, -3.0F, 1.0F},
                                               DistanceReading{-kNothing, 0.0F, 0.0F}};
  Distance distance;
  distance.range_max = 2.5F;
  distance.sensors = Span<const DistanceReading>(sensors.data(), sensors.size());
  swarmanoid_msgs::RangeArray message;
  toMessage(distance, message);
  EXPECT_EQ(sensor_msgs::Range::INFRARED, message.radiation_type);
  EXPECT_EQ(0.1F, message.min_range);
  EXPECT_EQ(2.5F, message.max_range);
  EXPECT_EQ(message.ranges, (std::vector<float>{0.25F, kNothing, -kNothing}));
  EXPECT_EQ(message.elevations, (std::vector<float>{-0.125F, 1.0F, 0.0F}));
  Distance back;
  VariableParts parts;
  detail::receive(message, back, parts);
  EXPECT_EQ(bytesOf("distances", &distance), bytesOf("distances", &back));
  message.angles.pop_back();
  EXPECT_EQ("found 2 angles, 3 elevations and 3 ranges, allowed: as many of each, at most 64",
            refusalOf(message, distance));
  toMessage(distance, message);
  message.angles[1] = kNotMeasured;
  EXPECT_EQ("found a number that is not finite, allowed: finite numbers", refusalOf(message, distance))
      << "distances alone need not be";
}

TEST(DistanceMessages, KeepThoseOfEyebotsAndHandbots) {
  EyebotDistance eyebot;
  eyebot.around[3] = 0.75F;
  eyebot.around[4] = kNothing;
  eyebot.up = -kNothing;
  eyebot.down = 1.125F;
  eyebot.range_min = 0.25F;
  expectNothingLost<swarmanoid_msgs::RangeArray>(eyebot);
  swarmanoid_msgs::RangeArray message;
  toMessage(eyebot, message);
  ASSERT_EQ(18U, message.ranges.size());
  EXPECT_EQ(1.125F, message.ranges[17]);
  EXPECT_FLOAT_EQ(static_cast<float>(-M_PI / 2.0), message.elevations[17]);
  EXPECT_FLOAT_EQ(static_cast<float>(M_PI / 8.0), message.angles[1]);
  HandbotDistance handbot;
  handbot.distance[11] = 0.125F;
  expectNothingLost<swarmanoid_msgs::RangeArray>(handbot);
  EXPECT_EQ("found 18 ranges, allowed: 12", refusalOf(message, handbot));
}

TEST(DistanceMessages, KeepTheScanner) {
  FootbotScanner scanner;
  scanner.turnAt(1.75);
  expectNothingLost<swarmanoid_msgs::ScannerCommand>(scanner);
  scanner.holdAngle(-0.5);
  expectNothingLost<swarmanoid_msgs::ScannerCommand>(scanner);
  swarmanoid_msgs::ScannerCommand command;
  command.mode = 3;
  EXPECT_EQ("found mode 3, allowed: 0 (OFF), 1 (SPEED), 2 (ANGLE)", refusalOf(command, scanner));
  command.mode = 1;
  command.speed = std::numeric_limits<double>::infinity();
  EXPECT_EQ("found a number that is not finite, allowed: finite numbers", refusalOf(command, scanner));
  FootbotScannerReadings readings;
  readings.angle = -1.5;
  readings.period = 0.125F;
  readings.angles[7] = -1.5F;
  readings.short_ahead[1] = 0.25F;
  readings.long_left[2] = kNothing;
  readings.short_behind[3] = -kNothing;
  readings.long_right[4] = 1.25F;
  expectNothingLost<swarmanoid_msgs::ScannerReadings>(readings);
}

TEST(DistanceMessages, AScanHasEachSampleWhereItsBeamLooked) {
  FootbotScannerReadings readings;
  readings.period = 0.1F;
  for (std::size_t i = 0; i < FootbotScannerReadings::kSamples; ++i) {
    readings.angles[i] = 0.05F + 0.07F * static_cast<float>(i);
    readings.short_ahead[i] = kNothing;
    readings.long_left[i] = 0.5F + 0.0625F * static_cast<float>(i);
    readings.short_behind[i] = 0.125F;
    readings.long_right[i] = kNothing;
  }
  readings.short_ahead[2] = -kNothing;
  sensor_msgs::LaserScan scan;
  toMessage(readings, scan);
  ASSERT_EQ(360U, scan.ranges.size());
  EXPECT_FLOAT_EQ(0.1F, scan.scan_time);
  EXPECT_EQ(0.04F, scan.range_min);
  EXPECT_EQ(1.5F, scan.range_max);
  const auto at = [&](double angle) {
    const double bin = std::remainder(angle - static_cast<double>(scan.angle_min), 2.0 * M_PI) / scan.angle_increment;
    return scan.ranges[static_cast<std::size_t>(std::lround(bin) + 360) % 360];
  };
  for (std::size_t i = 0; i < FootbotScannerReadings::kSamples; ++i) {
    const double head = 0.05 + 0.07 * static_cast<double>(i);
    EXPECT_EQ(readings.long_left[i], at(head + M_PI / 2.0)) << i;
    EXPECT_EQ(kNothing, at(head - M_PI / 2.0)) << i;
    EXPECT_EQ(0.125F, at(head + M_PI)) << i;
    EXPECT_EQ(i == 2, at(head) == -kNothing) << i;
    EXPECT_EQ(i != 2, std::isnan(at(head))) << i << ": a short beam does not say that nothing is there";
  }
  EXPECT_EQ(360 - 25, std::count_if(scan.ranges.begin(), scan.ranges.end(), [](float x) { return std::isnan(x); }));
  EXPECT_EQ("found a scan, allowed: the readings of the beams, of which a scan is made", refusalOf(scan, readings));
}

TEST(DistanceMessages, WhereTwoSamplesFallTogetherTheNearerCounts) {
  FootbotScannerReadings readings;
  readings.long_left.fill(kNothing);
  readings.long_left[3] = 0.5F;
  readings.long_left[4] = -kNothing;
  readings.long_left[5] = 0.25F;
  readings.long_left[6] = 0.75F;
  sensor_msgs::LaserScan scan;
  toMessage(readings, scan);
  EXPECT_EQ(0.25F, scan.ranges[270]);
}

TEST(DistanceMessages, AScanOfALidarIsItsBeams) {
  const std::array<LidarBeam, 5> beams{LidarBeam{0.25F, -1.0F}, LidarBeam{kNothing, -0.5F}, LidarBeam{-kNothing, 0.0F},
                                       LidarBeam{kNotMeasured, 0.5F}, LidarBeam{1.75F, 1.0F}};
  Lidar lidar;
  lidar.beams = Span<const LidarBeam>(beams.data(), beams.size());
  lidar.range_max = 2.5F;
  lidar.scan_time = 0.2F;
  sensor_msgs::LaserScan scan;
  toMessage(lidar, scan);
  EXPECT_EQ(-1.0F, scan.angle_min);
  EXPECT_EQ(1.0F, scan.angle_max);
  EXPECT_EQ(0.5F, scan.angle_increment);
  EXPECT_EQ(0.0F, scan.time_increment);
  EXPECT_EQ(0.2F, scan.scan_time);
  EXPECT_EQ(0.12F, scan.range_min);
  EXPECT_EQ(2.5F, scan.range_max);
  ASSERT_EQ(5U, scan.ranges.size());
  EXPECT_EQ(0.25F, scan.ranges[0]);
  EXPECT_EQ(-kNothing, scan.ranges[2]);
  EXPECT_TRUE(std::isnan(scan.ranges[3]));
  Lidar back;
  VariableParts parts;
  detail::receive(scan, back, parts);
  EXPECT_EQ(bytesOf(Lidar::kType, &lidar), bytesOf(Lidar::kType, &back));
  scan.angle_increment = kNotMeasured;
  EXPECT_EQ("found a number that is not finite, allowed: finite numbers", refusalOf(scan, lidar));
  scan.ranges.resize(4097);
  EXPECT_EQ("found 4097 ranges, allowed: at most 4096", refusalOf(scan, lidar));
}

/// The stamp of its message is the time of the scan.
TEST(DistanceMessages, ALidarSaysHowOldItsScanIs) {
  Lidar lidar;
  lidar.age = 0.3;
  EXPECT_EQ(0.3, mainTopicOf(Lidar::kType)->age(&lidar));
  EXPECT_EQ(nullptr, mainTopicOf(Distance::kType)->age) << "always of now";
  const DeviceTopic& topic = *mainTopicOf(Lidar::kType);
  const ros::Time now(2, 500000000);
  EXPECT_EQ(ros::Time(2, 200000000), madeAt(topic, &lidar, now));
  for (const double wrong : {-1.0, static_cast<double>(kNotMeasured)}) {
    lidar.age = wrong;
    EXPECT_EQ(now, madeAt(topic, &lidar, now)) << wrong;
  }
  lidar.age = 99.0;
  EXPECT_EQ(ros::Time(0, 0), madeAt(topic, &lidar, now));
  EXPECT_EQ(now, madeAt(*mainTopicOf(Distance::kType), &lidar, now));
}

/// Drivers count from 0 to 2 pi, or downwards, and send 0 for beams without a return.
TEST(DistanceMessages, BeamsOfDriversAreOrderedFromTheBackRoundToTheBack) {
  sensor_msgs::LaserScan scan;
  scan.range_min = 0.12F;
  scan.range_max = 3.5F;
  scan.angle_increment = static_cast<float>(0.4 * M_PI);
  scan.ranges = {1.0F, 0.0F, 3.0F, 4.0F, 0.5F};  // at 0, 72, 144, 216, 288 degrees
  Lidar lidar;
  VariableParts parts;
  detail::receive(scan, lidar, parts);
  ASSERT_EQ(5U, lidar.beams.size());
  const std::array<double, 5> angles{-0.8 * M_PI, -0.4 * M_PI, 0.0, 0.4 * M_PI, 0.8 * M_PI};
  const std::array<float, 5> ranges{kNothing, 0.5F, 1.0F, -kNothing, 3.0F};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(angles[i], lidar.beams[i].angle, 1e-6) << i;
    EXPECT_EQ(ranges[i], lidar.beams[i].range) << i;
  }
  // the same, from the left to the right
  scan.angle_min = static_cast<float>(0.8 * M_PI);
  scan.angle_increment = -scan.angle_increment;
  scan.ranges = {3.0F, 0.0F, 1.0F, 0.5F, 4.0F};
  Lidar downwards;
  VariableParts own_parts;
  detail::receive(scan, downwards, own_parts);
  ASSERT_EQ(5U, downwards.beams.size());
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(angles[i], downwards.beams[i].angle, 1e-6) << i;
    EXPECT_EQ(ranges[i], downwards.beams[i].range) << i;
  }
  // a whole turn of the simulator stays as it is
  scan.angle_min = static_cast<float>(-M_PI);
  scan.angle_increment = static_cast<float>(0.5 * M_PI);
  scan.ranges = {1.0F, 2.0F, 3.0F, 0.5F};
  detail::receive(scan, lidar, parts);
  EXPECT_EQ(1.0F, lidar.beams[0].range);
  EXPECT_EQ(static_cast<float>(-M_PI), lidar.beams[0].angle);
}

/// The same for messages of fields by name.
TEST(DistanceMessages, FieldsByNameNeedNotBeFiniteIfTheyAreDistances) {
  HandbotDistance handbot;
  handbot.distance[3] = kNothing;
  handbot.distance[4] = 0.25F;
  const DeviceType& type = *findDeviceType(HandbotDistance::kType);
  swarmanoid_msgs::DeviceFields message;
  toMessage(type, &handbot, message);
  HandbotDistance back;
  VariableParts parts;
  fromMessage(message, type, &back, parts);
  EXPECT_EQ(bytesOf(HandbotDistance::kType, &handbot), bytesOf(HandbotDistance::kType, &back));
  message.values.back() = std::numeric_limits<double>::infinity();  // range_max
  EXPECT_THROW(fromMessage(message, type, &back, parts), std::runtime_error);
}

}  // namespace
}  // namespace swarmanoid
