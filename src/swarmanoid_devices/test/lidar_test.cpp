// Lidar: each beam reads the distance along its direction, by REP-117; scans have their own rate and keep their noise.
#include "swarmanoid_interface/devices/lidar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"
#include "swarmanoid_space/device_drawing.hpp"

namespace swarmanoid::test {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();

Eigen::Quaterniond turned(double yaw, double pitch = 0.0) {
  return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY());
}

/// A footbot with a link `lidar`.
std::shared_ptr<const EntityModel> robotWithLidar(const Mount& mount = {{0.03, -0.02, 0.1}, turned(0.25), -1}) {
  auto model = std::make_shared<EntityModel>(*robotModel("footbot"));
  model->type = "surveyor";
  model->mounts[Lidar::kLink] = mount;
  return model;
}

std::string refusalOfParameters(const Parameters& parameters) {
  try {
    makeDevice<Sensor>(PluginKind::kSensor, Lidar::kType, parameters);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

/// The mount is at (2.0352021, 2.9922019) and looks to 0.62 rad; the wall's face is at x = 2.95, from y = 1 to 5.
TEST(LidarTest, ReadsAWallByTheAngleOfEachBeam) {
  DeviceWorld world;
  const Row robot = world.add(robotWithLidar(), {2.0, 3.0, 0.0}, 0.37);
  world.addWall({0.1, 4.0, 0.5}, {3.0, 3.0});
  SensorUnderTest<Lidar> sensor(world, robot, {{"beams", "9"}, {"field_of_view", "200"}, {"range_max", "2"}});
  const Lidar& lidar = sensor.sense();
  ASSERT_EQ(9U, lidar.beams.size());
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_NEAR((-100.0 + 25.0 * static_cast<double>(i)) * kDegree, lidar.beams[i].angle, 1e-6);
  }
  EXPECT_EQ(kNothing, lidar.beams[0].range) << "2.123 m";
  EXPECT_NEAR(1.1851492, lidar.beams[1].range, 1e-6);
  EXPECT_NEAR(0.9447954, lidar.beams[2].range, 1e-6);
  EXPECT_NEAR(0.9304476, lidar.beams[3].range, 1e-6);
  EXPECT_NEAR(1.1239981, lidar.beams[4].range, 1e-6);
  EXPECT_NEAR(1.8590871, lidar.beams[5].range, 1e-6);
  EXPECT_EQ(kNothing, lidar.beams[6].range) << "11.7 m";
  EXPECT_EQ(kNothing, lidar.beams[7].range) << "looks away";
  EXPECT_EQ(0.12F, lidar.range_min);
  EXPECT_EQ(2.0F, lidar.range_max);
  EXPECT_EQ(0.1F, lidar.scan_time);
  EXPECT_EQ(0.0, lidar.age);
  world.pose(robot).position.x() += 0.79;
  EXPECT_NEAR(0.1288902, sensor.sense().beams[2].range, 1e-6) << "0.1247979 m / cos 0.2526646";
  world.pose(robot).position.x() += 0.01;
  EXPECT_EQ(-kNothing, sensor.sense().beams[2].range) << "0.1186 m";
}

TEST(LidarTest, AWholeTurnHasNoBeamTwiceAndASingleBeamLooksAhead) {
  DeviceWorld world;
  SensorUnderTest<Lidar> around(world, world.add(robotWithLidar(), {2.0, 3.0, 0.0}), {{"beams", "8"}});
  const Lidar& lidar = around.sense();
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NEAR(-M_PI + static_cast<double>(i) * M_PI / 4.0, lidar.beams[i].angle, 1e-6);
  }
  SensorUnderTest<Lidar> single(world, world.add(robotWithLidar(), {6.0, 3.0, 0.0}), {{"beams", "1"}});
  ASSERT_EQ(1U, single.sense().beams.size());
  EXPECT_EQ(0.0F, single.sense().beams[0].angle);
  SensorUnderTest<Lidar> usual(world, world.add(robotWithLidar(), {8.0, 3.0, 0.0}));
  EXPECT_EQ(360U, usual.sense().beams.size());
  EXPECT_EQ(3.5F, usual.sense().range_max);
}

