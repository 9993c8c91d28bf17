// WiFi and Bluetooth: the receivers of messages, losses over distance, and the capacity of a shared channel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "../src/common/loss_law.hpp"
#include "device_world.hpp"
#include "swarmanoid_interface/devices/bluetooth.hpp"
#include "swarmanoid_interface/devices/wifi.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

namespace swarmanoid::test {
namespace {

/// Radios of one type on the robots of a world.
template <class Radio, class Received>
class RadioWorld : public DeviceWorld {
 public:
  struct Station {
    Row row;
    Radio* command;
    const Received* received;
    RadioAddress address;

    /// The first byte of each message.
    std::vector<int> heard() const {
      std::vector<int> bytes;
      for (const auto& message : received->messages) {
        bytes.push_back(message.payload[0]);
      }
      return bytes;
    }
  };

  explicit RadioWorld(const Parameters& parameters = {}, std::uint64_t seed = 1)
      : DeviceWorld(seed),
        receiver(makeDevice<Sensor>(PluginKind::kSensor, Received::kType, parameters)),
        sender(makeDevice<Actuator>(PluginKind::kActuator, Radio::kType, {})) {}

  Station equip(Row row) {
    return {row, static_cast<Radio*>(sender->add(space, row)), static_cast<const Received*>(receiver->add(space, row)),
            addressOf(space.entities.name[row])};
  }
  Station footbot(double x, double y) { return equip(addFootbot(x, y)); }

  void exchange() {
    actuate(*sender);
    ++space.tick;
    sense(*receiver);
  }

