// Rings of sensors with readings from tables: the distances and angles that they look up, in worlds computed by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_experiment_files/samples/sampled_sensor.hpp"
#include "swarmanoid_interface/devices/distance.hpp"
#include "swarmanoid_interface/devices/footbot_ground.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/ground.hpp"
#include "swarmanoid_interface/devices/handbot_distance.hpp"
#include "swarmanoid_interface/devices/light.hpp"
#include "swarmanoid_interface/devices/proximity.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kRadius = FootbotProximity::kRingRadius;

class SampledRingTest : public testing::Test {
 protected:
  /// Parameters of a sensor that reads from a table.
  Parameters sampled(const std::string& lines) const {
    const std::string file = (folder_.path() / "table.csv").string();
    std::ofstream(file) << "distance,angle,reading\n" << lines;
    return {{"implementation", "sampled"}, {"file", file}};
  }

  /// Places a wall before sensor 6 of the robot, which looks along x. @param lean rotation of its surface about z [rad]
  void placeWall(Row wall, double distance, double lean) {
    const Eigen::Vector3d inwards(std::cos(lean), std::sin(lean), 0.0);
    Pose& pose = world_.pose(wall);
    pose.orientation = Eigen::AngleAxisd(lean, Eigen::Vector3d::UnitZ());
    pose.position = Eigen::Vector3d(1.0 + kRadius + distance, 1.0, 0.25) + 0.05 * inwards;
  }

  DeviceWorld world_;
  Row robot_ = world_.addFootbot(1.0, 1.0, -M_PI / 2.0);

 private:
  const TemporaryFolder folder_{"sampled_ring_test"};
};

TEST_F(SampledRingTest, ProximityReadsByDistanceAndByTheLeanOfWhatItHits) {
  const Row wall = world_.addWall({0.1, 2.0, 0.5}, {5.0, 1.0});
  SensorUnderTest<FootbotProximity> ring(
      world_, robot_, sampled("0,0,1\n0,48,0.6\n0.031,0,0.7\n0.031,48,0.3\n0.083,0,0.2\n0.083,48,0.04\n"));
  const struct {
    double distance;  // negative: the sensor is in the wall
    double lean;      // deg
    double reading;   // bilinear, by hand
  } cases[] = {{0.0, 0.0, 1.0},           {0.031, 0.0, 0.7},        {0.0417, 0.0, 0.597115}, {0.0417, 23.0, 0.429112},
               {0.0417, -23.0, 0.429112}, {0.0124, 31.0, 0.621667}, {0.0829, 71.0, 0.0405},  {0.0831, 0.0, 0.0},
               {0.0831, 40.0, 0.0},       {-1e-4, 0.0, 1.0},        {-1e-4, 23.0, 1.0}};
  for (const auto& expected : cases) {
    placeWall(wall, expected.distance, expected.lean * kDegree);
    EXPECT_NEAR(ring.sense().value[6], expected.reading, 2e-6) << expected.distance << " m, " << expected.lean;
    EXPECT_EQ(ring.sense().value[18], 0.0F) << "on the other side";
  }
}

TEST_F(SampledRingTest, TheAngleOfRoundThingsIsThatAtThePointThatIsHit) {
  // the reading is the angle in degrees / 100, so that the test can recover the angle
  SensorUnderTest<Proximity> ring(world_, robot_, sampled("0,0,0\n0,80,0.8\n1,0,0\n1,80,0.8\n"));
  const Row prey = world_.addPrey(1.0, 1.0, colors::kYellow, 0.11);
  for (const double aside : {-0.0931, -0.041, 0.0, 0.0173, 0.077, 0.1}) {
    world_.pose(prey).position = {1.0 + kRadius + 0.15, 1.0 + aside, 0.0};
    const double angle = std::asin(std::abs(aside) / 0.11) / kDegree;
    EXPECT_NEAR(ring.sense().sensors[6].value, angle / 100.0, 2e-4) << aside;
  }
}

