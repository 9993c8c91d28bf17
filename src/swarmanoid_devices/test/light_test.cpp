// Light sensors: the sum of brightness * cos(angle) * (0.1 m / distance)^2 over all visible LEDs and lamps, at most 1.
// A footbot has them at its 24 infrared sensors: 0.085 m from its axis, 0.06 m above the ground.
#include "swarmanoid_interface/devices/light.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "device_world.hpp"
#include "sensors/rays/ring_geometry.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

namespace swarmanoid::test {
namespace {

/// Responds to LEDs at any distance by default.
struct LightSensor : SensorUnderTest<Light> {
  LightSensor(DeviceWorld& world, Row row, Parameters parameters = {})
      : SensorUnderTest<Light>(world, row, (parameters.insert({"led_range", "100"}), parameters)) {}
};

constexpr std::size_t kCount = 24;
constexpr double kLightRingRadius = 0.085;  // m, of the ring
constexpr double kHeight = 0.06;            // m, of the ring
constexpr double kUsualRange = 2.0;
constexpr double kStep = M_PI / 12.0;

struct Source {
  Eigen::Vector3d position;
  double brightness;
};

/// Light of unoccluded sources on a sensor, computed by angles.
double lightOn(const Eigen::Vector3d& sensor, const Eigen::Vector3d& looks, const std::vector<Source>& sources) {
  double sum = 0.0;
  for (const Source& source : sources) {
    const Eigen::Vector3d way = source.position - sensor;
    const double angle = std::atan2(way.cross(looks).norm(), way.dot(looks));
    const double distance = way.norm();
    if (angle < M_PI / 2.0 && distance <= kUsualRange) {
      sum += source.brightness * std::cos(angle) * std::pow(0.1 / distance, 2.0);
    }
  }
  return std::min(sum, 1.0);
}

/// Position and direction of sensor `i` of a footbot, in W.
Eigen::Vector3d placeOf(const Pose& pose, std::size_t i) {
  const double angle = kStep * static_cast<double>(i);
  return pose.toWorld({kLightRingRadius * std::cos(angle), kLightRingRadius * std::sin(angle), kHeight});
}
Eigen::Vector3d looksOf(const Pose& pose, std::size_t i) {
  const double angle = kStep * static_cast<double>(i);
  return pose.orientation * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
}

/// @return number of sensors with a reading above 0
int expectLight(const Light& found, const Pose& pose, const std::vector<Source>& sources) {
  int lit = 0;
  EXPECT_EQ(found.sensors.size(), kCount);
  for (std::size_t i = 0; i < found.sensors.size(); ++i) {
    const double expected = lightOn(placeOf(pose, i), looksOf(pose, i), sources);
    EXPECT_NEAR(found.sensors[i].value, expected, 1e-6) << "sensor " << i;
    lit += found.sensors[i].value > 0.0F ? 1 : 0;
  }
  return lit;
}

double strongestOf(const Light& light) {
  float strongest = 0.0F;
  for (const LightReading& reading : light.sensors) {
    strongest = std::max(strongest, reading.value);
  }
  return strongest;
}

class LightTest : public testing::Test {
 protected:
  Row addLamp(const Eigen::Vector3d& position, Color color = colors::kWhite) {
    return world.add(lightModel(), position, 0.0, color);
  }

