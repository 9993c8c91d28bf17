// A gap that one footbot falls into and a chain of five crosses: robots over the gap hang on the others.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

constexpr double kEdge = 3.0;     // m, where the near platform ends
constexpr double kReach = 0.195;  // m, from a footbot to the next in a chain

/// Footbots one behind the other on a platform, all driving towards the gap; each grips the robot before it.
struct Chain {
  Chain(int count, double gap) : world({{"ground_height", "-0.5"}}) {
    world.addBlock({4.0, 1.0, 0.4}, 0.0, flatPose(kEdge - 2.0, 2.0, 0.0, -0.2));
    world.addBlock({4.0, 1.0, 0.4}, 0.0, flatPose(kEdge + gap + 2.0, 2.0, 0.0, -0.2));
    for (int i = 0; i < count; ++i) {
      footbots.push_back(world.addFootbot(flatPose(kEdge - 0.3 - i * kReach, 2.0)));
      world.setGripper(footbots.back(), i > 0);
    }
    world.step();
  }

  /// Drives far enough for all of them to cross. @return lowest height of any of them [m]
  double drive(double gap) {
    for (const Row row : footbots) {
      world.drive(row, 0.1);
    }
    double lowest = 0.0;
    const double way = 0.3 + gap + kReach * static_cast<double>(footbots.size()) + 0.2;
    for (int tick = 0; tick < static_cast<int>(way / 0.01); ++tick) {
      world.step();
      for (const Row row : footbots) {
        lowest = std::min(lowest, world.pose(row).position.z());
      }
    }
    return lowest;
  }

  World world;
  std::vector<Row> footbots;
};

constexpr double kGap = 0.2;  // m

TEST(GapTest, OneFootbotFallsIn) {
  Chain chain(1, kGap);
  EXPECT_LT(chain.drive(kGap), -0.05);
  EXPECT_LT(chain.world.pose(chain.footbots[0]).position.x(), kEdge + kGap) << "it does not get across";
}

TEST(GapTest, AChainOfFivePasses) {
  Chain chain(5, kGap);
  for (std::size_t i = 1; i < chain.footbots.size(); ++i) {
    ASSERT_EQ(chain.world.gripped(chain.footbots[i]), chain.footbots[i - 1]);
  }
  EXPECT_GT(chain.drive(kGap), -0.02) << "nobody sinks into it";
  for (const Row row : chain.footbots) {
    EXPECT_GT(chain.world.pose(row).position.x(), kEdge + kGap);
    EXPECT_NEAR(chain.world.pose(row).position.z(), 0.0, 2e-3);
    EXPECT_LT(tiltOf(chain.world.pose(row)), 0.02);
  }
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
