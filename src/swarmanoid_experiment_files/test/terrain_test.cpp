// Heights from images, and hits of rays.
#include "swarmanoid_space/rays/terrain.hpp"
#include "../src/images/read_terrain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "swarmanoid_experiment_files/testing/write_png.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kNever = std::numeric_limits<double>::infinity();

std::string folder() {
  static const TemporaryFolder owner("terrain_test");
  return owner.path();
}

std::string fileNamed(const std::string& name) { return folder() + "/" + name + ".png"; }

/// 0.1 m per pixel along x, 0.2 m along y, from a corner at (1, 2).
Terrain made(int columns, int rows, double (*height)(double x, double y)) {
  const Vector2d low(1.0, 2.0);
  std::vector<double> heights;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      heights.push_back(height(low.x() + 0.1 * i, low.y() + 0.2 * j));
    }
  }
  return {low, {0.1 * (columns - 1), 0.2 * (rows - 1)}, columns, rows, heights};
}

double plane(double x, double y) { return 0.3 * x - 0.2 * y + 1.0; }
double bump(double x, double y) { return 0.5 * std::exp(-8.0 * (std::pow(x - 2.0, 2) + std::pow(y - 4.0, 2))) - 0.1; }

TEST(TerrainTest, AnImageLiesWithItsColumnsAlongXAndItsTopAtTheGreatestY) {
  const std::string file = test::writePng(fileNamed("small"), 3, 8, {0, 51, 102, 153, 204, 255});
  const Terrain terrain = readTerrain(file, {5.0, 4.0, -0.5}, {2.0, 1.0}, 1.0);
  EXPECT_EQ(terrain.columns(), 3);
  EXPECT_EQ(terrain.rows(), 2);
  EXPECT_DOUBLE_EQ(terrain.heightAt(4.0, 4.5), -0.5);  // top left
  EXPECT_DOUBLE_EQ(terrain.heightAt(5.0, 4.5), -0.3);
  EXPECT_DOUBLE_EQ(terrain.heightAt(6.0, 4.5), -0.1);
  EXPECT_DOUBLE_EQ(terrain.heightAt(4.0, 3.5), 0.1);
  EXPECT_DOUBLE_EQ(terrain.heightAt(6.0, 3.5), 0.5);  // bottom right
  EXPECT_EQ(terrain.bounds().min(), Vector3d(4.0, 3.5, -0.5));
  EXPECT_EQ(terrain.bounds().max(), Vector3d(6.0, 4.5, 0.5));
  EXPECT_TRUE(terrain.contains(4.0, 3.5));
  EXPECT_FALSE(terrain.contains(3.99, 4.0));
}

TEST(TerrainTest, AnImageOfSixteenBitsHasFinerHeights) {
  const std::string file = test::writePng(fileNamed("fine"), 2, 16, {0, 1, 256, 65535});
  const Terrain terrain = readTerrain(file, {0.0, 0.0, 0.0}, {2.0, 2.0}, 65.535);
  EXPECT_NEAR(terrain.heightAt(1.0, 1.0), 0.001, 1e-12);
  EXPECT_NEAR(terrain.heightAt(-1.0, -1.0), 0.256, 1e-12);
  EXPECT_NEAR(terrain.heightAt(1.0, -1.0), 65.535, 1e-12);
}