  DeviceWorld world;
  Row robot = world.addFootbot(4.0, 5.0, 0.37);
};

TEST_F(LightTest, ALampIsReadByAngleAndDistance) {
  addLamp({4.31, 5.52, 0.33}, {100, 30, 7});
  Pose& pose = world.pose(robot);
  LightSensor light(world, robot);
  for (const double tilt : {0.0, 0.29, -1.1}) {
    pose.orientation =
        Eigen::AngleAxisd(tilt, Eigen::Vector3d(0.6, -0.8, 0.0)) * Eigen::AngleAxisd(0.37, Eigen::Vector3d::UnitZ());
    const int lit = expectLight(light.sense(), pose, {{{4.31, 5.52, 0.33}, 137.0 / 765.0}});
    EXPECT_GT(lit, 5) << tilt;
    EXPECT_LT(lit, 24) << tilt;
  }
}

TEST_F(LightTest, OneReadingIsWorkedOutByHand) {
  world.pose(robot).orientation.setIdentity();
  addLamp({4.0 + kLightRingRadius + 0.4, 5.3, kHeight}, colors::kBlue);  // 0.5 m from sensor 0, cosine 0.8
  LightSensor sensor(world, robot);                                      // owns the list of readings
  const Light& light = sensor.sense();
  EXPECT_NEAR(light.sensors[0].value, 0.8 * 0.04 / 3.0, 1e-7);
  EXPECT_EQ(light.sensors[12].value, 0.0F) << "looks away";
}

TEST_F(LightTest, TheIntensityOfALampIsAFactor) {
  world.pose(robot).orientation.setIdentity();
  const Row lamp = addLamp({4.0 + kLightRingRadius + 0.4, 5.3, kHeight}, colors::kBlue);  // as above
  LightSensor sensor(world, robot);
  const float at_one = sensor.sense().sensors[0].value;
  world.space.properties[lamp][0] = 0.3;
  EXPECT_NEAR(sensor.sense().sensors[0].value, 0.3 * 0.8 * 0.04 / 3.0, 1e-7);
  world.space.properties[lamp][0] = 12.5;
  EXPECT_NEAR(sensor.sense().sensors[0].value, 12.5 * 0.8 * 0.04 / 3.0, 1e-6);
  world.space.properties[lamp][0] = 0.0;
  EXPECT_EQ(strongestOf(sensor.sense()), 0.0);
  world.space.properties[lamp][0] = 1.0;
  EXPECT_EQ(sensor.sense().sensors[0].value, at_one);
}

TEST_F(LightTest, WhateverHasAnIntensityShinesAlsoIfItHasABody) {
  auto lantern = std::make_shared<EntityModel>(*cylindricPreyModel(0.02, 0.02));
  lantern->led_positions[0] = {0.0, 0.0, kHeight};
  lantern->measureShapes();
  lantern->properties.push_back({"intensity", "", "", {}, 2.0});
  world.pose(robot).orientation.setIdentity();
  world.add(lantern, {4.0 + kLightRingRadius + 0.4, 5.3, 0.0}, 0.0, colors::kBlue);  // 0.5 m away, cosine 0.8
  EXPECT_NEAR(LightSensor(world, robot).sense().sensors[0].value, 2.0 * 0.8 * 0.04 / 3.0, 1e-7);
}

TEST_F(LightTest, SourcesAddUp) {
  const Row other = world.addFootbot(4.4, 4.6, 3.0 * M_PI / 4.0);
  world.space.leds[other][0] = {0, 200, 51};  // looks at the robot
  addLamp({3.2, 5.9, 1.4}, {51, 51, 51});
  const double aside = kLightRingRadius * std::sqrt(0.5);
  const int lit = expectLight(LightSensor(world, robot).sense(), world.pose(robot),
                              {{{4.4 - aside, 4.6 + aside, 0.12}, 251.0 / 765.0}, {{3.2, 5.9, 1.4}, 0.2}});
  EXPECT_EQ(lit, 22) << "each is before about half of the sensors";
}

TEST_F(LightTest, OwnLedsDoNotCount) {
  for (Color& led : world.space.leds[robot]) {
    led = colors::kWhite;
  }
  EXPECT_EQ(strongestOf(LightSensor(world, robot).sense()), 0.0);
}

TEST_F(LightTest, APreysColourIsNoLight) {
  world.addPrey(4.3, 5.0, colors::kYellow);
  EXPECT_EQ(strongestOf(LightSensor(world, robot).sense()), 0.0);
}

TEST_F(LightTest, ALedBehindItsOwnRobotIsHidden) {
  const Row other = world.addFootbot(4.6, 5.0);
  world.space.leds[other][0] = colors::kRed;  // looks away from the robot
  LightSensor light(world, robot);
  EXPECT_EQ(strongestOf(light.sense()), 0.0);
  world.space.leds[other][0] = colors::kBlack;
  world.space.leds[other][6] = colors::kRed;
  EXPECT_GT(expectLight(light.sense(), world.pose(robot), {{{4.6 - kLightRingRadius, 5.0, 0.12}, 1.0 / 3.0}}), 5);
}

TEST_F(LightTest, AWallHidesALed) {
  const Row other = world.addFootbot(4.6, 5.0, M_PI);
  world.space.leds[other][0] = colors::kRed;
  const Row wall = world.addWall({0.02, 2.0, 0.5}, {4.3, 5.0});
  LightSensor light(world, robot);
  EXPECT_EQ(strongestOf(light.sense()), 0.0);
  world.pose(wall).position.z() = -0.15;  // up to 0.1 m; the lines from 0.06 m to 0.12 m are at most 0.095 m high there
  EXPECT_EQ(strongestOf(light.sense()), 0.0);
  world.pose(wall).position.z() = -0.2;  // up to 0.05 m
  EXPECT_GT(expectLight(light.sense(), world.pose(robot), {{{4.6 - kLightRingRadius, 5.0, 0.12}, 1.0 / 3.0}}), 5);
}

/// Each sensor has its own line of sight.
TEST_F(LightTest, APoleShadesSomeOfTheSensors) {
  const Eigen::Vector2d lamp(5.1, 5.2);
  const Eigen::Vector2d pole(4.36, 5.07);
  addLamp({lamp.x(), lamp.y(), kHeight});
  world.addPrey(pole.x(), pole.y(), colors::kBlack, 0.02);
  LightSensor sensor(world, robot);  // owns the list of readings
  const Light& light = sensor.sense();
  int shaded = 0;
  int lit = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    const Eigen::Vector3d place = placeOf(world.pose(robot), i);
    const double without = lightOn(place, looksOf(world.pose(robot), i), {{{lamp.x(), lamp.y(), kHeight}, 1.0}});
    const Eigen::Vector2d way = (lamp - place.head<2>()).normalized();
    const Eigen::Vector2d to_pole = pole - place.head<2>();
    const double clearance = std::abs(way.x() * to_pole.y() - way.y() * to_pole.x()) - 0.02;
    ASSERT_GT(std::abs(clearance), 1e-4) << "sensor " << i;
    EXPECT_NEAR(light.sensors[i].value, clearance < 0.0 ? 0.0 : without, 1e-6) << "sensor " << i;
    shaded += clearance < 0.0 && without > 0.0 ? 1 : 0;
    lit += light.sensors[i].value > 0.0F ? 1 : 0;
  }
  EXPECT_GT(shaded, 0);
  EXPECT_GT(lit, 0);
}

TEST_F(LightTest, BeyondTheRangeThereIsNoLight) {
  world.pose(robot).orientation.setIdentity();
  const Row lamp = addLamp({4.0 + kLightRingRadius + 0.699, 5.0, kHeight});
  LightSensor light(world, robot, {{"range", "0.7"}});
  EXPECT_NEAR(light.sense().sensors[0].value, std::pow(0.1 / 0.699, 2.0), 1e-6);
  EXPECT_EQ(light.sense().sensors[6].value, 0.0F);
  world.pose(lamp).position.x() += 0.002;
  EXPECT_EQ(strongestOf(light.sense()), 0.0);
}

TEST_F(LightTest, LedsGiveNoLightWhereNothingIsSaidOfThem) {
  const Row other = world.addFootbot(4.4, 5.0);
  for (Color& led : world.space.leds[other]) {
    led = colors::kWhite;
  }
  SensorUnderTest<Light> usual(world, robot);
  EXPECT_EQ(strongestOf(usual.sense()), 0.0);
  usual.sensor->remove(world.space, robot);
  EXPECT_GT(strongestOf(LightSensor(world, robot).sense()), 0.01);
}

TEST_F(LightTest, LedsMayHaveAShorterReachThanLamps) {
  world.pose(robot).orientation.setIdentity();
  const Row other = world.addFootbot(4.0 + kLightRingRadius + 0.7, 5.0, M_PI);  // its LED 0 looks at the robot
  world.space.leds[other][0] = colors::kWhite;
  const auto brightest = [&](const std::string& led_range) {
    LightSensor light(world, robot, {{"range", "1.3"}, {"led_range", led_range}});
    const double strongest = strongestOf(light.sense());
    light.sensor->remove(world.space, robot);
    return strongest;
  };
  // the LED is 0.618 m from sensor 0, the nearest one
  EXPECT_GT(brightest("0.9"), 0.005);
  EXPECT_EQ(brightest("0.6"), 0.0);
  EXPECT_EQ(brightest("50"), brightest("0.9")) << "the range holds for all";
  addLamp({4.0, 5.0 + kLightRingRadius + 1.2, kHeight});
  EXPECT_NEAR(brightest("0.6"), std::pow(0.1 / 1.2, 2.0), 1e-7) << "the lamp alone, straight ahead of sensor 6";
}

TEST_F(LightTest, ReadingsSaturate) {
  world.pose(robot).orientation.setIdentity();
  const Row lamp = addLamp({4.0 + kLightRingRadius + 0.125, 5.0, kHeight});
  LightSensor light(world, robot);
  EXPECT_NEAR(light.sense().sensors[0].value, 0.64, 1e-6);
  world.pose(lamp).position.x() = 4.0 + kLightRingRadius + 0.05;
  EXPECT_EQ(light.sense().sensors[0].value, 1.0F);
  world.pose(lamp).position.x() = 4.0 + kLightRingRadius + 0.125;
  addLamp({4.0 + kLightRingRadius + 0.125, 5.0, kHeight});
  EXPECT_EQ(light.sense().sensors[0].value, 1.0F) << "0.64 twice";
}

TEST_F(LightTest, SensorsOfTheirOwnTakeThePlaceOfInfraredOnes) {
  auto model = std::make_shared<EntityModel>(*robotModel("footbot"));
  const Eigen::Vector3d places[] = {{0.02, -0.01, 0.13}, {-0.05, 0.0, 0.2}};
  model->mounts["light_0"].position = places[0];
  model->mounts["light_0"].orientation = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ());
  model->mounts["light_1"].position = places[1];  // looks up and behind
  model->mounts["light_1"].orientation =
      Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(-0.9, Eigen::Vector3d::UnitY());
  const Row own = world.add(model, {7.0, 7.0, 0.0});
  addLamp({7.1, 7.2, 0.9}, colors::kGreen);
  LightSensor sensor(world, own);  // owns the list of readings
  const Light& light = sensor.sense();
  ASSERT_EQ(light.sensors.size(), 2U);
  const Eigen::Vector3d origin(7.0, 7.0, 0.0);
  const Eigen::Vector3d looks[] = {{std::cos(0.7), std::sin(0.7), 0.0}, {-std::cos(0.9), 0.0, std::sin(0.9)}};
  for (std::size_t i = 0; i < 2; ++i) {
    const double expected = lightOn(origin + places[i], looks[i], {{{7.1, 7.2, 0.9}, 1.0 / 3.0}});
    EXPECT_GT(expected, 0.0);
    EXPECT_NEAR(light.sensors[i].value, expected, 1e-7);
  }
  EXPECT_NEAR(light.sensors[0].angle, 0.7, 1e-6);
  EXPECT_NEAR(light.sensors[1].angle, M_PI, 1e-6);
}

