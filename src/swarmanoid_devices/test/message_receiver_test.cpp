// Behaviour that all message receivers share: delays, order, slots, losses and errors of messages, and the effect of
// robots that are added, removed and stopped. The receivers are range-and-bearing boards.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "message_world.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

namespace swarmanoid::test {
namespace {

/// The first byte of each message.
std::vector<int> firstBytes(const Board& board) {
  std::vector<int> bytes;
  for (const RangeAndBearingMessage& message : board.messages()) {
    bytes.push_back(message.payload[0]);
  }
  return bytes;
}

/// A robot in the centre, and others in several directions at these distances, which send 1, 2, ...
struct Circle {
  Circle(const std::vector<double>& distances, const Parameters& parameters, std::uint64_t seed = 1)
      : world(parameters, {}, seed) {
    middle = world.footbot(5.0, 5.0, 0.4);
    for (std::size_t i = 0; i < distances.size(); ++i) {
      const double angle = 0.3 + 1.1 * static_cast<double>(i);  // far enough apart to avoid occlusion
      around.push_back(world.footbot(5.0 + distances[i] * std::cos(angle), 5.0 + distances[i] * std::sin(angle)));
      around.back().command->send({static_cast<std::uint8_t>(i + 1)});
    }
  }

  MessageWorld world;
  Board middle;
  std::vector<Board> around;
};

TEST(MessageReceiverTest, NobodyHearsItselfOrWhoIsSilent) {
  MessageWorld world;
  const Board a = world.footbot(5.0, 5.0);
  const Board b = world.footbot(6.0, 5.0);
  world.exchange();
  EXPECT_TRUE(a.messages().empty()) << "silent at rest";
  a.command->send({7});
  world.exchange();
  EXPECT_TRUE(a.messages().empty());
  EXPECT_EQ(firstBytes(b), std::vector<int>{7});
  world.addFootbot(5.5, 6.0);  // without a board
  world.exchange();
  EXPECT_EQ(firstBytes(b), std::vector<int>{7}) << "said again in each tick";
}

TEST(MessageReceiverTest, AMessageThatIsSentOnceIsHeardInOneTick) {
  MessageWorld world;
  const Board a = world.footbot(5.0, 5.0);
  const Board b = world.footbot(6.0, 5.0);
  world.sense(*world.receiver);
  a.command->send({7});
  world.sense(*world.receiver);
  EXPECT_TRUE(b.messages().empty()) << "not yet carried out";
  world.exchange();
  EXPECT_EQ(firstBytes(b), std::vector<int>{7});
  a.command->fallSilent();
  world.exchange();
  EXPECT_TRUE(b.messages().empty());
}

TEST(MessageReceiverTest, ASafeStopIsSilence) {
  MessageWorld world;
  const Board a = world.footbot(5.0, 5.0);
  const Board b = world.footbot(6.0, 5.0);
  a.command->send({7});
  world.exchange();
  EXPECT_EQ(b.messages().size(), 1U);
  const Robot robot("a", "footbot", 1);
  EXPECT_TRUE(world.sender->stop(world.space, ActuateAccess(world.space), a.row, {0.0, {}, robot})) << "at once";
  ++world.space.tick;
  world.sense(*world.receiver);
  EXPECT_TRUE(b.messages().empty());
  EXPECT_FALSE(a.command->sends);
  EXPECT_EQ(a.command->payload[0], 0);
}

TEST(MessageReceiverTest, WhoIsGoneIsNotHeardAndWhoTakesItsRowIsSilent) {
  MessageWorld world;
  const Board a = world.footbot(5.0, 5.0);
  const Board b = world.footbot(6.0, 5.0);
  a.command->send({7});
  world.exchange();
  EXPECT_EQ(b.messages().size(), 1U);
  world.remove(a);
  ++world.space.tick;
  world.sense(*world.receiver);
  EXPECT_TRUE(b.messages().empty()) << "though it sent in the tick before";
  const Board c = world.footbot(5.0, 5.0);
  ASSERT_EQ(c.row, a.row);
  ++world.space.tick;
  world.sense(*world.receiver);
  EXPECT_TRUE(b.messages().empty());
  b.command->send({8});
  world.exchange();
  EXPECT_EQ(firstBytes(c), std::vector<int>{8}) << "who is new hears like the others";
}

TEST(MessageReceiverTest, MessagesComeInTheOrderOfEntityNumbers) {
  MessageWorld world;
  std::vector<Board> gone;
  for (int i = 0; i < 5; ++i) {
    gone.push_back(world.footbot(1.0 + i, 1.0));
  }
  const Board robot = world.footbot(5.0, 5.0);
  for (const int i : {3, 0, 4, 1, 2}) {
    world.remove(gone[static_cast<std::size_t>(i)]);
  }
  std::vector<Board> others;
  for (int i = 0; i < 5; ++i) {
    others.push_back(world.footbot(4.0 + 0.5 * i, 6.0 - 0.1 * i));
    others.back().command->send({static_cast<std::uint8_t>(i)});
  }
  EXPECT_FALSE(others[0].row < others[1].row && others[1].row < others[2].row && others[2].row < others[3].row)
      << "rows have another order";
  world.exchange();
  EXPECT_EQ(firstBytes(robot), (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(MessageReceiverTest, OfMoreThanTheSlotsTheNearestAreReportedInTheirOrder) {
  Circle circle({1.4, 0.5, 1.9, 0.9, 0.7}, {{"slots", "3"}});
  circle.world.exchange();
  EXPECT_EQ(firstBytes(circle.middle), (std::vector<int>{2, 4, 5}));
  EXPECT_TRUE(circle.middle.received->overflowed);
  circle.around[1].command->fallSilent();
  circle.world.exchange();
  EXPECT_EQ(firstBytes(circle.middle), (std::vector<int>{1, 4, 5}));
  EXPECT_TRUE(circle.middle.received->overflowed);
  circle.around[2].command->fallSilent();
  circle.world.exchange();
  EXPECT_EQ(firstBytes(circle.middle), (std::vector<int>{1, 4, 5})) << "just as many as there are slots";
  EXPECT_FALSE(circle.middle.received->overflowed);
}

TEST(MessageReceiverTest, OfEquallyNearSendersTheOneOfTheLowerNumberIsReported) {
  MessageWorld world(Parameters{{"slots", "2"}});
  const Board robot = world.footbot(5.0, 5.0);
  const double places[][2] = {{6.0, 5.0}, {5.0, 6.0}, {4.5, 5.0}, {5.0, 4.0}};  // exactly 1, 1, 0.5 and 1 m away
  std::uint8_t byte = 0;
  for (const auto& place : places) {
    world.footbot(place[0], place[1]).command->send({++byte});
  }
  world.exchange();
  EXPECT_EQ(firstBytes(robot), (std::vector<int>{1, 3}));
}

TEST(MessageReceiverTest, AnyNumberOfSendersIsHeardByTheDefinition) {
  for (const int quantity : {1, 3, 4, 5, 63, 64, 65, 66, 130}) {
    MessageWorld world(Parameters{{"line_of_sight", "false"}});
    RandomStream random(3, "crowd", "places");
    std::vector<Board> others;
    for (int i = 0; i < quantity; ++i) {
      others.push_back(world.footbot(random.uniform(3.2, 6.8), random.uniform(3.2, 6.8)));
      others.back().command->send({static_cast<std::uint8_t>(i)});
    }
    const Board robot = world.footbot(5.0, 5.0);
    const auto distanceTo = [&](int i) {
      return (world.pose(others[static_cast<std::size_t>(i)].row).position - world.pose(robot.row).position).norm();
    };
    std::vector<int> expected;  // the nearest ones, as many as there are slots, by number
    for (int i = 0; i < quantity; ++i) {
      expected.push_back(i);
    }
    std::sort(expected.begin(), expected.end(), [&](int a, int b) { return distanceTo(a) < distanceTo(b); });
    expected.resize(std::min<std::size_t>(expected.size(), RangeAndBearingReceived::kMostMessages));
    std::sort(expected.begin(), expected.end());
    world.exchange();
    EXPECT_EQ(firstBytes(robot), expected) << quantity;
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_EQ(robot.messages()[k].range, static_cast<float>(distanceTo(expected[k])));
    }
    EXPECT_EQ(robot.received->overflowed, quantity > 64);
  }
}

TEST(MessageReceiverTest, AnOverflowIsOneEventAndIsCounted) {
  Circle circle({1.4, 0.5, 1.9}, {{"slots", "2"}});
  for (int i = 0; i < 4; ++i) {
    circle.world.exchange();
  }
  ASSERT_EQ(circle.world.space.events.size(), 1U);
  const Event& event = circle.world.space.events[0];
  EXPECT_EQ(event.kind, Event::Kind::kOverflow);
  EXPECT_EQ(event.entity, circle.world.space.entities.name[circle.middle.row]);
  EXPECT_EQ(event.text, "range_and_bearing_received: more than 2 messages");
  ASSERT_EQ(circle.world.space.overflows.size(), 1U);
  EXPECT_EQ(circle.world.space.overflows[0].readings, 4U);
  EXPECT_EQ(circle.world.space.overflows[0].first_tick, 1U);
}

TEST(MessageReceiverTest, MessagesAreLostByChance) {
  constexpr double kLoss = 0.3;
  Circle circle({1.4, 0.5, 1.9, 0.9, 0.7}, {{"loss", "0.3"}});
  circle.middle.command->send({9});
  // five messages a tick for 20,000 ticks make 100,000 draws
  constexpr int kTicks = 20000;
  int heard = 0;
  int pairs = 0;  // of the first two
  std::vector<int> of_sender(6, 0);
  for (int i = 0; i < kTicks; ++i) {
    circle.world.exchange();
    const std::vector<int> bytes = firstBytes(circle.middle);
    heard += static_cast<int>(bytes.size());
    for (const int byte : bytes) {
      ++of_sender[static_cast<std::size_t>(byte)];
    }
    pairs += bytes.size() >= 2 && bytes[0] == 1 && bytes[1] == 2 ? 1 : 0;
  }
  const auto expectShare = [](int count, int draws, double probability) {
    const double deviation = std::sqrt(draws * probability * (1.0 - probability));
    EXPECT_NEAR(count, draws * probability, 4.0 * deviation);
  };
  expectShare(heard, 5 * kTicks, 1.0 - kLoss);
  for (std::size_t i = 1; i < of_sender.size(); ++i) {
    expectShare(of_sender[i], kTicks, 1.0 - kLoss);
  }
  expectShare(pairs, kTicks, (1.0 - kLoss) * (1.0 - kLoss));
}

TEST(MessageReceiverTest, LossesBelongToSeedReceiverAndTick) {
  const std::vector<double> distances{1.4, 0.5, 1.9, 0.9, 0.7};
  const auto heardIn = [&](Circle& circle) {
    std::vector<std::vector<int>> heard;
    for (int i = 0; i < 50; ++i) {
      circle.world.exchange();
      heard.push_back(firstBytes(circle.middle));
      circle.world.sense(*circle.world.receiver);
      EXPECT_EQ(firstBytes(circle.middle), heard.back()) << "a tick that is made again";
    }
    return heard;
  };
  Circle first(distances, {{"loss", "0.5"}});
  Circle second(distances, {{"loss", "0.5"}});
  Circle other(distances, {{"loss", "0.5"}}, 2);
  const auto expected = heardIn(first);
  EXPECT_EQ(heardIn(second), expected);
  EXPECT_NE(heardIn(other), expected);
  Circle all(distances, {{"loss", "1"}});
  all.world.exchange();
  EXPECT_TRUE(all.middle.messages().empty());
}

TEST(MessageReceiverTest, WhatIsLostTakesNoSlot) {
  Circle circle({0.5, 0.7, 0.9}, {{"loss", "0.5"}, {"slots", "1"}});
  bool is_farthest_heard = false;
  for (int i = 0; i < 100; ++i) {
    circle.world.exchange();
    is_farthest_heard = is_farthest_heard || firstBytes(circle.middle) == std::vector<int>{3};
  }
  EXPECT_TRUE(is_farthest_heard) << "when the two nearer ones are lost";
}

ErrorModelDescription errorOn(const std::string& kind, const std::string& field, const std::string& parameter,
                              const std::string& value) {
  ErrorModelDescription error;
  error.kind = kind;
  error.field = field;
  error.parameters = Configuration("error", "", {});
  error.parameters.set(parameter, value);
  return error;
}

TEST(MessageReceiverTest, ErrorsActOnWhatIsMeasuredAndOnBytes) {
  MessageWorld world({}, {errorOn("gaussian", "messages[].range", "deviation", "0.1"),
                          errorOn("bias", "messages[].payload", "offset", "3")});
  const Board robot = world.footbot(5.0, 5.0);
  const Board other = world.footbot(5.6, 5.8, 1.0);
  other.command->send({10, 254});
  std::vector<double> ranges;
  for (int i = 0; i < 4000; ++i) {
    world.exchange();
    ASSERT_EQ(robot.messages().size(), 1U);
    ranges.push_back(robot.messages()[0].range);
    ASSERT_NEAR(robot.messages()[0].bearing, std::atan2(0.8, 0.6), 1e-6);
    ASSERT_EQ(robot.messages()[0].payload[0], 13);
    ASSERT_EQ(robot.messages()[0].payload[1], 255) << "the most that a byte holds";
    ASSERT_EQ(robot.messages()[0].payload[9], 3);
  }
  const Statistics statistics(ranges);
  EXPECT_NEAR(statistics.mean, 1.0, 4.0 * 0.1 / std::sqrt(4000.0));
  EXPECT_NEAR(statistics.deviation, 0.1, 4.0 * 0.1 / std::sqrt(2.0 * 4000.0));
}

TEST(MessageReceiverTest, NoiseOfBearingsGoesAroundAndThatOfRangesStaysOverZero) {
  MessageWorld world({}, {errorOn("gaussian", "messages[].range", "deviation", "0.2"),
                          errorOn("gaussian", "messages[].bearing", "deviation", "0.3")});
  const Board robot = world.footbot(5.0, 5.0, 0.2);
  const Board other = world.footbot(5.0 - 0.3 * std::cos(0.1), 5.0 - 0.3 * std::sin(0.1));  // bearing pi - 0.1
  other.command->send({1});
  std::vector<double> turns;
  int behind_left = 0;
  int at_zero = 0;
  constexpr int kTicks = 4000;
  for (int i = 0; i < kTicks; ++i) {
    world.exchange();
    ASSERT_EQ(robot.messages().size(), 1U);
    const RangeAndBearingMessage& message = robot.messages()[0];
    ASSERT_GE(message.range, 0.0F);
    ASSERT_LE(std::abs(message.bearing), static_cast<float>(M_PI));
    ASSERT_NEAR(message.elevation, 0.0, 1e-6) << "has no error";
    const double turn = message.bearing - (M_PI - 0.1);
    turns.push_back(turn < -M_PI ? turn + 2.0 * M_PI : turn);
    behind_left += message.bearing > 0.0F ? 1 : 0;
    at_zero += message.range == 0.0F ? 1 : 0;
  }
  const Statistics statistics(turns);
  EXPECT_NEAR(statistics.mean, 0.0, 4.0 * 0.3 / std::sqrt(kTicks));
  EXPECT_NEAR(statistics.deviation, 0.3, 4.0 * 0.3 / std::sqrt(2.0 * kTicks));
  // 0.1 of 0.3 to the limit: 63.06 % are before it; a range of 0.3 m falls below 0 in 6.68 %
  EXPECT_NEAR(behind_left, 0.6306 * kTicks, 4.0 * std::sqrt(0.6306 * 0.3694 * kTicks));
  EXPECT_NEAR(at_zero, 0.0668 * kTicks, 4.0 * std::sqrt(0.0668 * 0.9332 * kTicks));
}

TEST(MessageReceiverTest, DistanceLosesMessagesOfBoardsTooIfTheExperimentSaysSo) {
  Circle circle({1.5, 0.6}, {{"loss_at_range", "0.8"}, {"loss_exponent", "1"}});
  constexpr int kTicks = 8000;
  std::vector<int> of_sender(3, 0);
  for (int i = 0; i < kTicks; ++i) {
    circle.world.exchange();
    for (const int byte : firstBytes(circle.middle)) {
      ++of_sender[static_cast<std::size_t>(byte)];
    }
  }
  // with a range of 3 m
  EXPECT_NEAR(of_sender[1], 0.6 * kTicks, 4.0 * std::sqrt(0.6 * 0.4 * kTicks));
  EXPECT_NEAR(of_sender[2], 0.84 * kTicks, 4.0 * std::sqrt(0.84 * 0.16 * kTicks));
}

TEST(MessageReceiverTest, SensingAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  Circle circle({1.4, 0.5, 1.9, 0.9, 0.7}, {{"loss", "0.2"}, {"slots", "2"}});
  circle.middle.command->send({9});
  circle.world.addWall({0.05, 2.0, 0.5}, {5.8, 5.0});
  circle.world.exchange();
  circle.world.exchange();
  const long before = heap_allocations;
  circle.world.receiver->prepare(circle.world.space);
  circle.world.receiver->sense(circle.world.space, 0, circle.world.receiver->instanceCount());
  EXPECT_EQ(heap_allocations - before, 0);
}

}  // namespace
}  // namespace swarmanoid::test
