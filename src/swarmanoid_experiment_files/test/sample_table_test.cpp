// Tables of recorded readings: interpolation between entries, and messages about mistakes in files.
#include "swarmanoid_experiment_files/samples/sample_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kDegree = M_PI / 180.0;
const SampleTable::Readings shares{{0.0, 1.0}, false};
const SampleTable::Readings ways{{0.0, 20.0}, true};

const std::string heading = "distance,angle,reading\n";

SampleTable tableOf(const std::string& lines, const SampleTable::Readings& readings = shares) {
  return {heading + lines, "t.csv", readings};
}

TEST(SampleTableTest, IsBilinearBetweenEntries) {
  const SampleTable table = tableOf("0.02,10,0.9\n0.02,35,0.5\n0.09,10,0.3\n0.09,35,0.2\n");
  EXPECT_EQ(table.reading(0.02, 10 * kDegree, 0.0), 0.9);
  EXPECT_EQ(table.reading(0.09, 35 * kDegree, 0.0), 0.2);
  // a third of the way in angle: 0.9 - 0.4 * 0.36 = 0.756 and 0.3 - 0.1 * 0.36 = 0.264; 2/7 of the way in distance
  EXPECT_NEAR(table.reading(0.04, 19 * kDegree, 0.0), 0.756 - 0.492 * 2.0 / 7.0, 1e-12);
  EXPECT_EQ(table.farthest(), 0.09);
}

TEST(SampleTableTest, BeyondItsEdgesTheNextEntryHolds) {
  const SampleTable table = tableOf("0.02,10,0.9\n0.02,35,0.5\n0.09,10,0.3\n0.09,35,0.2\n");
  EXPECT_EQ(table.reading(0.0, 0.0, 0.0), 0.9);
  EXPECT_EQ(table.reading(0.5, 80 * kDegree, 0.0), 0.2);
  EXPECT_NEAR(table.reading(0.02, 22.5 * kDegree, 0.0), 0.7, 1e-12);
  const SampleTable one = tableOf("0.5,0,0.25\n");
  EXPECT_EQ(one.reading(0.1, 1.0, 0.99), 0.25);
}

TEST(SampleTableTest, LinesHaveAnyOrderBlanksAndRemarks) {
  const SampleTable table(
      "# of a wall\r\n\r\ndistance,angle,reading\r\n 0.09, 0 ,0.2\n\n# later\n0.02,0,\t0.8 \n0.09,0,0.1", "t.csv",
      shares);
  EXPECT_EQ(table.reading(0.02, 0.0, 0.5), 0.8);
  EXPECT_EQ(table.reading(0.09, 0.0, 0.49), 0.1);
  EXPECT_EQ(table.reading(0.09, 0.0, 0.51), 0.2);
  EXPECT_TRUE(table.isRandom());
  EXPECT_FALSE(tableOf("0.02,10,0.9\n").isRandom());
}

TEST(SampleTableTest, TheRankChoosesAmongTheSamplesOfAnEntry) {
  const SampleTable table = tableOf("0,0,0.5\n0,0,0.1\n0,0,0.3\n1,0,0.8\n1,0,0.9\n");
  for (const auto& [rank, reading] : {std::pair(0.0, 0.1), std::pair(0.33, 0.1), std::pair(0.34, 0.3),
                                      std::pair(0.67, 0.5), std::pair(0.999999, 0.5)}) {
    EXPECT_EQ(table.reading(0.0, 0.0, rank), reading) << rank;
  }
  EXPECT_NEAR(table.reading(0.25, 0.0, 0.2), 0.75 * 0.1 + 0.25 * 0.8, 1e-12) << "low with low";
  EXPECT_NEAR(table.reading(0.25, 0.0, 0.8), 0.75 * 0.5 + 0.25 * 0.9, 1e-12) << "high with high";
}

TEST(SampleTableTest, InfiniteReadingsAreNotMixedWithOthers) {
  const SampleTable table = tableOf("0.1,0,-inf\n0.2,0,0.21\n0.3,0,0.33\n0.4,0,inf\n", ways);
  EXPECT_EQ(table.reading(0.149, 0.0, 0.0), -kInfinity);
  EXPECT_EQ(table.reading(0.151, 0.0, 0.0), 0.21);
  EXPECT_NEAR(table.reading(0.225, 0.0, 0.0), 0.24, 1e-12);
  EXPECT_EQ(table.reading(0.349, 0.0, 0.0), 0.33);
  EXPECT_EQ(table.reading(0.351, 0.0, 0.0), kInfinity);
  EXPECT_EQ(table.finiteReadings().minimum, 0.21);
  EXPECT_EQ(table.finiteReadings().maximum, 0.33);
}