/// Sensors around the ducts, 0.25 m from the eyebot's axis and 0.29 m above its feet.
TEST_F(LightTest, AnEyebotHas24AroundItsDucts) {
  const Row eyebot = world.addEyebot(5.0, 5.0, 1.2, 0.41);
  addLamp({5.9, 4.65, 0.4});
  LightSensor sensor(world, eyebot);
  const Light& light = sensor.sense();
  ASSERT_EQ(light.sensors.size(), 24U);
  EXPECT_NEAR(light.sensors[0].value, 1.7462311e-3, 1e-9) << "1.3565221 m away, cosine 0.3213331";
  EXPECT_NEAR(light.sensors[2].value, 1.4017621e-5, 1e-9) << "cosine 0.0028821";
  EXPECT_EQ(light.sensors[3].value, 0.0F) << "looks away";
  EXPECT_NEAR(light.sensors[21].value, 3.2279172e-3, 1e-9) << "1.3039458 m away, cosine 0.5488346";
  EXPECT_NEAR(light.sensors[21].angle, -M_PI / 4.0, 1e-6);
}

TEST_F(LightTest, RobotsWithoutSensorsAreRefused) {
  const Row handbot = world.add(robotModel("handbot"), {1.0, 1.0, 0.0});
  try {
    LightSensor light(world, handbot);
    FAIL() << "it has no such links";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "found the device 'light' on a handbot, allowed: on robots with links light_0, ... or "
                 "proximity_0, ... (1 to 64)");
  }
}

