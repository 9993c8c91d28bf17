// Readers and writers of radio tags; the antenna of a footbot is on its axis, 0.01 m above the ground.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/devices/rfid.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"
#include "swarmanoid_space/models/entity_type.hpp"
#include "swarmanoid_space/models/properties.hpp"

namespace swarmanoid::test {
namespace {

using Reader = SensorUnderTest<RfidReader>;
using Writer = ActuatorUnderTest<RfidWriter>;

std::shared_ptr<const EntityModel> tag(const std::string& id, const std::string& data = "0") {
  Configuration parameters("rfid_tag", "", {});
  parameters.set(kTag, id);
  parameters.set(kTagData, data);
  return makePlugin<EntityType>(*Registry::instance().find(PluginKind::kEntity, "rfid_tag"))->makeModel(parameters);
}

std::vector<std::uint32_t> idsOf(const RfidReader& reader) {
  std::vector<std::uint32_t> ids;
  for (const RfidTagReading& each : reader.tags) {
    ids.push_back(each.id);
  }
  return ids;
}

using Ids = std::vector<std::uint32_t>;

double dataOf(const DeviceWorld& world, Row row) { return *world.space.property(row, kTagData); }

TEST(RfidTest, ReadsTheTagsWithinReachTheNearestFirst) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0, 0.7);
  world.add(tag("31", "4294967295"), {4.03, 5.04, 0.0});
  world.add(tag("4294967295", "7"), {3.98, 5.01, 0.02});
  const Row edge = world.add(tag("5"), {4.0, 5.0 - 0.0591, 0.0});  // 0.05994 m from the antenna
  Reader reader(world, robot);
  EXPECT_EQ(idsOf(reader.sense()), (Ids{4294967295U, 31, 5}));
  EXPECT_EQ(reader.sense().tags[1].data, 4294967295U);
  EXPECT_EQ(reader.sense().tags[0].data, 7U);
  EXPECT_FALSE(reader.sense().overflowed);
  world.pose(edge).position.y() = 5.0 - 0.0593;  // 0.06014 m
  EXPECT_EQ(idsOf(reader.sense()), (Ids{4294967295U, 31}));
  world.pose(robot).position.z() = 0.06;
  EXPECT_EQ(idsOf(reader.sense()), Ids{4294967295U}) << "lifted";
  world.pose(robot).position = {8.0, 8.0, 0.0};
  EXPECT_TRUE(reader.sense().tags.empty());
}

TEST(RfidTest, TheReachIsAParameterAndNothingHidesATag) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0);
  world.add(tag("2"), {4.3, 5.4, 0.01});
  world.addWall({0.02, 2.0, 0.5}, {4.2, 5.0});
  EXPECT_EQ(idsOf(Reader(world, robot, {{"reach", "0.5001"}}).sense()), Ids{2});
}

TEST(RfidTest, TheReachEndsWhereItEnds) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0);
  world.add(tag("2"), {4.3, 5.4, 0.01});
  EXPECT_TRUE(Reader(world, robot, {{"reach", "0.4999"}}).sense().tags.empty());
}

TEST(RfidTest, OfEquallyNearTagsTheLowerEntityNumberComesFirst) {
  DeviceWorld world;
  const Row gone = world.addPrey(1.0, 1.0);
  const Row robot = world.addFootbot(4.0, 5.0);
  world.add(tag("9"), {4.03125, 5.0, 0.0});
  world.remove(gone);
  const Row later = world.add(tag("8"), {3.96875, 5.0, 0.0});
  EXPECT_EQ(later, gone) << "in a lower row";
  EXPECT_EQ(idsOf(Reader(world, robot).sense()), (Ids{9, 8}));
}

TEST(RfidTest, MoreTagsThanSlotsAreAnOverflow) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0);
  for (int i = 0; i < 5; ++i) {
    world.add(tag(std::to_string(10 + i)), {4.05 - 0.007 * i, 5.003, 0.0});
  }
  Reader reader(world, robot, {{"slots", "3"}});
  EXPECT_EQ(idsOf(reader.sense()), (Ids{14, 13, 12}));
  EXPECT_TRUE(reader.sense().overflowed);
  ASSERT_EQ(world.space.events.size(), 1U) << "one, when it begins";
  EXPECT_EQ(world.space.events[0].text, "rfid_reader: more than 3 tags");
}

