// Light sensors sum sources in the order of entity numbers: the same sources give the same bits in any order of rows.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "../src/surroundings/light_sources.hpp"
#include "device_world.hpp"
#include "swarmanoid_interface/devices/light.hpp"

namespace swarmanoid::test {
namespace {

constexpr int kLamps = 12;
constexpr int kCrowd = 70;  // more lamps than are checked one by one
constexpr std::size_t kSensors = 24;
const Eigen::Vector3d kCentre(5.0, 5.0, 0.3);

/// Positions around the sensors, 0.5 to 1.1 m away.
Eigen::Vector3d placeOfLamp(int lamp) {
  const double angle = 2.4 * lamp;
  const double way = 0.5 + 0.05 * lamp;
  return kCentre + Eigen::Vector3d(way * std::cos(angle), way * std::sin(angle), 0.03 * lamp);
}

Color colorOfLamp(int lamp) {
  return {static_cast<std::uint8_t>(10 + 17 * lamp), static_cast<std::uint8_t>(200 - 13 * lamp),
          static_cast<std::uint8_t>(5 * lamp)};
}

devices::IlluminatedSensor sensor(std::size_t i) {
  const double angle = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(kSensors);
  devices::IlluminatedSensor sensor;
  sensor.direction = {std::cos(angle), std::sin(angle), 0.0};
  sensor.position = kCentre + 0.05 * sensor.direction;
  return sensor;
}

using Sums = std::array<double, kSensors>;

/// Sums of the sensors over all lit entities.
Sums sumsIn(DeviceWorld& world) {
  world.takePoses();
  std::array<devices::IlluminatedSensor, kSensors> sensors;
  for (std::size_t i = 0; i < kSensors; ++i) {
    sensors[i] = sensor(i);
  }
  const devices::LightReach reach{2.0, 2.0};
  devices::LitEntities lit;
  lit.fill(world.space, reach);
  std::vector<Row> near;
  lit.collect(world.space, kNoRow, kCentre, 0.05, reach, near);
  devices::IlluminatedRing ring;
  ring.centre = kCentre;
  ring.radius = 0.05;
  ring.lowest = ring.highest = kCentre.z();
  ring.reach = reach;
  ring.sensors = {sensors.data(), sensors.size()};
  Sums sums{};
  devices::LightSearch search;
  const devices::LightOnRing& lights = search.find(world.space, ring, near);
  for (std::size_t k = 0; k < lights.size(); ++k) {
    const devices::LightOnSensor light = lights[k];
    sums[light.sensor] += Light::share(light.brightness, sensors[light.sensor].direction, light.offset);
  }
  Sums at_once{};
  lights.addTo(at_once.data());
  EXPECT_EQ(at_once, sums) << "shares of several lights at once";
  return sums;
}

/// Adds the lamps in the order of their numbers. @param rows output: rows of the lamps @return sums of the sensors
Sums sumsOfLamps(DeviceWorld& world, std::vector<Row>& rows) {
  for (int lamp = 0; lamp < kLamps; ++lamp) {
    rows.push_back(world.add(lightModel(), placeOfLamp(lamp), 0.0, colorOfLamp(lamp)));
  }
  return sumsIn(world);
}

double shareOf(int lamp, const devices::IlluminatedSensor& sensor) {
  return Light::share(Light::brightness(colorOfLamp(lamp)), sensor.direction, placeOfLamp(lamp) - sensor.position);
}

TEST(LightOrderTest, SourcesAreAddedInTheOrderOfTheirNumbers) {
  DeviceWorld world;
  std::vector<Row> rows;
  const Sums straight = sumsOfLamps(world, rows);

  DeviceWorld other;
  std::vector<Row> gone;
  for (int i = 0; i < kLamps; ++i) {
    gone.push_back(other.add(lightModel(), {1.0, 1.0, 1.0}, 0.0, colors::kWhite));
  }
  // some rows are freed later than others, so new entities get them in another order
  for (int i = 0; i < kLamps; ++i) {
    other.remove(gone[static_cast<std::size_t>((5 * i) % kLamps)]);
  }
  std::vector<Row> other_rows;
  const Sums mixed = sumsOfLamps(other, other_rows);
  ASSERT_NE(other_rows, rows) << "other rows for the same lamps";

  int sensitive = 0;
  for (std::size_t i = 0; i < kSensors; ++i) {
    double by_numbers = 0.0;
    double by_rows = 0.0;
    for (int lamp = 0; lamp < kLamps; ++lamp) {
      by_numbers += shareOf(lamp, sensor(i));
    }
    for (const Row row : rows) {
      for (int lamp = 0; lamp < kLamps; ++lamp) {
        by_rows += other_rows[static_cast<std::size_t>(lamp)] == row ? shareOf(lamp, sensor(i)) : 0.0;
      }
    }
    EXPECT_GT(straight[i], 0.0) << "sensor " << i;
    EXPECT_EQ(straight[i], by_numbers) << "sensor " << i;
    EXPECT_EQ(mixed[i], by_numbers) << "sensor " << i;
    sensitive += by_rows == by_numbers ? 0 : 1;
  }
  EXPECT_GT(sensitive, 0) << "the order of rows would give other bits";
}

// A few lamps are checked one by one; many are found with the index.
TEST(LightOrderTest, LampsOutOfReachChangeNothingHoweverMany) {
  DeviceWorld world;
  std::vector<Row> rows;
  const Sums alone = sumsOfLamps(world, rows);
  for (int i = 0; i < kCrowd; ++i) {
    world.add(lightModel(), {0.5 + 0.11 * i, 1.0, 0.3}, 0.0, colors::kWhite);  // 4 m away
  }
  EXPECT_EQ(sumsIn(world), alone);
}

TEST(LightOrderTest, ManyLampsAddUpAsFewDo) {
  const auto place_of = [](int lamp) { return Eigen::Vector3d(5.5 + 0.01 * lamp, 5.1, 0.4); };
  DeviceWorld world;
  Sums expected{};
  for (int lamp = 0; lamp < kCrowd; ++lamp) {
    world.add(lightModel(), place_of(lamp), 0.0, colorOfLamp(lamp % kLamps));
    for (std::size_t i = 0; i < kSensors; ++i) {
      const devices::IlluminatedSensor each = sensor(i);
      expected[i] +=
          Light::share(Light::brightness(colorOfLamp(lamp % kLamps)), each.direction, place_of(lamp) - each.position);
    }
  }
  EXPECT_EQ(sumsIn(world), expected);
}

}  // namespace
}  // namespace swarmanoid::test
