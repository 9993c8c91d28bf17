// Any robot with a level lidar that faces ahead measures the wall on its right.
#include "swarmanoid_interface/devices/lidar.hpp"

#include "../wall_on_the_right.hpp"

namespace swarmanoid::conformance {
namespace {

std::vector<Check> lidarChecks(Bench& bench) {
  Check check{Lidar::kType, {Lidar::kType}, needsWall(bench), {}, {}};
  check.is_at_start = true;
  check.stages.push_back(settle(bench, [&bench] {
    WallOnTheRight wall(bench, "beam");
    for (const LidarBeam& beam : bench.sensor<Lidar>()->beams) {
      wall.look(beam.angle, beam.range);
    }
    wall.end();
  }));
  return {check};
}

const ChecksRegistration lidar_checks({Lidar::kType, lidarChecks});

}  // namespace
}  // namespace swarmanoid::conformance
