// Ground spots: the mean of the channels, from 0 to 1, of the floor's colour where the line of sight of a spot meets
// the ground; 0 beyond 5 cm. A footbot has them 5 mm above the ground: 8 on a circle of 6.3 cm, from 22.5 degrees in
// steps of 45, and 4 at 3 cm along x and y. The patches under the spots were computed with another program.
#include "swarmanoid_interface/devices/ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/devices/footbot_ground.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

namespace swarmanoid::test {
namespace {

constexpr float kBare = 300.0F / 765.0F;
constexpr float kDisc = 306.0F / 765.0F;
constexpr float kStrip = 60.0F / 765.0F;
constexpr Color kGreyColor{200, 100, 0};
constexpr Color kPatchColor{51, 102, 153};
constexpr Color kStripColor{10, 20, 30};
constexpr double kHeading = 0.83;  // rad

FloorPatch disc(double x, double y, double radius, Color color = kPatchColor) {
  FloorPatch patch;
  patch.position = {x, y, 0.0};
  patch.radius = radius;
  patch.color = color;
  return patch;
}

FloorPatch strip(double x, double y, const Eigen::Vector2d& size) {
  FloorPatch patch;
  patch.position = {x, y, 0.0};
  patch.size = size;
  patch.color = kStripColor;
  return patch;
}

/// A terrain from (4, 4) to (6, 6), with a vertex every 0.1 m.
std::shared_ptr<const Terrain> groundOf(const std::function<double(double x)>& height) {
  std::vector<double> heights;
  for (int j = 0; j <= 20; ++j) {
    for (int i = 0; i <= 20; ++i) {
      heights.push_back(height(4.0 + 0.1 * i));
    }
  }
  return std::make_shared<const Terrain>(Eigen::Vector2d(4.0, 4.0), Eigen::Vector2d(2.0, 2.0), 21, 21, heights);
}

/// A robot with one spot.
std::shared_ptr<const EntityModel> robotWithSpot(const Eigen::Vector3d& position,
                                                 const Eigen::Quaterniond& orientation) {
  auto model = std::make_shared<EntityModel>(*robotModel("eyebot"));
  model->mounts["ground_0"].position = position;
  model->mounts["ground_0"].orientation = orientation;
  return model;
}

Eigen::Quaterniond pitchedDown(double angle) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()));
}

template <std::size_t count>
void expectNear(const std::array<float, count>& found, const std::array<float, count>& expected,
                const std::string& what) {
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_NEAR(found[i], expected[i], 1e-6) << what << ", spot " << i;
  }
}

class GroundTest : public testing::Test {
 protected:
  void SetUp() override { world.space.floor.bare = kGreyColor; }

  void place(double z, double tilt = 0.0) {
    Pose& pose = world.pose(robot);
    pose.position.z() = z;
    pose.orientation = Eigen::AngleAxisd(tilt, Eigen::Vector3d(0.6, -0.8, 0.0)) *
                       Eigen::AngleAxisd(kHeading, Eigen::Vector3d::UnitZ());
  }

  DeviceWorld world;
  Row robot = world.addFootbot(4.13, 5.27, kHeading);
};

TEST_F(GroundTest, EachSpotReadsThePatchUnderIt) {
  SensorUnderTest<FootbotGround> around(world, robot);
  SensorUnderTest<FootbotBaseGround> between(world, robot);
  world.space.floor.patches = {disc(4.17, 5.25, 0.06), strip(4.1, 5.25, {0.08, 0.3})};
  expectNear(around.sense().value, {kBare, kStrip, kStrip, kStrip, kStrip, kDisc, kDisc, kDisc}, "around");
  expectNear(between.sense().value, {kStrip, kStrip, kStrip, kDisc}, "between the wheels");
  std::swap(world.space.floor.patches[0], world.space.floor.patches[1]);
  expectNear(around.sense().value, {kBare, kStrip, kStrip, kStrip, kStrip, kDisc, kDisc, kDisc}, "disc on top");
  expectNear(between.sense().value, {kStrip, kStrip, kDisc, kDisc}, "disc on top, between the wheels");
}

TEST_F(GroundTest, WhiteReadsOneBlackReadsNothing) {
  SensorUnderTest<FootbotGround> ground(world, robot);
  world.space.floor = Floor{};
  for (const float value : ground.sense().value) {
    EXPECT_EQ(value, 1.0F) << "a floor of which nobody says anything";
  }
  world.space.floor.patches = {disc(4.13, 5.27, 0.1, colors::kBlack)};
  for (const float value : ground.sense().value) {
    EXPECT_EQ(value, 0.0F);
  }
}

