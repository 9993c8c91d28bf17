// The encoders of any robot's wheels measure the commanded turns, at a different speed for each wheel. Whether the
// wheels drive the robot ahead is left to the checks of its differential drive or its odometry. The wheels rest between
// checks.
#include "swarmanoid_interface/devices/wheels.hpp"

#include <memory>

#include "../checks.hpp"
#include "swarmanoid_interface/devices/wheel_encoders.hpp"

namespace swarmanoid::conformance {
namespace {

std::vector<Check> anyWheelsChecks(Bench& bench) {
  if (!bench.isListed(Wheels::kType) || !bench.isListed(WheelEncoders::kType)) {
    return {};
  }
  constexpr double kTime = 2.0;        // s
  constexpr double kSlow = 0.8;        // rad/s
  constexpr double kFast = 1.6;        // rad/s
  constexpr double kLeastTurn = 0.15;  // rad, allowed error
  Check check{Wheels::kType, {Wheels::kType, WheelEncoders::kType}, "", {}, {}};
  const auto before = std::make_shared<WheelEncoders>();
  const auto took = std::make_shared<double>(0.0);
  for (const double sign : {1.0, -1.0}) {
    Stage turn{"turning the wheels", kTime, nullptr, nullptr, nullptr, nullptr};
    turn.begin = [&bench, before] { *before = *bench.sensor<WheelEncoders>(); };
    turn.act = [&bench, sign] { bench.actuator<Wheels>()->setAngularVelocity(sign * kSlow, sign * kFast); };
    turn.end = [took](double seconds) { *took = seconds; };
    check.stages.push_back(std::move(turn));
    check.stages.push_back(settle(bench, [&bench, before, took, sign] {
      const WheelEncoders& now = *bench.sensor<WheelEncoders>();
      bench.expectAbout("the left wheel has turned by", now.left.turned - before->left.turned, sign * kSlow * *took,
                        kLeastTurn, "rad");
      bench.expectAbout("the right wheel has turned by", now.right.turned - before->right.turned, sign * kFast * *took,
                        kLeastTurn, "rad");
    }));
  }
  return {check};
}

const ChecksRegistration any_wheels_checks({Wheels::kType, anyWheelsChecks, nullptr, restAtOnce<Wheels>});

}  // namespace
}  // namespace swarmanoid::conformance