  std::shared_ptr<Sensor> receiver;
  std::shared_ptr<Actuator> sender;
};

using WifiWorld = RadioWorld<Wifi, WifiReceived>;
using BluetoothWorld = RadioWorld<Bluetooth, BluetoothReceived>;
const Parameters kWithoutLoss{{"loss_at_range", "0"}};

TEST(RadioTest, AnAddressIsThatOfTheName) {
  EXPECT_EQ(addressOf("fb_1"), RadioAddress{22510536293955});
  EXPECT_NE(addressOf("fb_1"), addressOf("fb_2"));
  EXPECT_LT(addressOf("a long name of a robot"), RadioAddress{1} << 48U);
  EXPECT_NE(addressOf(""), kEverybody);
}

TEST(RadioTest, MessagesGoThroughWallsAndSayWhoSentThem) {
  WifiWorld world(kWithoutLoss);
  const auto a = world.footbot(2.0, 5.0);
  const auto b = world.footbot(8.3, 5.4);
  world.addWall({0.1, 9.0, 2.0}, {5.0, 5.0});
  Wifi::Payload payload{};
  payload[0] = 7;
  payload[127] = 255;
  a.command->send(payload);
  world.exchange();
  EXPECT_TRUE(a.received->messages.empty()) << "nobody hears itself";
  ASSERT_EQ(b.received->messages.size(), 1U);
  EXPECT_EQ(b.received->messages[0].sender, a.address);
  EXPECT_EQ(b.received->messages[0].payload, payload);
  a.command->fallSilent();
  world.exchange();
  EXPECT_TRUE(b.received->messages.empty());
}

TEST(RadioTest, WhatIsForOneRobotNobodyElseReads) {
  WifiWorld world(kWithoutLoss);
  const auto a = world.footbot(2.0, 5.0);
  const auto b = world.footbot(3.0, 5.0);
  const auto c = world.footbot(2.5, 5.6);
  a.command->send({1}, c.address);
  b.command->send({2});
  world.exchange();
  EXPECT_EQ(c.heard(), (std::vector<int>{1, 2}));
  EXPECT_EQ(b.heard(), std::vector<int>{});
  EXPECT_EQ(a.heard(), std::vector<int>{2});
  a.command->send({1}, addressOf("nobody"));
  world.exchange();
  EXPECT_EQ(c.heard(), std::vector<int>{2});
}

TEST(RadioTest, WhatIsForOthersTakesSlotsOfTheChannel) {
  WifiWorld world(Parameters{{"loss_at_range", "0"}, {"slots", "2"}});
  const auto middle = world.footbot(5.0, 5.0);
  const auto near = world.footbot(5.4, 5.3);
  const auto next = world.footbot(4.2, 5.5);
  const auto far = world.footbot(6.5, 3.7);
  near.command->send({1}, next.address);
  next.command->send({2});
  far.command->send({3}, middle.address);
  world.exchange();
  EXPECT_EQ(middle.heard(), std::vector<int>{2});
  EXPECT_TRUE(middle.received->overflowed);
  ASSERT_EQ(world.space.events.size(), 1U) << "the others do not hear themselves";
  EXPECT_EQ(world.space.events[0].text, "wifi_received: more than 2 messages");
  near.command->fallSilent();
  world.exchange();
  EXPECT_EQ(middle.heard(), (std::vector<int>{2, 3}));
  EXPECT_FALSE(middle.received->overflowed);
}

TEST(RadioTest, BluetoothIsShort) {
  BluetoothWorld world(kWithoutLoss);
  world.space.size = {30.0, 10.0, 3.0};
  world.space.index.configure(world.space.size, PositionalIndex::Optimization::k2D, 16);
  const auto a = world.footbot(3.0, 5.0);
  const auto b = world.footbot(3.0 + 8.0 - 1e-6, 5.0 - 6.0);
  const auto c = world.footbot(3.0 + 8.0 + 1e-6, 5.0 + 6.0);
  a.command->send({5});
  world.exchange();
  EXPECT_EQ(b.heard(), std::vector<int>{5}) << "less than 10 m away";
  EXPECT_EQ(c.heard(), std::vector<int>{}) << "more";
}

TEST(RadioTest, AChannelCarriesSevenMessagesOfTheNearest) {
  BluetoothWorld world(kWithoutLoss);
  const auto middle = world.footbot(5.0, 5.0);
  for (int i = 0; i < 9; ++i) {
    const double distance = 2.2 - 0.15 * ((4 * i) % 9);
    const auto other = world.footbot(5.0 + distance * std::cos(0.7 * i), 5.0 + distance * std::sin(0.7 * i));
    other.command->send({static_cast<std::uint8_t>(i)});
  }
  world.exchange();
  // the farthest have 4 i modulo 9 equal to 0 and 1: i is 0 and 7
  EXPECT_EQ(middle.heard(), (std::vector<int>{1, 2, 3, 4, 5, 6, 8}));
  EXPECT_TRUE(middle.received->overflowed);
}

TEST(RadioTest, LossGrowsWithAPowerOfTheDistance) {
  const auto law = [](double range, const char* loss, const char* at_range, const char* exponent) {
    Configuration parameters("radio", "", {});
    parameters.set("loss", loss);
    parameters.set("loss_at_range", at_range);
    parameters.set("loss_exponent", exponent);
    return devices::LossLaw(parameters, range);
  };
  EXPECT_FALSE(law(3.0, "0", "0", "2").loses());
  EXPECT_EQ(law(3.0, "0.3", "0", "2").probability(4.0), 0.3);
  EXPECT_NEAR(law(100.0, "0", "0.1", "2").probability(37.0 * 37.0), 0.01369, 1e-12);
  EXPECT_NEAR(law(10.0, "0.1", "0.6", "3").probability(25.0), 0.1675, 1e-12);
  EXPECT_NEAR(law(10.0, "0.1", "0.6", "1").probability(25.0), 0.37, 1e-12);
  EXPECT_NEAR(law(10.0, "0", "0.6", "8").probability(64.0), 0.6 * 0.16777216, 1e-12);
  EXPECT_NEAR(law(10.0, "0.25", "0.2", "5").probability(100.0), 0.4, 1e-12);
}

TEST(RadioTest, SoManyAreLostAsTheLawSays) {
  WifiWorld world(Parameters{{"range", "8"}, {"loss", "0.1"}, {"loss_at_range", "0.6"}, {"loss_exponent", "3"}});
  const auto middle = world.footbot(1.0, 5.0);
  const auto half = world.footbot(1.0 + 4.0 * std::cos(0.3), 5.0 + 4.0 * std::sin(0.3));
  const auto near = world.footbot(1.0, 5.4);
  half.command->send({1});
  near.command->send({2});
  constexpr int kTicks = 20000;
  int of_half = 0;
  int of_near = 0;
  int of_both = 0;
  for (int i = 0; i < kTicks; ++i) {
    world.exchange();
    const std::vector<int> heard = middle.heard();
    const bool has_half = std::count(heard.begin(), heard.end(), 1) == 1;
    const bool has_near = std::count(heard.begin(), heard.end(), 2) == 1;
    of_half += has_half ? 1 : 0;
    of_near += has_near ? 1 : 0;
    of_both += has_half && has_near ? 1 : 0;
  }
  const auto expectShare = [](int count, double probability) {
    EXPECT_NEAR(count, kTicks * probability, 4.0 * std::sqrt(kTicks * probability * (1.0 - probability)));
  };
  expectShare(of_half, 1.0 - 0.1675);
  expectShare(of_near, 1.0 - 0.1 - 0.9 * 0.6 * 0.000125);
  expectShare(of_both, (1.0 - 0.1675) * (1.0 - 0.1 - 0.9 * 0.6 * 0.000125));
}

TEST(RadioTest, WhoElseSendsDoesNotChangeWhichMessagesAreLost) {
  const auto heardOfFirst = [](int others) {
    WifiWorld world(Parameters{{"loss", "0.4"}, {"slots", "5"}});
    const auto middle = world.footbot(5.0, 5.0);
    const auto first = world.footbot(5.3, 5.2);
    first.command->send({1});
    for (int i = 0; i < others; ++i) {
      const auto other = world.footbot(1.0 + 0.21 * (i % 37), 0.5 + 0.3 * (i / 37));
      other.command->send({2});
    }
    std::vector<bool> heard;
    for (int i = 0; i < 60; ++i) {
      world.exchange();
      const std::vector<int> bytes = middle.heard();
      heard.push_back(std::count(bytes.begin(), bytes.end(), 1) == 1);
      EXPECT_LE(bytes.size(), 5U);
      world.sense(*world.receiver);
      EXPECT_EQ(middle.heard(), bytes) << "a tick that is made again";
    }
    return heard;
  };
  const std::vector<bool> alone = heardOfFirst(0);
  EXPECT_GT(std::count(alone.begin(), alone.end(), false), 10);
  EXPECT_GT(std::count(alone.begin(), alone.end(), true), 10);
  EXPECT_EQ(heardOfFirst(3), alone);
  EXPECT_EQ(heardOfFirst(200), alone) << "of whom nobody is nearer";
}

/// A few senders are checked one by one; many are found with the index, from near to far. Both find the nearest.
TEST(RadioTest, InACrowdTheNearestAreHeard) {
  constexpr int kRobots = 300;
  for (const int senders : {3, 40, 60, 300}) {
    BluetoothWorld world(kWithoutLoss);
    RandomStream random(9, "crowd", "places");
    std::vector<BluetoothWorld::Station> stations;
    for (int i = 0; i < kRobots; ++i) {
      const double x = random.uniform(0.2, 9.8);
      stations.push_back(world.footbot(x, random.uniform(0.2, 9.8)));
      if (i * senders / kRobots != (i + 1) * senders / kRobots) {
        stations.back().command->send({static_cast<std::uint8_t>(i % 256), static_cast<std::uint8_t>(i / 256)});
      }
    }
    for (const std::size_t threads : {1U, 2U, 3U}) {
      world.actuate(*world.sender);
      ++world.space.tick;
      world.takePoses();
      world.receiver->prepare(world.space);
      std::vector<std::thread> workers;
      for (std::size_t k = 0; k < threads; ++k) {
        workers.emplace_back(
            [&, k] { world.receiver->sense(world.space, k * kRobots / threads, (k + 1) * kRobots / threads); });
      }
      for (std::thread& worker : workers) {
        worker.join();
      }
      for (const auto& station : stations) {
        std::vector<std::pair<double, int>> around;
        for (int i = 0; i < kRobots; ++i) {
          const auto& other = stations[static_cast<std::size_t>(i)];
          if (other.row != station.row && other.command->sends) {
            around.emplace_back((world.pose(other.row).position - world.pose(station.row).position).norm(), i);
          }
        }
        std::sort(around.begin(), around.end());
        while (!around.empty() && (around.size() > 7 || around.back().first > 10.0)) {
          around.pop_back();
        }
        std::vector<int> expected;
        for (const auto& [distance, number] : around) {
          expected.push_back(number);
        }
        std::sort(expected.begin(), expected.end());
        std::vector<int> heard;
        for (const BluetoothMessage& message : station.received->messages) {
          heard.push_back(message.payload[0] + 256 * message.payload[1]);
        }
        ASSERT_EQ(heard, expected) << senders << " senders, " << threads << " threads";
      }
    }
  }
}

TEST(RadioTest, SensingAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  WifiWorld world(Parameters{{"slots", "3"}});
  for (int i = 0; i < 30; ++i) {
    world.footbot(1.0 + 0.3 * (i % 6), 1.0 + 0.3 * (i / 6)).command->send({1});
  }
  for (int i = 0; i < 5; ++i) {
    world.exchange();
  }
  const long before = heap_allocations;
  world.receiver->prepare(world.space);
  world.receiver->sense(world.space, 0, world.receiver->instanceCount());
  EXPECT_EQ(heap_allocations - before, 0);
}

TEST(RadioTest, ColoursTravelAsThreeBytes) {
  Bluetooth::Payload payload{9, 9, 9, 9, 9};
  putColor(payload, 1, {200, 0, 17});
  EXPECT_EQ(payload, (Bluetooth::Payload{9, 200, 0, 17, 9}));
  EXPECT_EQ(colorAt(payload, 1), (Color{200, 0, 17}));
}

}  // namespace
}  // namespace swarmanoid::test