/// Bare floor reads 300 / 765. Grey paint of 384 / 765 is mixed with it channel by channel: strength 0.4 changes 200,
/// 100 and 0 to 171, 111 and 51, and after a half-life strength 0.2 changes them to 186, 106 and 26.
TEST_F(GroundTest, PaintIsReadWhileItFades) {
  SensorUnderTest<FootbotGround> ground(world, robot);
  world.space.floor.paint = PaintLayer({10.0, 10.0}, 0.02, 9.0);
  world.space.tick = 40;
  expectNear(ground.sense().value, {kBare, kBare, kBare, kBare, kBare, kBare, kBare, kBare}, "clean");
  world.space.floor.paint.paint({{4.13, 5.27}, 0.2, colors::kGray, 0.4}, 40);
  EXPECT_NEAR(ground.sense().value[2], 333.0F / 765.0F, 1e-6);
  world.space.tick = 49;
  EXPECT_NEAR(ground.sense().value[2], 318.0F / 765.0F, 1e-6);
}

TEST_F(GroundTest, ATiltedRobotReadsWhereItLooks) {
  SensorUnderTest<FootbotGround> around(world, robot);
  SensorUnderTest<FootbotBaseGround> between(world, robot);
  world.space.floor.patches = {strip(4.165, 5.27, {0.07, 0.5})};
  place(0.03);
  expectNear(around.sense().value, {kStrip, kBare, kBare, kBare, kBare, kStrip, kStrip, kStrip}, "level");
  expectNear(between.sense().value, {kBare, kBare, kStrip, kStrip}, "level, between the wheels");
  place(0.03, 0.35);  // spots 0 and 7 are lifted so that the ground is beyond 5 cm
  expectNear(around.sense().value, {0.0F, kBare, kBare, kBare, kBare, kStrip, kStrip, 0.0F}, "tilted");
  expectNear(between.sense().value, {kStrip, kBare, kStrip, kStrip}, "tilted, between the wheels");
  place(0.03, -0.35);
  expectNear(around.sense().value, {kStrip, kBare, kBare, 0.0F, 0.0F, kStrip, kStrip, kStrip}, "to the other side");
  expectNear(between.sense().value, {kBare, kBare, kBare, kStrip}, "to the other side, between the wheels");
}

TEST_F(GroundTest, BeyondTheRangeThereIsNoGround) {
  SensorUnderTest<FootbotGround> usual(world, robot);
  place(0.0449);
  EXPECT_NEAR(usual.sense().value[3], kBare, 1e-6);
  place(0.0451);
  EXPECT_EQ(usual.sense().value[3], 0.0F);
  const Row other = world.addFootbot(2.0, 2.0);
  SensorUnderTest<FootbotGround> far(world, other, {{"range", "0.2"}});
  world.pose(other).position.z() = 0.1949;
  EXPECT_NEAR(far.sense().value[3], kBare, 1e-6);
  world.pose(other).position.z() = 0.1951;
  EXPECT_EQ(far.sense().value[3], 0.0F);
}

TEST_F(GroundTest, ASpotThatIsPressedIntoTheGroundALittleReadsIt) {
  SensorUnderTest<FootbotGround> ground(world, robot);
  place(-0.0149);
  EXPECT_NEAR(ground.sense().value[3], kBare, 1e-6) << "9.9 mm deep";
  place(-0.0151);
  EXPECT_EQ(ground.sense().value[3], 0.0F);
}

TEST_F(GroundTest, ASpotThatDoesNotLookDownReadsNothing) {
  for (const double pitch : {0.0, -0.4, -M_PI / 2.0, M_PI}) {
    const Row own = world.add(robotWithSpot({0.0, 0.0, 0.004}, pitchedDown(pitch)), {7.0, 7.0, 0.0});
    SensorUnderTest<Ground> ground(world, own);
    EXPECT_EQ(ground.sense().sensors[0].value, 0.0F) << pitch;
  }
}

TEST_F(GroundTest, TheGroundOfAHoleIsDeep) {
  world.space.terrain = groundOf([](double) { return -0.7; });
  world.pose(robot) = {{6.01, 5.0, 0.0}, Eigen::Quaterniond::Identity()};
  // along x the spots are at 0.0582 and 0.0241 m; the hole ends 0.01 m behind the centre
  SensorUnderTest<FootbotGround> ground(world, robot);
  expectNear(ground.sense().value, {kBare, kBare, 0.0F, 0.0F, 0.0F, 0.0F, kBare, kBare}, "at its border");
  world.space.terrain = groundOf([](double) { return -0.044; });
  world.space.floor.patches = {disc(5.95, 5.024, 0.01)};
  expectNear(ground.sense().value, {kBare, kBare, kBare, kDisc, kBare, kBare, kBare, kBare}, "4.9 cm below the spots");
  world.space.terrain = groundOf([](double) { return -0.046; });
  expectNear(ground.sense().value, {kBare, kBare, 0.0F, 0.0F, 0.0F, 0.0F, kBare, kBare}, "5.1 cm below the spots");
}

