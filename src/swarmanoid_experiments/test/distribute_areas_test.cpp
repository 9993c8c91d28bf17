// <distribute> in boxes, discs, rings and lines, also around an entity: positions are inside the area and uniformly
// distributed. The distributed entities are in no engine, so that no position is drawn again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

/// @param more entities before the lamps @param attributes of <distribute> @param values inside it
std::unique_ptr<Simulation> start(const std::string& more, const std::string& attributes, const std::string& values,
                                  std::uint64_t seed = 1) {
  loadBuiltInPlugins();
  const std::string xml =
      "<ahss-config><framework><clocktick>100</clocktick><maxclock>9</maxclock><random_seed>" + std::to_string(seed) +
      "</random_seed></framework><arena size=\"20,20,3\" optimization=\"2D\">" + more + "\n<distribute " + attributes +
      ">" + values + "<light id=\"lamp\"/></distribute></arena><engines><kinematics2d id=\"ground\"/></engines>" +
      "<arena_physics/></ahss-config>";
  auto simulation = std::make_unique<Simulation>(parseExperiment(xml, "areas.xml"));
  simulation->start();
  return simulation;
}

std::vector<Eigen::Vector3d> placesOf(const Simulation& simulation) {
  const Entities& entities = simulation.space().entities;
  std::vector<Eigen::Vector3d> places;
  for (Row row = entities.find("lamp_1"); row != kNoRow;
       row = entities.find("lamp_" + std::to_string(places.size() + 1))) {
    places.push_back(entities.pose[row].position);
  }
  return places;
}

std::string refusal(const std::string& attributes, const std::string& values) {
  try {
    start("<light id=\"sun\"><position>2,3,1</position><orientation>0,0,0</orientation></light>", attributes, values);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

/// Kolmogorov-Smirnov test: values that are not uniform in [0, 1] fail, and so does one seed in a thousand with uniform
/// ones.
void expectUniform(std::vector<double> values, const std::string& what) {
  std::sort(values.begin(), values.end());
  const auto count = static_cast<double>(values.size());
  double farthest = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    farthest = std::max({farthest, std::abs(values[k] - static_cast<double>(k) / count),
                         std::abs(values[k] - static_cast<double>(k + 1) / count)});
  }
  EXPECT_LT(farthest, 1.95 / std::sqrt(count)) << what;
}

constexpr const char* kDisc = "<center>6,7,0.5</center><radius>3</radius>";
constexpr const char* kRing = "<center>6,7,0.5</center><radius>3</radius><inner_radius>2</inner_radius>";

/// Up to a thousand are placed one after the other, larger groups along a curve.
TEST(DistributeAreasTest, DiscsAndRingsAreEvenlyFilled) {
  for (const int quantity : {900, 3000}) {
    for (const bool is_ring : {false, true}) {
      const std::string attributes =
          "quantity=\"" + std::to_string(quantity) + "\" area=\"" + (is_ring ? "ring" : "disc") + "\"";
      const auto places = placesOf(*start("", attributes, is_ring ? kRing : kDisc));
      ASSERT_EQ(places.size(), static_cast<std::size_t>(quantity));
      const double inner = is_ring ? 4.0 : 0.0;
      std::vector<double> areas;
      std::vector<double> angles;
      for (const Eigen::Vector3d& place : places) {
        EXPECT_EQ(place.z(), 0.5);
        areas.push_back(((place.head<2>() - Eigen::Vector2d(6.0, 7.0)).squaredNorm() - inner) / (9.0 - inner));
        EXPECT_GE(areas.back(), -1e-9);
        EXPECT_LE(areas.back(), 1.0 + 1e-9);
        angles.push_back(0.5 + std::atan2(place.y() - 7.0, place.x() - 6.0) / (2.0 * M_PI));
      }
      expectUniform(areas, attributes + ": area within");
      expectUniform(angles, attributes + ": angle");
    }
  }
}

TEST(DistributeAreasTest, LinesAreEvenlyFilled) {
  const auto places = placesOf(*start("", "quantity=\"900\" area=\"line\"", "<from>2,9,0</from><to>5,5,1</to>"));
  ASSERT_EQ(places.size(), 900U);
  std::vector<double> shares;
  for (const Eigen::Vector3d& place : places) {
    shares.push_back(place.z());
    EXPECT_NEAR(place.x(), 2.0 + 3.0 * place.z(), 1e-12);
    EXPECT_NEAR(place.y(), 9.0 - 4.0 * place.z(), 1e-12);
  }
  expectUniform(shares, "along the line");
  EXPECT_NE(places, placesOf(*start("", "quantity=\"900\" area=\"line\"", "<from>2,9,0</from><to>5,5,1</to>", 2)));
}

TEST(DistributeAreasTest, GridsStandAtEvenDistances) {
  const auto ring = placesOf(*start("", "quantity=\"7\" area=\"ring\" layout=\"grid\"", kRing));
  ASSERT_EQ(ring.size(), 7U);
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const double angle = 2.0 * M_PI * static_cast<double>(k) / 7.0;
    EXPECT_NEAR((ring[k] - Eigen::Vector3d(6.0 + 2.5 * std::cos(angle), 7.0 + 2.5 * std::sin(angle), 0.5)).norm(), 0.0,
                1e-12)
        << k;
  }
  const std::string ends = "<from>2,9,0</from><to>5,5,1</to>";
  const auto line = placesOf(*start("", "quantity=\"5\" area=\"line\" layout=\"grid\"", ends));
  ASSERT_EQ(line.size(), 5U);
  EXPECT_EQ(line[0], Eigen::Vector3d(2.0, 9.0, 0.0));
  EXPECT_NEAR((line[1] - Eigen::Vector3d(2.75, 8.0, 0.25)).norm(), 0.0, 1e-12);
  EXPECT_EQ(line[4], Eigen::Vector3d(5.0, 5.0, 1.0));
  EXPECT_EQ(placesOf(*start("", "quantity=\"1\" area=\"line\" layout=\"grid\"", ends))[0],
            Eigen::Vector3d(3.5, 7.0, 0.5));
}

