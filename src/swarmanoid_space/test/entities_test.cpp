// Entities and their data: numbers that are never reused, rows that are, stable addresses.
#include "swarmanoid_space/state/entities.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_space/state/bank.hpp"

namespace swarmanoid {
namespace {

Row add(Entities& entities, const std::string& name) { return entities.add(name, lightModel(), {}, colors::kRed); }

TEST(PoseTest, PointsOfABodyAreTurnedAndThenMoved) {
  // a third of a turn about (1, 1, 1): x goes to y, y to z, z to x
  const Pose pose{{10.0, 20.0, 30.0}, Eigen::Quaterniond(0.5, 0.5, 0.5, 0.5)};
  EXPECT_EQ(pose.toWorld({1.0, 2.0, 3.0}), Eigen::Vector3d(13.0, 21.0, 32.0));
  EXPECT_EQ(pose.toWorld(Eigen::Vector3d::Zero()), pose.position);
}

/// A screw about (0, 0.6, 0.8), turned by 0.85 rad: 0.4 m/s along the axis, and 0.5 m/s around it, at 0.5 / 1.7 m.
TEST(TwistTest, MeanVelocityLeadsToTheEndOfTheArc) {
  const Eigen::Vector3d axis(0.0, 0.6, 0.8);
  const Eigen::Vector3d across(1.0, 0.0, 0.0);
  const Eigen::Vector3d aside = axis.cross(across);
  const Twist begin{0.4 * axis + 0.5 * across, 1.7 * axis};
  constexpr double kTime = 0.5;  // s
  const double turn = 1.7 * kTime;
  const Eigen::Vector3d way =
      0.4 * kTime * axis + 0.5 / 1.7 * (std::sin(turn) * across + (1.0 - std::cos(turn)) * aside);
  EXPECT_LT((meanVelocity(begin, kTime) * kTime - way).norm(), 1e-12);
  const Twist end{0.4 * axis + 0.5 * (std::cos(turn) * across + std::sin(turn) * aside), 1.7 * axis};
  EXPECT_LT((meanVelocity(end, -kTime) * kTime - way).norm(), 1e-12) << "backwards";
  EXPECT_EQ(meanVelocity({across, Eigen::Vector3d::Zero()}, kTime), across) << "straight on";
}

TEST(EntitiesTest, NumbersBeginAtOneAndAreNeverUsedAgain) {
  Entities entities;
  std::set<EntityNumber> numbers;
  std::mt19937 random(3);
  for (int i = 0; i < 5000; ++i) {
    const Row row = add(entities, "e" + std::to_string(i));
    EXPECT_TRUE(numbers.insert(entities.number[row]).second);
    if (random() % 4 != 0) {
      entities.remove(entities.order[random() % entities.size()]);
    }
  }
  EXPECT_EQ(*numbers.begin(), EntityNumber{1});
  EXPECT_EQ(*numbers.rbegin(), EntityNumber{5000});
  EXPECT_LT(entities.rowCount(), 2000U) << "rows are used again";
}

TEST(EntitiesTest, ANumberOfTheDeadFindsNobodyEvenWhenItsRowLivesAgain) {
  Entities entities;
  add(entities, "a");
  const Row b = add(entities, "b");
  const EntityNumber number_of_b = entities.number[b];
  add(entities, "c");
  entities.remove(b);
  EXPECT_EQ(entities.find("b"), kNoRow);
  EXPECT_EQ(entities.find(number_of_b), kNoRow);
  EXPECT_FALSE(entities.isAlive(b));
  const Row again = add(entities, "b");
  EXPECT_EQ(again, b);
  EXPECT_EQ(entities.find(number_of_b), kNoRow);
  EXPECT_EQ(entities.find("b"), again);
  EXPECT_EQ(entities.find(entities.number[again]), again);
  EXPECT_EQ(entities.find(kNoEntity), kNoRow);
  EXPECT_EQ(entities.find(EntityNumber{1000}), kNoRow);
}

TEST(EntitiesTest, OrderIsByNumberWhateverHappened) {
  Entities entities;
  std::mt19937 random(5);
  for (int i = 0; i < 2000; ++i) {
    const Row row = add(entities, "e" + std::to_string(i));
    EXPECT_EQ(entities.order.back(), row);
    if (random() % 2 == 0) {
      entities.remove(entities.order[random() % entities.size()]);
    }
    EntityNumber previous = kNoEntity;
    std::set<Row> rows;
    for (const Row each : entities.order) {
      const EntityNumber number = entities.number[each];
      ASSERT_GT(number, previous);
      ASSERT_TRUE(rows.insert(each).second);
      previous = number;
    }
  }
}

TEST(EntitiesTest, ARowThatLivesAgainRemembersNothing) {
  Entities entities;
  const Row row = add(entities, "old");
  entities.twist[row].linear.x() = 1.0;
  entities.remove(row);
  EXPECT_EQ(entities.model[row], nullptr) << "a model that nobody uses is let go";
  const Pose pose{{1.0, 2.0, 3.0}, Eigen::Quaterniond::Identity()};
  ASSERT_EQ(entities.add("new", cylindricPreyModel(0.1, 0.2), pose, colors::kBlue), row);
  EXPECT_EQ(entities.twist[row].linear, Eigen::Vector3d::Zero());
  EXPECT_EQ(entities.pose[row].position, pose.position);
  EXPECT_EQ(entities.color[row], colors::kBlue);
  EXPECT_EQ(entities.model[row]->type, "cylindric_prey");
}

TEST(EntitiesTest, ClearingForgetsNumbersToo) {
  Entities entities;
  add(entities, "a");
  entities.clear();
  EXPECT_EQ(entities.size(), 0U);
  EXPECT_EQ(entities.rowCount(), 0U);
  EXPECT_EQ(entities.number[add(entities, "a")], EntityNumber{1});
}

TEST(BankTest, AddressesStayWhileOthersComeAndGo) {
  Bank<FootbotWheels> bank;
  std::vector<FootbotWheels*> slots;
  for (int i = 0; i < 3000; ++i) {
    slots.push_back(&bank.add(Row{i}));
    slots.back()->left = i;
  }
  EXPECT_EQ(std::set<FootbotWheels*>(slots.begin(), slots.end()).size(), slots.size());
  for (int i = 0; i < 3000; i += 2) {
    bank.remove(Row{i});
  }
  for (int i = 3000; i < 5000; ++i) {
    EXPECT_EQ(bank.add(Row{i}).left, 0.0) << "a slot that is used again has the initial value";
  }
  for (int i = 1; i < 3000; i += 2) {
    ASSERT_EQ(bank.find(Row{i}), slots[static_cast<std::size_t>(i)]);
    ASSERT_EQ(bank.find(Row{i})->left, i);
  }
  EXPECT_EQ(bank.find(Row{0}), nullptr);
  EXPECT_EQ(bank.find(Row{1000000}), nullptr);
}

TEST(BankTest, BanksAreFoundByTheNameOfTheDevice) {
  Banks banks;
  EXPECT_EQ(banks.find<FootbotWheels>(Row{0}), nullptr);
  FootbotWheels& wheels = banks.bank<FootbotWheels>().add(Row{0});
  EXPECT_EQ(banks.find<FootbotWheels>(Row{0}), &wheels);
  EXPECT_EQ(banks.find("footbot_wheels", Row{0}), &wheels);
  EXPECT_EQ(banks.find("footbot_leds", Row{0}), nullptr);
}

}  // namespace
}  // namespace swarmanoid