FloorHole hole(double x, double y, double radius) {
  FloorHole result;
  result.position = {x, y, 0.0};
  result.radius = radius;
  return result;
}

/// A hole at the disc of EachSpotReadsThePatchUnderIt, under spots 5 to 7, hides the patches there.
TEST_F(GroundTest, OverAHoleNothingComesBack) {
  world.space.floor.holes = {hole(4.17, 5.25, 0.06)};
  world.space.floor.patches = {disc(4.17, 5.25, 0.2)};
  SensorUnderTest<FootbotGround> around(world, robot);
  SensorUnderTest<FootbotBaseGround> between(world, robot);
  expectNear(around.sense().value, {kDisc, kDisc, kDisc, kDisc, kDisc, 0.0F, 0.0F, 0.0F}, "around");
  EXPECT_EQ(between.sense().value[3], 0.0F);
  world.space.floor.paint = PaintLayer({10.0, 10.0}, 0.02, 9.0);
  world.space.floor.paint.paint({{4.17, 5.25}, 0.3, colors::kWhite, 1.0}, 0);
  EXPECT_EQ(around.sense().value[6], 0.0F) << "paint does not fill it";
}

TEST_F(GroundTest, ASpotReadsTheRimAsTheLineOfSightMeetsIt) {
  // looks ahead and down by 0.6 rad from (2.02, 3.01, 0.02): 0.02 / tan(0.6) = 0.0292339 m ahead on the floor
  const Row own = world.add(robotWithSpot({0.02, 0.01, 0.02}, pitchedDown(0.6)), {2.0, 3.0, 0.0});
  SensorUnderTest<Ground> ground(world, own);
  world.space.floor.holes = {hole(2.0, 3.01, 0.0492)};
  EXPECT_NEAR(ground.sense().sensors[0].value, kBare, 1e-6) << "behind the rim";
  world.space.floor.holes = {hole(2.0, 3.01, 0.0493)};
  EXPECT_EQ(ground.sense().sensors[0].value, 0.0F);
  world.space.floor.holes = {hole(2.1, 3.01, 0.0507)};
  EXPECT_NEAR(ground.sense().sensors[0].value, kBare, 1e-6) << "before it";
  world.space.floor.holes.push_back(hole(2.1, 3.01, 0.0508));
  EXPECT_EQ(ground.sense().sensors[0].value, 0.0F) << "of the second hole";
}

TEST_F(GroundTest, ATerrainHasNoHolesButItsOwn) {
  world.pose(robot) = {{6.01, 5.0, 0.0}, Eigen::Quaterniond::Identity()};
  world.space.terrain = groundOf([](double) { return 0.0; });
  world.space.floor.holes = {hole(6.0, 5.0, 0.2)};
  SensorUnderTest<FootbotGround> ground(world, robot);
  expectNear(ground.sense().value, {0.0F, 0.0F, kBare, kBare, kBare, kBare, 0.0F, 0.0F}, "at its border");
}

TEST_F(GroundTest, ASlopeIsNearerThanTheFloor) {
  world.space.terrain = groundOf([](double x) { return 0.5 * std::max(0.0, x - 5.0); });
  // looks ahead and down by 45 degrees from (5.02, 5.01, 0.03), and meets the slope at x = 5.0333, not at 5.05
  const Row own = world.add(robotWithSpot({0.02, 0.01, 0.03}, pitchedDown(M_PI / 4.0)), {5.0, 5.0, 0.0});
  world.space.floor.patches = {disc(5.0 + 1.0 / 30.0, 5.01, 0.005)};
  SensorUnderTest<Ground> ground(world, own);
  EXPECT_NEAR(ground.sense().sensors[0].value, kDisc, 1e-6);
  world.pose(own).position.z() = -0.025;
  EXPECT_NEAR(ground.sense().sensors[0].value, kBare, 1e-6) << "5 mm under the slope: it is pressed into it";
  world.pose(own).position.z() = -0.04;
  EXPECT_EQ(ground.sense().sensors[0].value, 0.0F) << "2 cm under the slope";
  world.space.terrain = nullptr;
  world.pose(own).position.z() = 0.0;
  EXPECT_NEAR(ground.sense().sensors[0].value, kBare, 1e-6) << "level: 4.2 cm away";
}