/// For any number of beams and any field of view, each beam equals a single ray.
TEST(LidarTest, AllBeamsAreThoseThatAreCastOneByOne) {
  DeviceWorld world;
  const Row robot = world.add(robotWithLidar({{0.05, 0.01, 0.12}, turned(-0.4, 0.03), -1}), {5.0, 5.0, 0.3}, 0.7);
  for (int i = 0; i < 40; ++i) {
    const double way = 0.5 + 0.08 * i;
    world.addPrey(5.0 + way * std::cos(2.3 * i), 5.0 + way * std::sin(2.3 * i), colors::kBlack, 0.05, 0.8);
  }
  world.addWall({6.0, 0.1, 1.0}, {5.0, 8.0});
  world.takePoses();
  const Pose& pose = world.pose(robot);
  const Eigen::Vector3d from = pose.toWorld({0.05, 0.01, 0.12});
  std::size_t hits = 0;
  for (const char* beams : {"1", "2", "8", "63", "64", "65", "360", "1000", "4096"}) {
    for (const char* view : {"7", "89", "91", "179", "181", "270", "360"}) {
      auto sensor = makeDevice<Sensor>(PluginKind::kSensor, Lidar::kType, {{"beams", beams}, {"field_of_view", view}});
      const auto& lidar = *static_cast<const Lidar*>(sensor->add(world.space, robot));
      world.sense(*sensor);
      for (const LidarBeam& beam : lidar.beams) {
        const Eigen::Vector3d direction =
            pose.orientation * (turned(-0.4, 0.03) * (turned(beam.angle) * Eigen::Vector3d::UnitX()));
        const RayHit hit = world.space.castRay({from, from + 3.5 * direction}, robot, kNoRow);
        const float expected = hit.isHit() ? Distance::reading(3.5 * hit.fraction, Lidar::kUsualRange) : kNothing;
        // angles are rounded to float, so beams at grazing incidence may miss
        if (std::isfinite(expected) && std::isfinite(beam.range)) {
          EXPECT_NEAR(expected, beam.range, 1e-3) << beams << " beams, " << view << " degrees, " << beam.angle;
          ++hits;
        } else {
          EXPECT_EQ(expected, beam.range) << beams << " beams, " << view << " degrees, " << beam.angle;
        }
      }
      sensor->remove(world.space, robot);
    }
  }
  EXPECT_GT(hits, 15000U);
}

TEST(LidarTest, ATiltedMountSeesTheFloor) {
  DeviceWorld world;
  const Row robot = world.add(robotWithLidar({{0.0, 0.0, 0.3}, turned(0.0, 0.5), -1}), {2.0, 3.0, 0.0}, 1.1);
  SensorUnderTest<Lidar> sensor(world, robot, {{"beams", "3"}, {"field_of_view", "120"}});
  const Lidar& lidar = sensor.sense();
  EXPECT_NEAR(0.3 / std::sin(0.5), lidar.beams[1].range, 1e-6);
  // a beam at 60 degrees descends half as steeply
  EXPECT_NEAR(0.6 / std::sin(0.5), lidar.beams[0].range, 1e-6);
  EXPECT_NEAR(0.6 / std::sin(0.5), lidar.beams[2].range, 1e-6);
}

/// Readings of a lidar in the centre of a room of 4 m by 3 m, tick by tick.
std::vector<std::vector<double>> readingsInARoom(const Parameters& parameters, int ticks, std::uint64_t seed = 1) {
  DeviceWorld world(seed);
  const Row robot = world.add(robotWithLidar(), {5.0, 5.0, 0.0}, 0.37);
  for (const double side : {-1.0, 1.0}) {
    world.addWall({0.1, 4.0, 0.5}, {5.0 + side * 2.05, 5.0});
    world.addWall({4.0, 0.1, 0.5}, {5.0, 5.0 + side * 1.55});
  }
  SensorUnderTest<Lidar> sensor(world, robot, parameters);
  std::vector<std::vector<double>> readings;
  for (int k = 0; k < ticks; ++k) {
    std::vector<double>& scan = readings.emplace_back();
    for (const LidarBeam& beam : sensor.sense().beams) {
      scan.push_back(beam.range);
    }
    ++world.space.tick;
    world.space.time += world.space.clocktick;
  }
  return readings;
}

