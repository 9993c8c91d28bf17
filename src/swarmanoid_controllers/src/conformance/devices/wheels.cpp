// The wheels of any robot have no check of their own: that of its differential drive is by the same motion. They rest
// between checks.
#include "swarmanoid_interface/devices/wheels.hpp"
#include "../checks.hpp"

namespace swarmanoid::conformance {
namespace {

std::vector<Check> noChecks(Bench& /*bench*/) { return {}; }

const ChecksRegistration any_wheels_checks({Wheels::kType, noChecks, nullptr, restAtOnce<Wheels>});

}  // namespace
}  // namespace swarmanoid::conformance