std::shared_ptr<EntityModel> footbotWithLightLinks(int count) {
  auto model = std::make_shared<EntityModel>(*robotModel("footbot"));
  for (int i = 0; i < count; ++i) {
    model->mounts["light_" + std::to_string(i)].position = {0.05, 0.0, 0.1};
  }
  return model;
}

/// The model also has 24 links proximity_0, ..., which do not count if there is a light_0.
TEST_F(LightTest, ARefusalSaysWhichLinksWereTakenAndHowMany) {
  const Row crowded = world.add(footbotWithLightLinks(65), {7.0, 7.0, 0.0});
  try {
    LightSensor light(world, crowded);
    FAIL() << "too many";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "found the device 'light' on a footbot with links light_0, ... (65), allowed: 1 to 64; links of "
                 "other names count only on robots without light_0");
  }
  try {
    devices::ringOf<24>(*footbotWithLightLinks(1), "my_light", {"light", "proximity"});
    FAIL() << "too few";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(
        error.what(),
        "found the device 'my_light' on a footbot with links light_0, ... (1), allowed: 24 or more; links of other "
        "names count only on robots without light_0");
  }
  EXPECT_EQ(devices::ringOf<24>(*footbotWithLightLinks(0), "my_light", {"light", "proximity"}).size(), 24U);
}

