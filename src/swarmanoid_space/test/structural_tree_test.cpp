// Who grips whom: trees whose root is what is gripped and grips nothing, without loops, that merge and split.
#include "swarmanoid_space/state/structural_tree.hpp"

#include <gtest/gtest.h>

#include <random>

namespace swarmanoid {
namespace {

using Rows = std::vector<Row>;

class StructuralTreeTest : public testing::Test {
 protected:
  StructuralTreeTest() { tree.resize(kCount); }

  static constexpr Row kCount = 8;
  StructuralTree tree;
};

TEST_F(StructuralTreeTest, AtFirstEverybodyIsAStructureOfItsOwn) {
  for (Row row = 0; row < kCount; ++row) {
    EXPECT_EQ(tree.grippedBy(row), kNoRow);
    EXPECT_EQ(tree.root(row), row);
    EXPECT_EQ(tree.members(row), Rows{row});
  }
}

TEST_F(StructuralTreeTest, TheRootIsTheGrippedObject) {
  // footbots 1 and 2 grip prey 0, footbot 3 grips footbot 1 (thesis 3.4)
  EXPECT_TRUE(tree.connect(1, 0));
  EXPECT_TRUE(tree.connect(2, 0));
  EXPECT_TRUE(tree.connect(3, 1));
  for (const Row row : {0, 1, 2, 3}) {
    EXPECT_EQ(tree.root(row), 0);
    EXPECT_EQ(tree.members(row), (Rows{0, 1, 2, 3}));  // parents before children
  }
  EXPECT_EQ(tree.grippedBy(3), 1);
  EXPECT_EQ(tree.grippersOf(0), (Rows{1, 2}));
}

TEST_F(StructuralTreeTest, AGripperHoldsOneThingAtATime) {
  ASSERT_TRUE(tree.connect(1, 0));
  EXPECT_FALSE(tree.connect(1, 2));
  EXPECT_FALSE(tree.connect(1, 0));
  EXPECT_EQ(tree.grippedBy(1), 0);
  EXPECT_EQ(tree.grippersOf(0), Rows{1});
  EXPECT_TRUE(tree.grippersOf(2).empty());
}

TEST_F(StructuralTreeTest, ALoopIsRefusedAndNothingChanges) {
  ASSERT_TRUE(tree.connect(1, 0));
  ASSERT_TRUE(tree.connect(2, 1));
  ASSERT_TRUE(tree.connect(3, 2));
  for (const Row row : {0, 1, 2, 3}) {
    EXPECT_FALSE(tree.connect(0, row)) << "gripping " << row;
  }
  EXPECT_FALSE(tree.connect(5, 5)) << "gripping itself";
  EXPECT_EQ(tree.grippedBy(0), kNoRow);
  EXPECT_EQ(tree.members(3), (Rows{0, 1, 2, 3}));
}

TEST_F(StructuralTreeTest, TreesMergeWhenARootGripsAndSplitWhenItLetsGo) {
  ASSERT_TRUE(tree.connect(1, 0));
  ASSERT_TRUE(tree.connect(3, 2));
  ASSERT_TRUE(tree.connect(4, 2));
  EXPECT_TRUE(tree.connect(2, 1));
  EXPECT_EQ(tree.members(4), (Rows{0, 1, 2, 3, 4}));
  EXPECT_EQ(tree.release(2), 1);
  EXPECT_EQ(tree.members(0), (Rows{0, 1}));
  EXPECT_EQ(tree.members(3), (Rows{2, 3, 4}));
  EXPECT_EQ(tree.release(2), kNoRow) << "nothing was gripped any more";
}

TEST_F(StructuralTreeTest, WhatIsIsolatedIsAloneAndTheRestStaysTogether) {
  ASSERT_TRUE(tree.connect(1, 0));
  ASSERT_TRUE(tree.connect(2, 1));
  ASSERT_TRUE(tree.connect(3, 1));
  ASSERT_TRUE(tree.connect(4, 3));
  tree.isolate(1);
  EXPECT_EQ(tree.members(0), Rows{0});
  EXPECT_EQ(tree.members(1), Rows{1});
  EXPECT_EQ(tree.members(2), Rows{2});
  EXPECT_EQ(tree.members(4), (Rows{3, 4}));
}

TEST_F(StructuralTreeTest, GrowsWithoutForgettingAndForgetsWhenCleared) {
  ASSERT_TRUE(tree.connect(1, 0));
  tree.resize(100);
  EXPECT_EQ(tree.root(1), 0);
  EXPECT_EQ(tree.root(99), 99);
  tree.resize(2);
  EXPECT_TRUE(tree.connect(99, 1)) << "never shrinks";
  tree.clear();
  tree.resize(2);
  EXPECT_EQ(tree.grippedBy(1), kNoRow);
  EXPECT_TRUE(tree.grippersOf(0).empty());
}

TEST_F(StructuralTreeTest, StaysAForestThroughAnyGripsAndReleases) {
  std::mt19937 random(7);
  constexpr Row kMany = 40;
  tree.resize(kMany);
  Rows parent(kMany, kNoRow);  // what the test itself remembers
  const auto rootOf = [&](Row row) {
    int steps = 0;
    while (parent[static_cast<std::size_t>(row)] != kNoRow && steps++ < kMany) {
      row = parent[static_cast<std::size_t>(row)];
    }
    return row;
  };
  int refused = 0;
  for (int i = 0; i < 20000; ++i) {
    const Row a = static_cast<Row>(random() % kMany);
    const Row b = static_cast<Row>(random() % kMany);
    Row& parent_of_a = parent[static_cast<std::size_t>(a)];
    if (random() % 3 == 0) {
      ASSERT_EQ(tree.release(a), parent_of_a);
      parent_of_a = kNoRow;
    } else {
      const bool is_possible = parent_of_a == kNoRow && rootOf(b) != a;
      ASSERT_EQ(tree.connect(a, b), is_possible);
      refused += is_possible ? 0 : 1;
      parent_of_a = is_possible ? b : parent_of_a;
    }
    std::size_t members = 0;
    for (Row row = 0; row < kMany; ++row) {
      ASSERT_EQ(tree.grippedBy(row), parent[static_cast<std::size_t>(row)]);
      ASSERT_EQ(tree.root(row), rootOf(row));
      members += tree.root(row) == row ? tree.members(row).size() : 0;
    }
    ASSERT_EQ(members, static_cast<std::size_t>(kMany)) << "everybody is in exactly one structure";
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace swarmanoid
