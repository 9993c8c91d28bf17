// Snapshots of all implementations of all sensors and actuators of this package, in worlds that change at random: a
// device that was in another world loads the state of one, and then goes on as it does, bit by bit.
#include <gtest/gtest.h>

#include <random>

#include "device_world.hpp"
#include "swarmanoid_interface/devices/eyebot_pan_tilt.hpp"
#include "swarmanoid_interface/devices/footbot_scanner.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"
#include "swarmanoid_interface/number_place.hpp"

namespace swarmanoid::test {
namespace {

/// Robots of all types between two walls, and preys. Two of them that change by equal random numbers are equal.
class ChangingWorld {
 public:
  /// @param commands whether robots have commands that sensors read
  ChangingWorld(unsigned seed, bool commands) : random(seed) {
    for (const char* type : {"footbot", "eyebot", "handbot", "footbot", "footbot"}) {
      robots.push_back(world.add(robotModel(type), {5.0, 5.0, 0.0}));
    }
    preys = {world.addPrey(5.0, 5.0, colors::kYellow), world.addPrey(5.0, 5.0, colors::kRed)};
    world.addWall({0.1, 5.0, 0.5}, {5.7, 5.0});
    for (std::size_t i = 0; commands && i < robots.size(); ++i) {
      const Row row = robots[i];
      senders.push_back(&world.space.actuation.bank<RangeAndBearing>().add(row));
      scanners.push_back(&world.space.actuation.bank<FootbotScanner>().add(row));
    }
  }

  double draw(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }

  /// @param is_another_tick otherwise the last one is computed again, as after an action on the space
  void change(bool is_another_tick) {
    Space& space = world.space;
    space.tick += is_another_tick ? 1 : 0;
    space.time += is_another_tick ? space.clocktick : Duration{};
    space.events.clear();
    for (std::size_t i = 0; i < robots.size(); ++i) {
      const Row row = robots[i];
      Pose& pose = world.pose(row);
      pose.position = {draw(4.5, 5.5), draw(4.5, 5.5), i == 1 ? draw(0.5, 1.0) : 0.0};
      pose.orientation = Eigen::AngleAxisd(draw(-3.0, 3.0), Eigen::Vector3d::UnitZ());
      space.entities.twist[row].linear = {draw(-1.0, 1.0), draw(-1.0, 1.0), 0.0};
      space.entities.twist[row].angular = {0.0, 0.0, draw(-1.0, 1.0)};
      AfterMoveAccess(space).wheel_turns[row] = {draw(0.0, 9.0), draw(0.0, 9.0)};
      space.placed[row] = draw(0.0, 1.0) < 0.1 ? space.tick : 0;
    }
    for (std::size_t i = 0; i < senders.size(); ++i) {
      senders[i]->sends = draw(0.0, 1.0) < 0.5;
      scanners[i]->turnAt(draw(-3.0, 3.0));
    }
    // near a robot, or far from all: readings are clear at times
    const double away = draw(0.0, 1.0) < 0.5 ? 0.0 : 3.0;
    for (const Row row : preys) {
      world.pose(row).position = {draw(4.5, 5.5) + away, draw(4.5, 5.5), 0.0};
    }
    world.takePoses();
  }