TEST_F(LightTest, SensingAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  for (int i = 0; i < 5; ++i) {
    const Row other = world.addFootbot(4.3 + 0.2 * i, 5.0 + 0.1 * i, 0.5 * i);
    for (Color& led : world.space.leds[other]) {
      led = colors::kGreen;
    }
  }
  LightSensor light(world, robot);
  EXPECT_GT(strongestOf(light.sense()), 0.0);
  const long before = heap_allocations;
  light.sensor->sense(world.space, 0, 1);
  EXPECT_EQ(heap_allocations - before, 0);
}

TEST(LightLawTest, BrightnessIsTheMeanOfTheChannels) {
  EXPECT_EQ(Light::brightness(colors::kBlack), 0.0);
  EXPECT_EQ(Light::brightness(colors::kWhite), 1.0);
  EXPECT_NEAR(Light::brightness(colors::kYellow), 2.0 / 3.0, 1e-15);
  EXPECT_NEAR(Light::brightness({10, 20, 30}), 60.0 / 765.0, 1e-15);
}

TEST(LightLawTest, WhatIsNotBeforeTheSensorGivesNothing) {
  EXPECT_EQ(Light::share(1.0, Eigen::Vector3d::UnitX(), {0.0, 0.3, 0.0}), 0.0);
  EXPECT_EQ(Light::share(1.0, Eigen::Vector3d::UnitX(), {-0.1, 0.3, 0.0}), 0.0);
  EXPECT_EQ(Light::share(1.0, Eigen::Vector3d::UnitX(), Eigen::Vector3d::Zero()), 0.0);
}

}  // namespace
}  // namespace swarmanoid::test