TEST_F(SampledRingTest, DistancesAreInfiniteWhereTheTableSaysSo) {
  const Row handbot = world_.add(robotModel("handbot"), {4.0, 4.0, 0.0});
  const Row wall = world_.addWall({0.1, 2.0, 1.0}, {8.0, 4.0});
  SensorUnderTest<HandbotDistance> ring(world_, handbot,
                                        sampled("0.04,0,-inf\n0.06,0,0.07\n0.2,0,0.19\n0.37,0,0.31\n0.39,0,inf\n"));
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  for (const auto& [distance, reading] :
       {std::pair(0.01, -kInfinite), std::pair(0.0499, -kInfinite), std::pair(0.0501, 0.07F),
        std::pair(0.113, 0.115429F), std::pair(0.3, 0.260588F), std::pair(0.3799, 0.31F), std::pair(0.3801, kInfinite),
        std::pair(0.5, kInfinite)}) {
    world_.pose(wall).position.x() = 4.0 + HandbotDistance::kRingRadius + distance + 0.05;
    const float found = ring.sense().distance[0];
    if (std::isinf(reading)) {
      EXPECT_EQ(found, reading) << distance;
    } else {
      EXPECT_NEAR(found, reading, 2e-6) << distance;
    }
  }
  EXPECT_EQ(ring.sense().range_min, 0.07F);
  EXPECT_EQ(ring.sense().range_max, 0.31F);
}

TEST_F(SampledRingTest, LightOfSeveralLampsIsAddedByTheirBrightness) {
  SensorUnderTest<Light> ring(world_, robot_, sampled("0.2,0,0.9\n0.2,90,0.1\n1.4,0,0.3\n1.4,90,0\n"));
  const auto reading = [&] { return static_cast<double>(ring.sense().sensors[6].value); };
  const double height = world_.space.entities.model[robot_]->mount("proximity_6").position.z();
  EXPECT_EQ(reading(), 0.0);
  const Eigen::Vector3d sensor(1.0 + kRadius, 1.0, height);
  // 0.5 m away, 27 degrees aside: 0.75 * (0.9 - 0.3 * 0.8) + 0.25 * (0.3 - 0.3 * 0.3) = 0.5475
  const Eigen::Vector3d aside(0.5 * std::cos(27 * kDegree), 0.5 * std::sin(27 * kDegree), 0.0);
  world_.add(lightModel(1.0), sensor + aside, 0.0, colors::kWhite);
  EXPECT_NEAR(reading(), 0.5475, 1e-6);
  // red, three times as bright: 1; 0.9 m straight ahead: 0.9 - 0.6 * 7 / 12 = 0.55, but the sum is at most 1
  const Row red = world_.add(lightModel(3.0), sensor + Eigen::Vector3d(0.9, 0.0, 0.0), 0.0, colors::kRed);
  EXPECT_NEAR(reading(), 1.0, 1e-6);
  world_.pose(red).position.x() = sensor.x() + 1.2;  // 0.9 - 0.6 * 10 / 12 = 0.4
  EXPECT_NEAR(reading(), 0.9475, 1e-6);
  world_.pose(red).position.x() = sensor.x() + 1.41;
  EXPECT_NEAR(reading(), 0.5475, 1e-6) << "beyond the table";
  world_.addWall({0.01, 0.3, 0.5}, {sensor.x() + 0.3, 1.0 + 0.15});
  EXPECT_EQ(reading(), 0.0) << "hidden";
}

TEST_F(SampledRingTest, GroundIsTheTableTimesWhatTheFloorReflects) {
  SensorUnderTest<FootbotGround> ground(world_, robot_, sampled("0,0,0.5\n0,60,0.2\n0.05,0,0.9\n0.05,60,0.3\n"));
  const double height = world_.space.entities.model[robot_]->mount("ground_0").position.z();
  world_.space.floor.bare = Color{51, 102, 204};  // reflects 0.4666667
  const double reflection = Ground::reflection(world_.space.floor.bare);
  EXPECT_NEAR(reflection, 0.466667, 1e-6);
  for (const auto& [way, value] : {std::pair(0.0137, 0.6096), std::pair(0.05, 0.9), std::pair(0.0501, 0.0)}) {
    world_.pose(robot_).position.z() = way - height;
    EXPECT_NEAR(ground.sense().value[3], value * reflection, 1e-6) << way;
  }
}

