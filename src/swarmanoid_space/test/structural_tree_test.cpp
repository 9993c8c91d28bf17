// Trees of grips: the root is gripped and grips nothing; trees have no loops, merge and split.
#include "swarmanoid_space/state/structural_tree.hpp"

#include <gtest/gtest.h>

#include <random>

namespace swarmanoid {
namespace {

using Rows = std::vector<Row>;

constexpr Row operator""_r(unsigned long long index) { return rowAt(index); }

class StructuralTreeTest : public testing::Test {
 protected:
  StructuralTreeTest() { columns.resize(kCount); }

  static constexpr std::size_t kCount = 8;
  Columns columns;
  StructuralTree tree{columns};
};

TEST_F(StructuralTreeTest, AtFirstEverybodyIsAStructureOfItsOwn) {
  for (std::size_t i = 0; i < kCount; ++i) {
    const Row row = rowAt(i);
    EXPECT_EQ(tree.grippedBy(row), kNoRow);
    EXPECT_EQ(tree.root(row), row);
    EXPECT_EQ(tree.members(row), Rows{row});
  }
}

TEST_F(StructuralTreeTest, TheRootIsTheGrippedObject) {
  // footbots 1 and 2 grip prey 0, footbot 3 grips footbot 1 (thesis 3.4)
  EXPECT_TRUE(tree.connect(1_r, 0_r));
  EXPECT_TRUE(tree.connect(2_r, 0_r));
  EXPECT_TRUE(tree.connect(3_r, 1_r));
  for (const Row row : {0_r, 1_r, 2_r, 3_r}) {
    EXPECT_EQ(tree.root(row), 0_r);
    EXPECT_EQ(tree.members(row), (Rows{0_r, 1_r, 2_r, 3_r}));  // parents before children
  }
  EXPECT_EQ(tree.grippedBy(3_r), 1_r);
  EXPECT_EQ(tree.grippersOf(0_r), (Rows{1_r, 2_r}));
}

TEST_F(StructuralTreeTest, AGripperHoldsOneThingAtATime) {
  ASSERT_TRUE(tree.connect(1_r, 0_r));
  EXPECT_FALSE(tree.connect(1_r, 2_r));
  EXPECT_FALSE(tree.connect(1_r, 0_r));
  EXPECT_EQ(tree.grippedBy(1_r), 0_r);
  EXPECT_EQ(tree.grippersOf(0_r), Rows{1_r});
  EXPECT_TRUE(tree.grippersOf(2_r).empty());
}

TEST_F(StructuralTreeTest, ALoopIsRefusedAndNothingChanges) {
  ASSERT_TRUE(tree.connect(1_r, 0_r));
  ASSERT_TRUE(tree.connect(2_r, 1_r));
  ASSERT_TRUE(tree.connect(3_r, 2_r));
  for (const Row row : {0_r, 1_r, 2_r, 3_r}) {
    EXPECT_FALSE(tree.connect(0_r, row)) << "gripping " << toIndex(row);
  }
  EXPECT_FALSE(tree.connect(5_r, 5_r)) << "gripping itself";
  EXPECT_EQ(tree.grippedBy(0_r), kNoRow);
  EXPECT_EQ(tree.members(3_r), (Rows{0_r, 1_r, 2_r, 3_r}));
}

TEST_F(StructuralTreeTest, TreesMergeWhenARootGripsAndSplitWhenItLetsGo) {
  ASSERT_TRUE(tree.connect(1_r, 0_r));
  ASSERT_TRUE(tree.connect(3_r, 2_r));
  ASSERT_TRUE(tree.connect(4_r, 2_r));
  EXPECT_TRUE(tree.connect(2_r, 1_r));
  EXPECT_EQ(tree.members(4_r), (Rows{0_r, 1_r, 2_r, 3_r, 4_r}));
  EXPECT_EQ(tree.release(2_r), 1_r);
  EXPECT_EQ(tree.members(0_r), (Rows{0_r, 1_r}));
  EXPECT_EQ(tree.members(3_r), (Rows{2_r, 3_r, 4_r}));
  EXPECT_EQ(tree.release(2_r), kNoRow) << "nothing was gripped any more";
}

TEST_F(StructuralTreeTest, WhatIsIsolatedIsAloneAndTheRestStaysTogether) {
  ASSERT_TRUE(tree.connect(1_r, 0_r));
  ASSERT_TRUE(tree.connect(2_r, 1_r));
  ASSERT_TRUE(tree.connect(3_r, 1_r));
  ASSERT_TRUE(tree.connect(4_r, 3_r));
  tree.isolate(1_r);
  EXPECT_EQ(tree.members(0_r), Rows{0_r});
  EXPECT_EQ(tree.members(1_r), Rows{1_r});
  EXPECT_EQ(tree.members(2_r), Rows{2_r});
  EXPECT_EQ(tree.members(4_r), (Rows{3_r, 4_r}));
}

TEST_F(StructuralTreeTest, GrowsWithoutForgettingAndForgetsWhenCleared) {
  ASSERT_TRUE(tree.connect(1_r, 0_r));
  columns.resize(100);
  EXPECT_EQ(tree.root(1_r), 0_r);
  EXPECT_EQ(tree.root(99_r), 99_r);
  columns.resize(0);
  columns.resize(2);
  EXPECT_EQ(tree.grippedBy(1_r), kNoRow);
  EXPECT_TRUE(tree.grippersOf(0_r).empty());
}

TEST_F(StructuralTreeTest, StaysAForestThroughAnyGripsAndReleases) {
  std::mt19937 random(7);
  constexpr std::size_t kMany = 40;
  columns.resize(kMany);
  Rows parent(kMany, kNoRow);  // reference kept by the test
  const auto rootOf = [&](Row row) {
    std::size_t steps = 0;
    while (parent[toIndex(row)] != kNoRow && steps++ < kMany) {
      row = parent[toIndex(row)];
    }
    return row;
  };
  int refused = 0;
  for (int i = 0; i < 20000; ++i) {
    const Row a = rowAt(random() % kMany);
    const Row b = rowAt(random() % kMany);
    Row& parent_of_a = parent[toIndex(a)];
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
    for (std::size_t k = 0; k < kMany; ++k) {
      const Row row = rowAt(k);
      ASSERT_EQ(tree.grippedBy(row), parent[toIndex(row)]);
      ASSERT_EQ(tree.root(row), rootOf(row));
      members += tree.root(row) == row ? tree.members(row).size() : 0;
    }
    ASSERT_EQ(members, kMany) << "everybody is in exactly one structure";
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace swarmanoid
