// Code that writes what its phase must not write, for must_not_compile_test.py. Each line with a comment `error:` has
// that error if WITH_ERRORS is 1; without these lines the file compiles.
#include "swarmanoid_space/access.hpp"
#include "swarmanoid_space/actuator.hpp"
#include "swarmanoid_space/rule.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid {

// clang-format off
void move(const Space& space, const MoveAccess& access, Row row) {
  access.pose[row] = space.entities.pose[row];
#if WITH_ERRORS
  space.leds[row][0] = colors::kRed;     // an engine lights an LED: error: discards qualifiers
  access.leds[row][0] = colors::kRed;    // ... through its access: error: has no member named 'leds'
  space.structure.connect(row, row);     // an engine grips in `move`: error: discards qualifiers
  const ActuateAccess another(space);    // an engine makes itself another access: error: Space&.* discards qualifiers
#endif
}

void connect(const Space& space, const ConnectAccess& access, Row row) {
  access.events.push_back({Event::Kind::kAttached, space.entities.name[row], "", ""});
#if WITH_ERRORS
  access.pose[row].position.x() = 1.0;   // an engine moves an entity in `connect`: error: has no member named 'pose'
#endif
}

void sense(const Space& space, Row row) {
  static_cast<void>(space.entities.pose[row]);
#if WITH_ERRORS
  space.entities.pose[row] = Pose{};     // a sensor moves a robot: error: discards qualifiers
#endif
}

void report(const ReportAccess& access) {
  access.overflows.clear();
#if WITH_ERRORS
  access.wheels[Row{0}].left = 1.0;      // a sensor's report drives the wheels: error: has no member named 'wheels'
#endif
}

void apply(const Space& space, const ActuateAccess& access, Row row) {
  access.wheels[row].left = space.wheels[row].right;
#if WITH_ERRORS
  access.pose[row].position.x() += 0.1;  // an actuator moves its robot: error: has no member named 'pose'
#endif
}

void afterTick(const Space& space, Row row) {
  static_cast<void>(space.properties[row]);
#if WITH_ERRORS
  space.properties[row][0] = 1.0;        // a rule charges a battery by itself: error: assignment of read-only
#endif
}

/// Of the phase `index`.
struct IndexAccess {
  explicit IndexAccess(Space& space)
      : outside(writable<WrittenIn::kIndex>(space.outside))
#if WITH_ERRORS
      , pose(writable<WrittenIn::kIndex>(space.entities.pose))  // `index` writes poses: error: does not write this column
#endif
  {}

  ByRow<char>& outside;
#if WITH_ERRORS
  ByRow<Pose>& pose;
#endif
};
// clang-format on

}  // namespace swarmanoid
