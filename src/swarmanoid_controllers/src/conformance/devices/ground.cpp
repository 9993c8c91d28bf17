// Spots under a robot measure the floor at the test place: its brightness, or its colour.
#include "swarmanoid_interface/devices/ground.hpp"

#include <string>

#include "../checks.hpp"
#include "swarmanoid_interface/devices/floor_color.hpp"
#include "swarmanoid_interface/devices/footbot_ground.hpp"

namespace swarmanoid::conformance {
namespace {

void expectFloor(Bench& bench, std::size_t spot, float value) {
  constexpr double kUneven = 0.15;  // allowed error of a reflection
  bench.expectNear("spot " + std::to_string(spot) + " reads", value,
                   Ground::reflection(bench.surroundings().floor_color), kUneven, "");
}

/// @param read function that judges all spots of the device
template <class Device>
std::vector<Check> floorCheck(Bench& bench, void (*read)(Bench&, const Device&)) {
  if (!bench.isListed(Device::kType)) {
    return {};
  }
  Check check{Device::kType, {Device::kType}, "", {}, {}};
  check.stages.push_back(settle(bench, [&bench, read] { read(bench, *bench.sensor<Device>()); }));
  return {check};
}

template <class Device>
std::vector<Check> footbotGroundChecks(Bench& bench) {
  return floorCheck<Device>(bench, [](Bench& tester, const Device& ground) {
    for (std::size_t i = 0; i < Device::kCount; ++i) {
      expectFloor(tester, i, ground.value[i]);
    }
  });
}

std::vector<Check> groundChecks(Bench& bench) {
  return floorCheck<Ground>(bench, [](Bench& tester, const Ground& ground) {
    for (std::size_t i = 0; i < ground.sensors.size(); ++i) {
      expectFloor(tester, i, ground.sensors[i].value);
    }
  });
}

std::vector<Check> floorColorChecks(Bench& bench) {
  return floorCheck<FloorColor>(bench, [](Bench& tester, const FloorColor& floor) {
    const Color expected = tester.surroundings().floor_color;
    tester.expectTrue("the floor is about " + toString(expected) + "; found " + toString(floor.color),
                      isAbout(floor.color, expected));
  });
}

const ChecksRegistration ground_checks({Ground::kType, groundChecks});
const ChecksRegistration floor_color_checks({FloorColor::kType, floorColorChecks});
const ChecksRegistration ring_ground_checks({FootbotGround::kType, footbotGroundChecks<FootbotGround>});
const ChecksRegistration base_ground_checks({FootbotBaseGround::kType, footbotGroundChecks<FootbotBaseGround>});

}  // namespace
}  // namespace swarmanoid::conformance
