// The battery sensor: it reads the state of the battery in the space, and is refused without a battery.
#include "swarmanoid_interface/devices/battery.hpp"

#include <gtest/gtest.h>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

namespace swarmanoid::test {
namespace {

std::shared_ptr<const EntityModel> poweredFootbot(double capacity, double first_share) {
  const std::shared_ptr<const EntityModel> footbot = robotModel("footbot");
  BatteryModel battery = *footbot->possible_battery;
  battery.capacity = capacity;
  battery.first_share = first_share;
  return robotWithBattery(*footbot, battery);
}

TEST(BatteryTest, ReportsWhatIsLeftAndWhatFlows) {
  DeviceWorld world;
  const Row robot = world.add(poweredFootbot(130.0, 0.7), {1.0, 1.0, 0.0});
  SensorUnderTest<Battery> sensor(world, robot);
  const Battery& battery = sensor.sense();
  EXPECT_EQ(battery.charge, 91.0F);
  EXPECT_EQ(battery.capacity, 130.0F);
  EXPECT_EQ(battery.voltage, 3.7F);
  EXPECT_NEAR(battery.fraction(), 0.7F, 1e-6F);
  EXPECT_FALSE(battery.is_charging);
  EXPECT_FALSE(battery.on_capacitor);
  world.space.batteries[robot][0].power = 4.81;
  EXPECT_FLOAT_EQ(sensor.sense().power, 4.81F);
  EXPECT_NEAR(battery.current(), -1.3F, 1e-6F) << "4.81 W at 3.7 V, which leave the battery";
  world.space.properties[robot][kBatterySupply] = 12.21;
  world.space.batteries[robot][0].input = 12.21;
  EXPECT_TRUE(sensor.sense().is_charging);
  EXPECT_NEAR(battery.current(), 2.0F, 1e-6F);
}

TEST(BatteryTest, KnowsWhetherTheSuperCapacitorAloneKeepsItAlive) {
  DeviceWorld world;
  const Row robot = world.add(poweredFootbot(130.0, 0.7), {1.0, 1.0, 0.0});
  SensorUnderTest<Battery> sensor(world, robot);
  world.space.properties[robot][kBatteryCharge] = 0.0;
  EXPECT_TRUE(sensor.sense().on_capacitor);
  world.space.properties[robot][kBatteryCapacitor] = 0.0;
  world.space.batteries[robot][0].is_empty = true;
  EXPECT_FALSE(sensor.sense().on_capacitor) << "it is off";
}

TEST(BatteryTest, HasReadingsBeforeTheFirstTick) {
  DeviceWorld world;
  const Row robot = world.add(poweredFootbot(130.0, 0.7), {1.0, 1.0, 0.0});
  const auto sensor = makeDevice<Sensor>(PluginKind::kSensor, Battery::kType, {});
  EXPECT_EQ(static_cast<const Battery*>(sensor->add(world.space, robot))->charge, 91.0F);
}

TEST(BatteryTest, IsRefusedWhereThereIsNone) {
  using UnderTest = SensorUnderTest<Battery>;
  EXPECT_EQ(refusalOf<UnderTest>(robotModel("footbot")),
            "battery: found a footbot without one, allowed: robots with <battery>true</battery>");
  EXPECT_EQ(refusalOf<UnderTest>(cylindricPreyModel(0.06, 0.1)),
            "battery: found a cylindric_prey without one, allowed: robots whose description has a <battery>");
}

TEST(BatteryTest, ErrorsActOnItsReadings) {
  DeviceWorld world;
  const Row robot = world.add(poweredFootbot(130.0, 0.7), {1.0, 1.0, 0.0});
  SensorUnderTest<Battery> sensor(world, robot, {}, {bias("charge", "-1.5")});
  EXPECT_EQ(sensor.sense().charge, 89.5F);
}

TEST(BatteryTest, ATickDoesNotAllocate) {
  DeviceWorld world;
  SensorUnderTest<Battery> sensor(world, world.add(poweredFootbot(130.0, 0.7), {1.0, 1.0, 0.0}));
  sensor.sense();
  const long before = heap_allocations;
  sensor.sense();
  EXPECT_EQ(heap_allocations - before, 0);
}

}  // namespace
}  // namespace swarmanoid::test