TEST(SampleTableTest, WhatIsWrittenIsReadBack) {
  const std::string text = sampleTableText({{0.1, 12.5, 1.0 / 3.0}, {0.7, 12.5, kInfinity}}, "of a test");
  EXPECT_EQ(text, "# of a test\ndistance,angle,reading\n0.1,12.5,0.3333333333333333\n0.7,12.5,inf\n");
  const SampleTable table(text, "t.csv", ways);
  EXPECT_EQ(table.reading(0.1, 0.0, 0.0), 1.0 / 3.0);
  EXPECT_EQ(table.reading(0.7, 0.0, 0.0), kInfinity);
}

std::string refusalOf(const std::string& text, const SampleTable::Readings& readings = shares) {
  try {
    SampleTable(text, "t.csv", readings);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(SampleTableTest, DamagedTablesAreRefusedWithFileAndLine) {
  EXPECT_EQ(refusalOf(""),
            "t.csv: found no sample, allowed: the heading distance,angle,reading, and a line for each sample");
  EXPECT_EQ(refusalOf("# only this\n" + heading),
            "t.csv: found no sample, allowed: the heading distance,angle,reading, and a line for each sample");
  EXPECT_EQ(refusalOf("# x\n0.1,0,0.5\n"), "t.csv:2: found '0.1,0,0.5', allowed: the heading distance,angle,reading");
  EXPECT_EQ(refusalOf(heading + "0.1,0,0.5\n0.2,0\n"),
            "t.csv:3: found '0.2,0', allowed: three values, distance,angle,reading");
  EXPECT_EQ(refusalOf(heading + "0.1,0,0.5,7\n"),
            "t.csv:2: found '0.1,0,0.5,7', allowed: three values, distance,angle,reading");
  EXPECT_EQ(refusalOf(heading + "\n-0.1,0,0.5\n").rfind("t.csv:3: distance: found '-0.1'", 0), 0U);
  EXPECT_EQ(refusalOf(heading + "0.1,91,0.5\n").rfind("t.csv:2: angle: found '91'", 0), 0U);
  EXPECT_EQ(refusalOf(heading + "0.1,0,1.5\n").rfind("t.csv:2: reading: found '1.5'", 0), 0U);
  EXPECT_EQ(refusalOf(heading + "0.1,0,inf\n").rfind("t.csv:2: reading: found 'inf'", 0), 0U);
  EXPECT_EQ(refusalOf(heading + "0.1,0,nan\n", ways).rfind("t.csv:2: reading: found 'nan'", 0), 0U);
  EXPECT_EQ(refusalOf(heading + "0.1,0,x\n").rfind("t.csv:2: reading: found 'x'", 0), 0U);
  EXPECT_EQ(refusalOf(heading + "0.1,0,inf\n", ways), "t.csv: found no finite reading, allowed: at least one");
  EXPECT_EQ(
      refusalOf(heading + "0.1,0,0.5\n0.1,30,0.4\n0.2,0,0.3\n0.4,30,0.1\n0.4,0,0.1\n"),
      "t.csv:4: found no sample with the distance 0.2 and the angle 30, allowed: at least one of each distance with "
      "each angle of the table");
}

TEST(SampleTableTest, MoreThanAMillionSamplesAreRefused) {
  std::string text = heading;
  for (std::size_t i = 0; i < SampleTable::kMostSamples; ++i) {
    text += "0,0,0\n";
  }
  EXPECT_EQ(refusalOf(text + "# the next is one too many\n0,0,0\n"),
            "t.csv:1000003: found one sample more, allowed: at most 1000000 in a table");
}

TEST(SampleTableTest, WhatIsNoRegularFileIsRefused) {
  for (const std::string file : {"/nowhere/t.csv", "/dev/null", "/"}) {
    try {
      readSampleTable(file, shares);
      ADD_FAILURE() << file;
    } catch (const ConfigError& error) {
      EXPECT_EQ(error.what(), file + ": found no regular file of this name, allowed: a table of readings");
    }
  }
}

}  // namespace
}  // namespace swarmanoid::test