TEST_F(GroundTest, OfAnyRobotReadsWhatTheFootbotsOwnReads) {
  world.space.floor.patches = {disc(4.17, 5.25, 0.06), strip(4.1, 5.25, {0.08, 0.3})};
  SensorUnderTest<FootbotGround> own(world, robot);
  SensorUnderTest<Ground> sensor(world, robot);  // owns the list of readings
  const Ground& any = sensor.sense();
  ASSERT_EQ(any.sensors.size(), FootbotGround::kCount);
  for (std::size_t i = 0; i < FootbotGround::kCount; ++i) {
    EXPECT_EQ(any.sensors[i].value, own.sense().value[i]) << "to the last bit, spot " << i;
    EXPECT_NEAR(any.sensors[i].x, FootbotGround::place(i).x(), 1e-6) << i;
    EXPECT_NEAR(any.sensors[i].y, FootbotGround::place(i).y(), 1e-6) << i;
  }
}

TEST_F(GroundTest, EachRobotHasItsOwnReadings) {
  world.space.floor.patches = {disc(7.0, 7.0, 0.2), strip(2.0, 2.0, {0.4, 0.4})};
  const auto sensor = makeDevice<Sensor>(PluginKind::kSensor, Ground::kType, {});
  std::vector<Row> rows{robot, world.addFootbot(7.0, 7.0), world.addFootbot(2.0, 2.0)};
  std::vector<const Ground*> readings;
  for (const Row row : rows) {
    readings.push_back(static_cast<const Ground*>(sensor->add(world.space, row)));
  }
  world.sense(*sensor);
  const float expected[] = {kBare, kDisc, kStrip};
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_NEAR(readings[k]->sensors[5].value, expected[k], 1e-6) << k;
  }
  sensor->remove(world.space, rows[0]);
  world.remove(rows[0]);
  world.space.floor.patches.pop_back();
  world.sense(*sensor);
  EXPECT_NEAR(readings[1]->sensors[5].value, kDisc, 1e-6);
  EXPECT_NEAR(readings[2]->sensors[5].value, kBare, 1e-6);
}

/// A hole anywhere disables the short cut for level floor; the results are the same.
TEST_F(GroundTest, OverLevelBareFloorUprightRobotsReadToTheBitWhatTheyWouldAnyhow) {
  const auto sensor = makeDevice<Sensor>(PluginKind::kSensor, FootbotGround::kType, {});
  std::vector<Row> rows{robot};
  std::vector<const FootbotGround*> readings;
  for (int k = 0; k < 150; ++k) {
    rows.push_back(world.addFootbot(0.3 + 0.05 * k, 5.0 + std::sin(7.0 * k), 0.1 * k));
    // some side by side at the same height, some pressed into the floor, some too high, a few tilted
    world.pose(rows.back()).position.z() = 0.00031 * (7 * (k / 3) % 250) - 0.018;
    if (k % 17 == 5) {
      world.pose(rows.back()).orientation = pitchedDown(0.01 * k);
    }
  }
  for (const Row row : rows) {
    readings.push_back(static_cast<const FootbotGround*>(sensor->add(world.space, row)));
  }
  world.space.floor.patches = {disc(5.0, 5.0, 0.4)};
  const auto sensed = [&] {
    world.sense(*sensor);
    std::vector<std::array<float, FootbotGround::kCount>> values;
    for (const FootbotGround* reading : readings) {
      values.push_back(reading->value);
    }
    return values;
  };
  const auto cut_short = sensed();
  world.space.floor.holes = {hole(9.9, 0.1, 0.05)};
  EXPECT_EQ(sensed(), cut_short);
  for (const float value : {0.0F, kBare}) {
    EXPECT_TRUE(std::any_of(cut_short.begin(), cut_short.end(), [&](const auto& of) { return of[3] == value; }));
  }
}

TEST(GroundRefusalTest, RobotsWithoutSpotsAreRefused) {
  EXPECT_EQ(refusalOf<SensorUnderTest<Ground>>(robotModel("eyebot")),
            "found the device 'ground' on a eyebot, allowed: on robots with links ground_0, ... (1 to 64)");
  auto model = std::make_shared<EntityModel>(*robotModel("footbot"));
  model->mounts.erase("base_ground_3");
  EXPECT_EQ(
      refusalOf<SensorUnderTest<FootbotBaseGround>>(model),
      "found the device 'footbot_base_ground' on a footbot with links base_ground_0, ... (3), allowed: 4 or more");
  EXPECT_EQ(refusalOf<SensorUnderTest<FootbotGround>>(model), "");
}

TEST_F(GroundTest, SensingAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  world.space.floor.patches = {disc(4.17, 5.25, 0.06)};
  world.space.terrain = groundOf([](double) { return 0.001; });
  SensorUnderTest<Ground> any(world, robot);
  SensorUnderTest<FootbotBaseGround> between(world, robot);
  const long before = heap_allocations;
  any.sensor->sense(world.space, 0, 1);
  between.sensor->sense(world.space, 0, 1);
  EXPECT_EQ(heap_allocations - before, 0);
  EXPECT_NEAR(between.sense().value[3], kDisc, 1e-6) << "it did sense";
}

}  // namespace
}  // namespace swarmanoid::test
