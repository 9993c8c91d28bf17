// The checks are on here, whatever the build's own option says.
#ifndef SWARMANOID_EXPECTATIONS
#define SWARMANOID_EXPECTATIONS
#endif
#include "swarmanoid_interface/expects.hpp"

#include <gtest/gtest.h>

#include "swarmanoid_interface/random.hpp"

namespace swarmanoid {
namespace {

int half(int number) {
  SWARMANOID_EXPECTS(number % 2 == 0);
  return number / 2;
}

TEST(ExpectsDeathTest, ACallerThatDoesOtherwiseEndsTheProcess) {
  EXPECT_EQ(half(6), 3);
  EXPECT_EXIT(half(7), testing::KilledBySignal(SIGABRT),
              "expects_test\\.cpp:15: expected of the caller: number % 2 == 0\n");
}

TEST(ExpectsDeathTest, NoNumberIsBelowZero) {
  RandomStream stream(1, 2);
  EXPECT_LT(stream.below(1), 1U);
  EXPECT_EXIT(stream.below(0), testing::KilledBySignal(SIGABRT), "random\\.hpp:[0-9]+: .*: count > 0\n");
}

TEST(ExpectsTest, TheConditionIsEvaluatedOnce) {
  int looks = 0;
  SWARMANOID_EXPECTS(++looks == 1);
  EXPECT_EQ(looks, 1);
}

}  // namespace
}  // namespace swarmanoid