TEST(TerrainTest, SaysWhatIsWrongWithAnImage) {
  const auto problem = [](const std::string& file) -> std::string {
    try {
      readTerrain(file, Vector3d::Zero(), {1.0, 1.0}, 1.0);
      return "nothing";
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  };
  EXPECT_EQ(problem("/no/such/file.png"), "cannot be opened as '/no/such/file.png'");
  EXPECT_EQ(problem(folder()), "is no PNG image");
  EXPECT_EQ(problem(test::writePng(fileNamed("row"), 5, 8, {1, 2, 3, 4, 5})), "has 5 x 1 pixels");
  EXPECT_EQ(problem(test::writePng(fileNamed("wide"), 4097, 8, std::vector<int>(2 * 4097))), "has 4097 x 2 pixels");
  EXPECT_EQ(problem(test::writePng(fileNamed("colour"), 2, 8, std::vector<int>(12), PNG_COLOR_TYPE_RGB)),
            "is coloured");
  EXPECT_EQ(problem(test::writePng(fileNamed("alpha"), 2, 8, std::vector<int>(8), PNG_COLOR_TYPE_GRAY_ALPHA)),
            "is partly transparent");
  const std::string cut = test::writePng(fileNamed("cut"), 40, 8, std::vector<int>(1600, 7));
  ASSERT_EQ(truncate(cut.c_str(), 60), 0);
  EXPECT_EQ(problem(cut), "is damaged (Read Error)");
}

TEST(TerrainTest, HeightsBetweenVerticesAreThoseOfTriangles) {
  const Terrain flat = made(5, 4, &plane);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const double x = 1.0 + 0.4 * part(random);
    const double y = 2.0 + 0.6 * part(random);
    ASSERT_NEAR(flat.heightAt(x, y), plane(x, y), 1e-12);
    ASSERT_LT((flat.triangleAt(x, y).normal - Vector3d(-0.3, 0.2, 1.0).normalized()).norm(), 1e-12);
  }
  // one cell, split from its lower left corner to its upper right one
  const Terrain cell({0.0, 0.0}, {1.0, 1.0}, 2, 2, {0.0, 1.0, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(cell.heightAt(0.5, 0.5), 0.0);
  EXPECT_DOUBLE_EQ(cell.heightAt(0.75, 0.25), 0.5);
  EXPECT_DOUBLE_EQ(cell.heightAt(0.25, 0.75), 0.0);
}

TEST(TerrainTest, RaysHitAPlaneWhereItIs) {
  const Terrain terrain = made(30, 20, &plane);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const auto somewhere = [&](double height) {
    const double x = 1.0 + 2.9 * part(random);
    const double y = 2.0 + 3.8 * part(random);
    return Vector3d(x, y, plane(x, y) + height);
  };
  for (int i = 0; i < 2000; ++i) {
    const double above = part(random);
    const double below = part(random);
    const Segment down{somewhere(above), somewhere(-below)};
    ASSERT_NEAR(terrain.closestHit(down), above / (above + below), 1e-12);
    ASSERT_EQ(terrain.closestHit({down.to, down.from}), kNever);  // from below
    ASSERT_EQ(terrain.closestHit({somewhere(above), somewhere(below)}), kNever);
  }
}

TEST(TerrainTest, RaysHitABumpWhereItsTrianglesAre) {
  const Terrain terrain = made(30, 20, &bump);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto somewhere = [&] {
      return Vector3d(1.0 + 2.9 * part(random), 2.0 + 3.8 * part(random), 0.5 * part(random) - 0.1);
    };
    Segment ray{somewhere(), somewhere()};
    if (ray.from.z() < terrain.heightAt(ray.from.x(), ray.from.y())) {
      continue;
    }
    // sampled along the ray: above the terrain until the hit, and below just behind it
    const double hit = terrain.closestHit(ray);
    const auto over = [&](double t) {
      const Vector3d point = ray.from + t * (ray.to - ray.from);
      return point.z() - terrain.heightAt(point.x(), point.y());
    };
    for (double t = 0.0; t < std::min(1.0, hit); t += 0.001) {
      ASSERT_GT(over(t), -1e-12);
    }
    if (hit <= 1.0) {
      ++hits;
      ASSERT_NEAR(over(hit), 0.0, 1e-12);
      ASSERT_LT(over(std::min(1.0, hit + 1e-6)), 0.0);
    }
  }
  EXPECT_GT(hits, 300);
}

TEST(TerrainTest, AVerticalRayHitsTheHeight) {
  const Terrain terrain = made(30, 20, &bump);
  for (const auto& [x, y] : {std::pair(2.03, 4.01), std::pair(2.0, 4.0), std::pair(1.0, 2.0), std::pair(3.9, 5.8)}) {
    EXPECT_NEAR(terrain.closestHit({{x, y, 2.0}, {x, y, -1.0}}), (2.0 - terrain.heightAt(x, y)) / 3.0, 1e-12);
  }
  EXPECT_EQ(terrain.closestHit({{0.9, 2.0, 2.0}, {0.9, 2.0, -1.0}}), kNever);
}

TEST(TerrainTest, TheRimIsACliff) {
  const Terrain mesa({1.0, 1.0}, {1.0, 1.0}, 2, 2, {0.2, 0.2, 0.2, 0.2});
  EXPECT_NEAR(mesa.closestHit({{0.0, 1.5, 0.1}, {2.0, 1.5, 0.1}}), 0.5, 1e-12);
  EXPECT_EQ(mesa.closestHit({{0.0, 1.5, 0.21}, {2.0, 1.5, 0.21}}), kNever);
  EXPECT_EQ(mesa.closestHit({{1.5, 1.5, 0.1}, {3.0, 1.5, 0.1}}), kNever);  // from within the ground
  const Terrain hole({1.0, 1.0}, {1.0, 1.0}, 2, 2, {-0.2, -0.2, -0.2, -0.2});
  EXPECT_NEAR(hole.closestHit({{1.5, 1.5, -0.1}, {2.5, 1.5, -0.1}}), 0.5, 1e-12);
  EXPECT_NEAR(hole.closestHit({{1.5, 1.5, 0.0}, {2.5, 1.5, -0.1}}), 0.5, 1e-12);
  EXPECT_EQ(hole.closestHit({{1.5, 1.5, 0.1}, {2.5, 1.5, 0.1}}), kNever);
  EXPECT_NEAR(hole.closestHit({{2.5, 1.5, 0.1}, {1.5, 1.5, -0.2}}), 0.5, 1e-12);  // from outside, through the floor
}

TEST(TerrainTest, WhatABundleMayHitHoldsAllThatItHits) {
  const Terrain terrain = made(30, 20, &bump);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  int misses = 0;
  for (int i = 0; i < 5000; ++i) {
    RayBundle rays;
    rays.centre = {2.5 + 3.0 * part(random), 4.0 + 3.0 * part(random), 0.6 * part(random)};
    rays.radius = 0.3;
    const Vector3d way = rays.radius * Vector3d(part(random), part(random), part(random)).normalized();
    if (!terrain.mayHit(rays)) {
      ++misses;
      ASSERT_GT(terrain.closestHit({rays.centre - way, rays.centre + way}), 1.0);
    }
  }
  EXPECT_GT(misses, 500);
  RayBundle high;
  high.centre = {2.0, 4.0, 0.8};
  high.radius = 0.3;
  EXPECT_FALSE(terrain.mayHit(high));
  high.radius = 0.5;
  EXPECT_TRUE(terrain.mayHit(high));
}

TEST(TerrainTest, RaysThroughTheSpaceHitIt) {
  Space space;
  space.terrain = std::make_shared<const Terrain>(made(30, 20, &bump));
  const RayHit hit = space.castRay({{2.0, 4.0, 1.0}, {2.0, 4.0, 0.0}});
  EXPECT_NEAR(hit.fraction, 0.6, 1e-12);
  EXPECT_TRUE(hit.isHit());
  EXPECT_EQ(hit.row, kNoRow);
  EXPECT_TRUE(space.isOccluded({{1.2, 4.0, 0.1}, {2.8, 4.0, 0.1}}, kNoRow, kNoRow));
  EXPECT_FALSE(space.isOccluded({{1.2, 4.0, 0.5}, {2.8, 4.0, 0.5}}, kNoRow, kNoRow));
  EXPECT_DOUBLE_EQ(space.lowestGround(), space.terrain->bounds().min().z());
}

}  // namespace
}  // namespace swarmanoid