TEST(LidarTest, NoiseIsNormalOfItsOwnForEachBeamAndTick) {
  constexpr int kTicks = 100;
  const auto exact = readingsInARoom({}, 1).front();
  const auto noisy = readingsInARoom({{"noise", "0.02"}}, kTicks);
  std::vector<double> errors;
  double with_neighbour = 0.0;
  double with_next_tick = 0.0;
  int outer = 0;
  for (int k = 0; k < kTicks; ++k) {
    for (std::size_t i = 0; i < exact.size(); ++i) {
      errors.push_back(noisy[k][i] - exact[i]);
      outer += std::abs(errors.back()) > 2.0 * 0.02 ? 1 : 0;
      with_neighbour += i > 0 ? errors.back() * (noisy[k][i - 1] - exact[i - 1]) : 0.0;
      with_next_tick += k > 0 ? errors.back() * (noisy[k - 1][i] - exact[i]) : 0.0;
    }
  }
  const auto count = static_cast<double>(errors.size());
  const Statistics statistics(errors);
  EXPECT_NEAR(0.0, statistics.mean, 4.0 * 0.02 / std::sqrt(count));
  EXPECT_NEAR(0.02, statistics.deviation, 4.0 * 0.02 / std::sqrt(2.0 * count));
  EXPECT_NEAR(0.0455, outer / count, 4.0 * std::sqrt(0.0455 / count)) << "beyond two standard deviations";
  EXPECT_NEAR(0.0, with_neighbour / count, 4.0 * 0.0004 / std::sqrt(count));
  EXPECT_NEAR(0.0, with_next_tick / count, 4.0 * 0.0004 / std::sqrt(count));
  EXPECT_EQ(noisy, readingsInARoom({{"noise", "0.02"}}, kTicks)) << "of the seed alone";
  EXPECT_NE(noisy, readingsInARoom({{"noise", "0.02"}}, kTicks, 2));
}

TEST(LidarTest, NoiseLeavesInfinitiesAndTheRange) {
  const auto noisy = readingsInARoom({{"noise", "0.5"}, {"range_min", "1.6"}, {"range_max", "1.9"}}, 20);
  const auto exact = readingsInARoom({{"range_min", "1.6"}, {"range_max", "1.9"}}, 1).front();
  int finite = 0;
  for (const auto& scan : noisy) {
    for (std::size_t i = 0; i < exact.size(); ++i) {
      if (std::isinf(exact[i])) {
        EXPECT_EQ(exact[i], scan[i]);
      } else if (std::isfinite(scan[i])) {
        EXPECT_GE(scan[i], static_cast<double>(1.6F));
        EXPECT_LE(scan[i], static_cast<double>(1.9F));
        ++finite;
      }
    }
  }
  EXPECT_GT(finite, 100);
}

/// Four scans and ten ticks a second: scans at 1.0, 1.3 (for 1.25), 1.5, 1.8 (for 1.75), 2.0, ...
TEST(LidarTest, ScansComeAtTheirRateAndKeepTheirNoiseAndTheirAge) {
  DeviceWorld world;
  const Row robot = world.add(robotWithLidar({{0.0, 0.0, 0.1}, turned(0.0), -1}), {2.0, 3.0, 0.0});
  world.addWall({0.1, 4.0, 0.5}, {4.05, 3.0});
  SensorUnderTest<Lidar> sensor(world, robot, {{"beams", "1"}, {"rate", "4"}, {"noise", "0.001"}});
  const int taken[] = {0, 0, 0, 3, 3, 5, 5, 5, 8, 8, 10, 10, 10, 13};
  double last = 0.0;
  for (int k = 0; k < 14; ++k) {
    world.space.tick = static_cast<std::uint64_t>(k);
    world.space.time = Time(std::chrono::milliseconds(1000 + 100 * k));
    world.pose(robot).position.x() = 2.0 + 0.1 * k;
    const double range = sensor.sense().beams[0].range;
    EXPECT_NEAR(2.0 - 0.1 * taken[k], range, 0.005) << "tick " << k;
    EXPECT_NEAR(0.1 * (k - taken[k]), sensor.sense().age, 1e-12) << "tick " << k;
    EXPECT_EQ(taken[k] != k, range == last) << "tick " << k;
    EXPECT_EQ(range, sensor.sense().beams[0].range) << "sensed again";
    EXPECT_EQ(0.25F, sensor.sense().scan_time);
    last = range;
  }
}