/// x and y are relative to the entity's origin, z to the ground.
TEST(DistributeAreasTest, AnyAreaMayBeAroundAnEntityThatStandsBefore) {
  const std::string sun = "<light id=\"sun\"><position>12,3,2</position><orientation>0,0,0</orientation></light>";
  const std::string even = "quantity=\"4\" layout=\"grid\"";
  const auto ring = placesOf(
      *start(sun, even + " area=\"ring\"", "<around>sun</around><radius>1</radius><inner_radius>1</inner_radius>"));
  EXPECT_NEAR((ring[0] - Eigen::Vector3d(13.0, 3.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((ring[1] - Eigen::Vector3d(12.0, 4.0, 0.0)).norm(), 0.0, 1e-12);
  const auto line =
      placesOf(*start(sun, even + " area=\"line\"", "<around>sun</around><from>-1,0.5,0.2</from><to>2,0.5,0.2</to>"));
  EXPECT_NEAR((line[0] - Eigen::Vector3d(11.0, 3.5, 0.2)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((line[3] - Eigen::Vector3d(14.0, 3.5, 0.2)).norm(), 0.0, 1e-12);
  const auto box =
      placesOf(*start(sun, even, "<around>sun</around><minimum>-2,-2,0</minimum><maximum>2,2,0</maximum>"));
  EXPECT_NEAR((box[0] - Eigen::Vector3d(11.0, 2.0, 0.0)).norm(), 0.0, 1e-12);
  const std::string suns =
      "<distribute quantity=\"2\" area=\"line\" layout=\"grid\"><from>5,5,1</from><to>9,5,1</to><light "
      "id=\"sun\"/></distribute>";
  const auto disc = placesOf(
      *start(suns, "quantity=\"50\" area=\"disc\"", "<around>sun_2</around><center>1,0,0</center><radius>2</radius>"));
  ASSERT_EQ(disc.size(), 50U);
  for (const Eigen::Vector3d& place : disc) {
    EXPECT_LE((place - Eigen::Vector3d(10.0, 5.0, 0.0)).norm(), 2.0 + 1e-12);
  }
}

TEST(DistributeAreasTest, PlacesThatAreTakenAreDrawnAgain) {
  World world;
  world.entities =
      "<distribute quantity=\"12\" area=\"disc\"><center>5,5,0</center><radius>0.8</radius><footbot "
      "id=\"fb\"/></distribute>";
  world.members = "<entity id=\"fb\"/>";
  const auto simulation = world.make();
  const Entities& entities = simulation->space().entities;
  ASSERT_EQ(entities.order.size(), 12U);
  for (const Row one : entities.order) {
    EXPECT_LE((entities.pose[one].position - Eigen::Vector3d(5.0, 5.0, 0.0)).norm(), 0.8);
    for (const Row other : entities.order) {
      EXPECT_TRUE(one == other || (entities.pose[one].position - entities.pose[other].position).norm() > 0.17);
    }
  }
}

TEST(DistributeAreasTest, WhatDoesNotSuitTheAreaIsRefused) {
  const std::string disc = "quantity=\"3\" area=\"disc\"";
  EXPECT_EQ("areas.xml:2: <distribute> needs <radius>", refusal(disc, "<center>5,5,0</center>"));
  EXPECT_EQ("areas.xml:2: <distribute> needs <center>", refusal(disc, "<radius>1</radius>"));
  EXPECT_EQ("areas.xml:2: <distribute> needs <minimum>", refusal("quantity=\"3\"", "<maximum>5,5,0</maximum>"));
  EXPECT_EQ(0U, refusal(disc, std::string(kDisc) + "<minimum>1,1,0</minimum>")
                    .find("areas.xml:2: found tag 'minimum', allowed: center, radius, around, "));
  EXPECT_EQ(0U, refusal(disc, kRing).find("areas.xml:2: found tag 'inner_radius', allowed: center, radius, "));
  EXPECT_EQ("areas.xml:2: area: found the value 'square', allowed: box, disc, ring, line",
            refusal("quantity=\"3\" area=\"square\"", kDisc));
  EXPECT_EQ("areas.xml:2: layout: found 'grid' with area=\"disc\", allowed: uniform",
            refusal(disc + " layout=\"grid\"", kDisc));
  EXPECT_EQ("areas.xml:2: inner_radius: found '4', allowed: at most radius, '3'",
            refusal("quantity=\"3\" area=\"ring\"",
                    "<center>6,7,0.5</center><radius>3</radius><inner_radius>4</inner_radius>"));
  EXPECT_EQ("areas.xml:2: radius: found '0', allowed: a number from 0.0001 to 10000",
            refusal(disc, "<center>6,7,0.5</center><radius>0</radius>"));
  EXPECT_EQ(
      "areas.xml:2: around: found 'son', allowed: an entity that stands before this <distribute>; did you mean 'sun'?",
      refusal(disc, "<around>son</around><radius>1</radius>"));
  EXPECT_EQ(0U,
            refusal(disc, "<around>lamp_1</around><radius>1</radius>").find("areas.xml:2: around: found 'lamp_1', "));
}

/// Lamps may stand outside the arena, robots may not.
TEST(DistributeAreasTest, AreasOfWhatMovesAreInTheArena) {
  const auto refusalOfRobots = [](const std::string& attributes, const std::string& values) -> std::string {
    World world;
    world.entities = footbot("one", 9.5, 5.0, 0.0) + "<distribute quantity=\"3\" " + attributes + ">" + values +
                     "<footbot id=\"fb\"/></distribute>";
    world.members = member("one") + "<entity id=\"fb\"/>";
    try {
      world.make();
    } catch (const ConfigError& error) {
      return std::string(error.what()).substr(std::string(error.what()).find(": ") + 2);
    }
    return "";
  };
  const std::string inside = ", allowed: in the arena, from 0, 0, 0 to 10, 10, 2";
  EXPECT_EQ("least coordinates: found '-0.5, 4, 0'" + inside,
            refusalOfRobots("area=\"disc\"", "<center>0.5,5,0</center><radius>1</radius>"));
  EXPECT_EQ("greatest coordinates: found '11, 5, 0'" + inside,
            refusalOfRobots("area=\"line\"", "<from>2,5,0</from><to>11,4,0</to>"));
  EXPECT_EQ("place around 'one': found '11.5, 7, 0'" + inside,
            refusalOfRobots("area=\"disc\"", "<around>one</around><radius>2</radius>"));
  EXPECT_EQ("", refusalOfRobots("area=\"disc\"", "<around>one</around><radius>0.45</radius>"));
}

}  // namespace
}  // namespace swarmanoid::test