TEST_F(SampledRingTest, EachSampleOfAnEntryComesAsOftenAndBetweenEntriesTheSpreadIsBetweenTheirs) {
  const Row wall = world_.addWall({0.1, 2.0, 0.5}, {5.0, 1.0});
  SensorUnderTest<FootbotProximity> ring(
      world_, robot_, sampled("0.02,0,0.9\n0.02,0,0.8\n0.02,0,0.84\n0.06,0,0.3\n0.06,0,0.5\n0.06,0,0.1\n"));
  placeWall(wall, 0.03, 0.0);  // at a quarter of the way: 0.75 * (0.8, 0.84, 0.9) + 0.25 * (0.1, 0.3, 0.5)
  std::map<int, int> counts;
  constexpr int kDraws = 3000;
  for (int i = 0; i < kDraws; ++i) {
    ++world_.space.tick;
    ++counts[static_cast<int>(std::lround(1e4 * ring.sense().value[6]))];
  }
  ASSERT_EQ(counts.size(), 3U);
  for (const int reading : {6250, 7050, 8000}) {
    EXPECT_NEAR(counts[reading], kDraws / 3, 104) << reading << ": 4 standard deviations";
  }
  const float once = ring.sense().value[6];
  EXPECT_EQ(once, ring.sense().value[6]) << "a tick that is made again";
}

TEST_F(SampledRingTest, ItIsTheIdealSensorWhereATableIsToBeMadeOfThat) {
  const Row wall = world_.addWall({0.1, 2.0, 0.5}, {5.0, 1.0});
  placeWall(wall, 0.037, 0.0);
  const Registry::Entry& entry = *Registry::instance().find(PluginKind::kSensor, "footbot_proximity", "sampled");
  const auto sensor = makePlugin<Sensor>(entry);
  auto* sampled = dynamic_cast<SampledSensor*>(sensor.get());
  ASSERT_NE(sampled, nullptr);
  Configuration parameters("footbot_proximity", "", {});
  parameters.set("range", "0.12");
  parameters.set("noise", "0");
  sampled->configureIdeal(parameters);
  sensor->add(world_.space, robot_);
  world_.sense(*sensor);
  EXPECT_EQ(sampled->stimulus(), Stimulus::kObstacle);
  EXPECT_EQ(sampled->reach(), 0.12);
  EXPECT_EQ(sampled->sensorCount(), 24U);
  EXPECT_NEAR(sampled->line(6).from.y(), kRadius, 1e-12);
  EXPECT_NEAR(sampled->line(6).direction.y(), 1.0, 1e-12);
  EXPECT_NEAR(sampled->reading(6), std::pow(1.0 - 0.037 / 0.12, 3), 1e-6);
}

TEST_F(SampledRingTest, SensingAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  const Row wall = world_.addWall({0.1, 2.0, 0.5}, {5.0, 1.0});
  placeWall(wall, 0.03, 0.3);
  const Parameters table = sampled("0,0,0.9\n0,0,0.8\n0.1,0,0.3\n");
  SensorUnderTest<FootbotProximity> proximity(world_, robot_, table);
  SensorUnderTest<Distance> distance(world_, world_.add(robotModel("handbot"), {4.0, 4.0, 0.0}), table);
  SensorUnderTest<FootbotGround> ground(world_, robot_, table);
  SensorUnderTest<Light> light(world_, robot_, table);
  world_.add(lightModel(1.0), {1.15, 1.0, 0.1}, 0.0, colors::kWhite);
  for (Sensor* sensor : {proximity.sensor.get(), distance.sensor.get(), ground.sensor.get(), light.sensor.get()}) {
    world_.sense(*sensor);
    const long before = heap_allocations;
    for (int i = 0; i < 3; ++i) {
      ++world_.space.tick;
      sensor->sense(world_.space, 0, 1);
    }
    EXPECT_EQ(heap_allocations - before, 0) << sensor->type();
  }
}

TEST_F(SampledRingTest, DamagedTablesAreRefused) {
  try {
    SensorUnderTest<Light> light(world_, robot_, sampled("0.1,0,0.4\n0.2,0,inf\n"));
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("table.csv:3: reading: found 'inf'"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace swarmanoid::test