TEST(LidarTest, ANewRobotScansAtOnceAndATickThatIsSensedAgainScansAgain) {
  DeviceWorld world;
  const Row robot = world.add(robotWithLidar({{0.0, 0.0, 0.1}, turned(0.0), -1}), {2.0, 3.0, 0.0});
  world.addWall({0.1, 4.0, 0.5}, {4.05, 3.0});
  SensorUnderTest<Lidar> sensor(world, robot, {{"beams", "1"}, {"rate", "4"}});
  const auto rangeAt = [&](int milliseconds, double x) {
    world.space.time = Time(std::chrono::milliseconds(milliseconds));
    world.pose(robot).position.x() = x;
    return sensor.sense().beams[0].range;
  };
  EXPECT_NEAR(2.0, rangeAt(1100, 2.0), 1e-6) << "not due, but its first tick";
  EXPECT_NEAR(1.7, rangeAt(1100, 2.3), 1e-6) << "the robot was moved before the tick went on";
  EXPECT_NEAR(1.7, rangeAt(1200, 2.4), 1e-6);
  EXPECT_NEAR(1.5, rangeAt(1300, 2.5), 1e-6);
  EXPECT_NEAR(1.4, rangeAt(1300, 2.6), 1e-6);
}

TEST(LidarTest, ErrorsActOnEachTickOfAScanThatIsKept) {
  DeviceWorld world;
  const Row robot = world.add(robotWithLidar({{0.0, 0.0, 0.1}, turned(0.0), -1}), {2.0, 3.0, 0.0});
  world.addWall({0.1, 4.0, 0.5}, {4.05, 3.0});
  SensorUnderTest<Lidar> sensor(world, robot, {{"beams", "1"}, {"rate", "1"}}, {bias("beams[].range", "0.25")});
  for (int k = 0; k < 5; ++k) {
    world.space.tick = static_cast<std::uint64_t>(k);
    world.space.time = Time(std::chrono::milliseconds(1000 + 100 * k));
    EXPECT_NEAR(2.25, sensor.sense().beams[0].range, 1e-6) << "tick " << k;
  }
}

TEST(LidarTest, NeedsALinkThatNoJointTurns) {
  EXPECT_EQ("found the device 'lidar' on a footbot, allowed: on robots with a link lidar that no joint turns",
            refusalOf<SensorUnderTest<Lidar>>(robotModel("footbot")));
  EXPECT_EQ("found the device 'lidar' on a surveyor, allowed: on robots with a link lidar that no joint turns",
            refusalOf<SensorUnderTest<Lidar>>(robotWithLidar({{0.0, 0.0, 0.1}, turned(0.0), 0})));
  EXPECT_EQ("range_min: found 0.3, allowed: less than range_max, which is 0.3",
            refusalOfParameters({{"range_min", "0.3"}, {"range_max", "0.3"}}));
}

TEST(LidarTest, DrawsBeamsAsFarAsTheyGet) {
  DeviceWorld world;
  const Row robot = world.add(robotWithLidar(), {2.0, 3.0, 0.0}, 0.37);
  world.addWall({0.1, 4.0, 0.5}, {3.0, 3.0});
  SensorUnderTest<Lidar> sensor(world, robot, {{"beams", "9"}, {"field_of_view", "200"}, {"range_max", "2"}});
  sensor.sense();
  DeviceDrawing drawing{DrawnRobots{}};
  sensor.sensor->draw(world.space, drawing);
  ASSERT_EQ(9U, drawing.lines().size());
  ASSERT_EQ(5U, drawing.points().size()) << "of beams 1 to 5";
  EXPECT_NEAR(0.0, (drawing.points()[2].place - Eigen::Vector3d(2.95, 3.1621359, 0.1)).norm(), 1e-6) << "beam 3";
  EXPECT_NEAR(2.0, (drawing.lines()[8].to - drawing.lines()[8].from).norm(), 1e-9) << "hits nothing";
}

TEST(LidarTest, ASteadyStateAllocatesNothing) {
  if (!SWARMANOID_COUNTS_ALLOCATIONS) {
    GTEST_SKIP() << "a sanitizer counts allocations itself";
  }
  DeviceWorld world;
  const Row robot = world.add(robotWithLidar(), {2.0, 3.0, 0.0}, 0.37);
  world.addWall({0.1, 4.0, 0.5}, {3.0, 3.0});
  SensorUnderTest<Lidar> sensor(world, robot, {{"beams", "1000"}, {"noise", "0.01"}});
  sensor.sense();
  world.space.tick = 1;
  const long before = heap_allocations;
  sensor.sensor->update(world.space, 0, 1);
  EXPECT_EQ(heap_allocations - before, 0);
}

}  // namespace
}  // namespace swarmanoid::test