  DeviceWorld world;
  std::mt19937 random;
  std::vector<Row> robots;
  std::vector<Row> preys;
  std::vector<RangeAndBearing*> senders;
  std::vector<FootbotScanner*> scanners;
};

Bytes bytesOf(const std::string& type, const void* device) {
  Bytes bytes;
  ByteWriter writer(bytes);
  findDeviceType(type)->write(device, writer);
  return bytes;
}

Parameters parametersOf(const Registry::Entry& entry) {
  Parameters parameters{{"implementation", entry.description.implementation}};
  for (const Parameter& parameter : entry.description.parameters) {
    if (parameter.name == "slots" || parameter.name == "max_blobs") {
      parameters[parameter.name] = "1";  // they overflow
    } else if (parameter.name == "rate") {
      parameters[parameter.name] = "3";  // less than one in a tick
    }
  }
  return parameters;
}

/// Adds a device to the first robot that may have it. @return null if there is none
template <class Base>
auto addTo(ChangingWorld& world, Base& device, Row& row) -> decltype(device.add(world.world.space, row)) {
  const std::string& only = findDeviceType(device.type())->robot;
  for (const Row robot : world.robots) {
    if (!only.empty() && only != world.world.space.entities.model[robot]->type) {
      continue;
    }
    try {
      row = robot;
      return device.add(world.world.space, row);
    } catch (const ConfigError&) {  // another robot
    } catch (const std::exception&) {
    }
  }
  return nullptr;
}

template <class Device>
void load(const Space& space_of_from, Device& from, const Space& space, Device& into) {
  std::vector<std::byte> bytes;
  StateArchive saved(bytes);
  from.archive(space_of_from, saved);
  StateArchive loaded(Span<const std::byte>(bytes.data(), bytes.size()));
  into.archive(space, loaded);
  EXPECT_TRUE(loaded.isAtEnd());
}

/// What a device has done beside its readings or its actuation.
std::vector<double> effectsOf(const Space& space, Row row) {
  std::vector<double> numbers{static_cast<double>(space.events.size()), space.wheels[row].left, space.wheels[row].right,
                              space.flight[row].yaw_rate, space.wheel_turns[row].left};
  numbers.insert(numbers.end(), space.flight[row].linear.data(), space.flight[row].linear.data() + 3);
  return numbers;
}

/// Two worlds, each with the device. @param step one tick of a world with its device
/// @param outcome bytes of the readings or the actuation
template <class Device, class Step, class Outcome>
void expectSameAfterLoading(const std::string& name, ChangingWorld& first, ChangingWorld& second, Device& device,
                            Device& other, Row row, Step step, Outcome outcome) {
  ++second.world.space.tick;
  for (unsigned snapshot = 0; snapshot < 6; ++snapshot) {
    for (int apart = 0; apart < 9; ++apart) {
      step(first, 0, true);
      step(second, 1, true);
    }
    load(first.world.space, device, second.world.space, other);
    second.world.space.tick = first.world.space.tick;
    second.world.space.time = first.world.space.time;
    second.world.space.overflows = first.world.space.overflows;
    second.random = first.random;
    for (int together = 0; together < 9; ++together) {
      step(first, 0, together > 0);
      step(second, 1, together > 0);
      ASSERT_EQ(outcome(0), outcome(1)) << name << ", tick " << first.world.space.tick;
      ASSERT_EQ(effectsOf(first.world.space, row), effectsOf(second.world.space, row)) << name;
    }
    second.random.seed(snapshot);
    ++second.world.space.tick;
  }
}

bool needsFile(const Registry::Entry& entry) {
  for (const Parameter& parameter : entry.description.parameters) {
    if (!parameter.value) {
      return true;
    }
  }
  return false;
}

void testSensor(const Registry::Entry& entry, int& tested) {
  const std::string& type = entry.description.label;
  ChangingWorld first(1, true);
  ChangingWorld second(2, true);
  const auto device = makeDevice<Sensor>(PluginKind::kSensor, type, parametersOf(entry));
  const auto other = makeDevice<Sensor>(PluginKind::kSensor, type, parametersOf(entry));
  Row row = kNoRow;
  second.world.pose(second.robots[1]).position.z() = 0.3;  // added at another height
  const std::array<const void*, 2> readings{addTo(first, *device, row), addTo(second, *other, row)};
  if (readings[0] == nullptr) {
    return;  // batteries
  }
  ++tested;
  const std::array<Sensor*, 2> sensors{device.get(), other.get()};
  expectSameAfterLoading(
      type + " " + entry.description.implementation, first, second, *device, *other, row,
      [&](ChangingWorld& world, std::size_t i, bool is_another_tick) {
        world.change(is_another_tick);
        world.world.sense(*sensors[i]);
      },
      [&](std::size_t i) { return bytesOf(type, readings[i]); });
}

void testActuator(const Registry::Entry& entry, int& tested) {
  const std::string& type = entry.description.label;
  ChangingWorld first(1, false);
  ChangingWorld second(2, false);
  const auto device = makeDevice<Actuator>(PluginKind::kActuator, type, parametersOf(entry));
  const auto other = makeDevice<Actuator>(PluginKind::kActuator, type, parametersOf(entry));
  Row row = kNoRow;
  const std::array<void*, 2> commands{addTo(first, *device, row), addTo(second, *other, row)};
  ASSERT_NE(commands[0], nullptr) << type;
  ++tested;
  const std::array<Actuator*, 2> actuators{device.get(), other.get()};
  const DeviceType& described = *findDeviceType(type);
  expectSameAfterLoading(
      type + " " + entry.description.implementation, first, second, *device, *other, row,
      [&](ChangingWorld& world, std::size_t i, bool is_another_tick) {
        world.change(is_another_tick);
        for (const DeviceNumber& number : described.numbers) {
          const NumberPlace place = placeOf(number, described.fields[number.field]);
          const bool is_mode = number.kind == DeviceNumber::Kind::kEnumeration;
          if (world.draw(0.0, 1.0) < 0.3) {
            const double most = is_mode ? std::min(place.range.maximum, 2.0) : std::min(place.range.maximum, 1.0);
            place.write(static_cast<std::byte*>(commands[i]),
                        world.draw(std::max(place.range.minimum, is_mode ? 0.0 : -1.0), most));
          }
        }
        world.world.actuate(*actuators[i]);
        actuators[i]->afterMove(world.world.space, AfterMoveAccess(world.world.space));
      },
      [&](std::size_t i) { return bytesOf(type, (i == 0 ? first : second).world.space.actuation.find(type, row)); });
}

TEST(DeviceArchiveTest, SensorsGoOnWithTheSameReadings) {
  loadPluginLibrary("swarmanoid_devices", {}, {});
  int tested = 0;
  for (const Registry::Entry* entry : Registry::instance().all(PluginKind::kSensor)) {
    if (!needsFile(*entry)) {
      testSensor(*entry, tested);
    }
  }
  EXPECT_GE(tested, 40);
}

TEST(DeviceArchiveTest, ActuatorsGoOnWithTheSameActuation) {
  loadPluginLibrary("swarmanoid_devices", {}, {});
  int tested = 0;
  for (const Registry::Entry* entry : Registry::instance().all(PluginKind::kActuator)) {
    testActuator(*entry, tested);
  }
  EXPECT_GE(tested, 20);
}

}  // namespace
}  // namespace swarmanoid::test
