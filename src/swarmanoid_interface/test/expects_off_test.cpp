// The checks are off here, whatever the build's own option says.
#undef SWARMANOID_EXPECTATIONS
#ifndef NDEBUG
#define NDEBUG
#endif
#include "swarmanoid_interface/expects.hpp"

#include <gtest/gtest.h>

namespace swarmanoid {
namespace {

TEST(ExpectsOffTest, TheConditionIsNotEvaluated) {
  int looks = 0;
  SWARMANOID_EXPECTS(++looks == 7);
  EXPECT_EQ(looks, 0);
}

}  // namespace
}  // namespace swarmanoid
