#include "swarmanoid_space/index/box_grid.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

namespace swarmanoid {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

std::multiset<int> near(const BoxGrid& grid, const Vector2d& centre, double radius) {
  std::multiset<int> found;
  grid.visitNear(centre, radius, [&](int body) {
    found.insert(body);
    return true;
  });
  return found;
}

AlignedBox2d boxAt(std::mt19937& random, double side) {
  std::uniform_real_distribution<double> place(-3.0, side + 3.0);
  std::uniform_real_distribution<double> half(0.01, 4.0);
  const Vector2d centre(place(random), place(random));
  const Vector2d extent(half(random), half(random));
  return {centre - extent, centre + extent};
}

TEST(BoxGridTest, FindsEachNearBoxOnceAndNoOther) {
  constexpr double kSide = 17.3;
  std::mt19937 random(5);
  BoxGrid grid;
  grid.configure({-1.3, 2.1}, {kSide, 0.7 * kSide});
  std::map<int, AlignedBox2d> boxes;
  std::uniform_int_distribution<int> number(0, 90);
  std::uniform_real_distribution<double> place(-4.0, kSide + 4.0);
  std::uniform_real_distribution<double> reach(0.0, 3.0);
  for (int i = 0; i < 4000; ++i) {
    const int body = number(random);
    if (i % 3 == 0 && boxes.count(body) > 0) {
      boxes.erase(body);
      grid.remove(body);
    } else {
      boxes[body] = boxAt(random, kSide);
      grid.set(body, boxes[body]);
    }
    const Vector2d centre(place(random), place(random));
    const double radius = reach(random);
    std::multiset<int> expected;
    for (const auto& [each, box] : boxes) {
      ASSERT_EQ(box.min(), grid.bounds(each).min());
      if (box.squaredExteriorDistance(centre) <= radius * radius) {
        expected.insert(each);
      }
    }
    ASSERT_EQ(expected, near(grid, centre, radius)) << "after " << i;
  }
}

TEST(BoxGridTest, StopsWhenToldTo) {
  BoxGrid grid;
  grid.configure({0.0, 0.0}, {5.0, 5.0});
  for (int body = 0; body < 4; ++body) {
    grid.set(body, AlignedBox2d(Vector2d(1.0, 1.0), Vector2d(1.5, 4.0)));
  }
  int visited = 0;
  EXPECT_FALSE(grid.visitNear({1.2, 2.0}, 0.5, [&](int) { return ++visited < 2; }));
  EXPECT_EQ(2, visited);
}

}  // namespace
}  // namespace swarmanoid