TEST(RfidTest, WritesToTheNearestOrToTheOneItNames) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0, 2.1);
  const Row near = world.add(tag("3", "50"), {4.02, 5.01, 0.0});
  const Row named = world.add(tag("4", "60"), {4.0, 4.96, 0.0});
  const Row far = world.add(tag("5", "70"), {4.1, 5.0, 0.0});
  world.takePoses();
  Writer writer(world, robot);
  writer.actuate();
  EXPECT_EQ(dataOf(world, near), 50.0) << "at rest it writes nothing";
  writer.command.write(123456);
  writer.actuate();
  EXPECT_EQ(dataOf(world, near), 123456.0);
  EXPECT_EQ(dataOf(world, named), 60.0);
  writer.command.write(0, 4);
  writer.actuate();
  EXPECT_EQ(dataOf(world, near), 123456.0);
  EXPECT_EQ(dataOf(world, named), 0.0);
  writer.command.write(1, 5);
  writer.actuate();
  EXPECT_EQ(dataOf(world, far), 70.0) << "0.1005 m away";
  EXPECT_TRUE(writer.stop());
  EXPECT_FALSE(writer.command.writes);
}

TEST(RfidTest, ARobotWhoseControllerFailsWritesNoMore) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0);
  const Row near = world.add(tag("3", "50"), {4.02, 5.01, 0.0});
  world.takePoses();
  Writer writer(world, robot);
  writer.command.write(71);
  world.space.controllers[robot].status = StepStatus::kFailed;
  writer.actuate();
  EXPECT_EQ(dataOf(world, near), 50.0);
  world.space.controllers[robot].status = StepStatus::kStepped;
  writer.actuate();
  EXPECT_EQ(dataOf(world, near), 71.0);
}

TEST(RfidTest, OfSeveralWhoWriteInOneTickTheHighestEntityNumberWins) {
  DeviceWorld world;
  const Row a = world.addFootbot(4.0, 5.0);
  const Row b = world.addFootbot(4.04, 5.0);
  const Row shared = world.add(tag("3"), {4.02, 5.0, 0.0});
  world.takePoses();
  auto writers = makeDevice<Actuator>(PluginKind::kActuator, RfidWriter::kType, {});
  static_cast<RfidWriter*>(writers->add(world.space, a))->write(71);
  static_cast<RfidWriter*>(writers->add(world.space, b))->write(72);
  world.actuate(*writers);
  EXPECT_EQ(dataOf(world, shared), 72.0);
}

TEST(RfidTest, WhatIsWrittenIsReadInTheNextTickAndIsInTheHashOfTheState) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0);
  world.add(tag("3", "1"), {4.02, 5.0, 0.0});
  Reader reader(world, robot);
  EXPECT_EQ(reader.sense().tags[0].data, 1U);
  const std::uint64_t before = stateHash(world.space);
  Writer writer(world, robot);
  writer.command.write(2);
  writer.actuate();
  EXPECT_NE(stateHash(world.space), before);
  EXPECT_EQ(reader.sense().tags[0].data, 2U);
}

/// A tag of a package: on an entity with shapes, and with a smaller range of data.
std::shared_ptr<EntityModel> smallTag() {
  auto model = std::make_shared<EntityModel>(*cylindricPreyModel(0.03, 0.1));
  model->properties = {{kTagData, "", "Content.", {0.0, 255.0}, 17.0}, {kTag, "", "Its id.", kTagRange, 6.0}};
  return model;
}

TEST(RfidTest, ATagRefusesWhatItCannotHold) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0);
  const Row thing = world.add(smallTag(), {4.05, 5.0, 0.0});
  world.takePoses();
  Writer writer(world, robot);
  writer.command.write(256);
  writer.actuate();
  EXPECT_EQ(dataOf(world, thing), 17.0);
  writer.command.write(255);
  writer.actuate();
  EXPECT_EQ(dataOf(world, thing), 255.0);
  EXPECT_EQ(idsOf(Reader(world, robot).sense()), Ids{6});
}

TEST(RfidTest, RobotsWithoutAnAntennaAreRefused) {
  EXPECT_EQ(refusalOf<Reader>(robotModel("eyebot")),
            "found the device 'rfid_reader' on a eyebot, allowed: on robots with the link rfid_antenna");
  EXPECT_EQ(refusalOf<Writer>(robotModel("handbot")),
            "found the device 'rfid_writer' on a handbot, allowed: on robots with the link rfid_antenna");
}

TEST(RfidTest, ASteadyStateTouchesNoHeap) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0);
  for (int i = 0; i < 9; ++i) {
    world.add(tag(std::to_string(1 + i)), {4.04 - 0.007 * i, 5.003, 0.0});
  }
  Reader reader(world, robot);
  Writer writer(world, robot);
  writer.command.write(2);
  reader.sense();
  writer.actuate();
  const long before = heap_allocations;
  reader.sensor->update(world.space, 0, 1);
  writer.actuate();
  EXPECT_EQ(heap_allocations - before, 0);
}

}  // namespace
}  // namespace swarmanoid::test
