// Plugins that write what their phase must not write, for must_not_compile_test.py. Each line with a comment `error:`
// has that error if WITH_ERRORS is 1; without these lines the file compiles.
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/leds.hpp"
#include "swarmanoid_space/access.hpp"
#include "swarmanoid_space/actuator.hpp"
#include "swarmanoid_space/engine.hpp"
#include "swarmanoid_space/rule.hpp"
#include "swarmanoid_space/sensor.hpp"

namespace swarmanoid {

// clang-format off
class AnEngine : public Engine {
 public:
  void move(const Space& space, const MoveAccess& access, Duration) override {
    access.pose[row_] = space.entities.pose[row_];
#if WITH_ERRORS
    space.leds[row_][0] = colors::kRed;       // an engine lights an LED: error: discards qualifiers
    access.leds[row_][0] = colors::kRed;      // ... through its access: error: has no member named 'leds'
    space.structure.connect(row_, row_);      // an engine grips in `move`: error: discards qualifiers
    const ActuateAccess another(space);       // an engine makes itself another access: error: Space&.* discards qualifiers
    access.pose = space.entities.pose;        // an engine replaces a whole column: error: is protected
    space.engines[0]->clear();                // an engine clears another one: error: discards qualifiers
#endif
  }
  void connect(const Space& space, const ConnectAccess& access) override {
    access.events.push_back({Event::Kind::kAttached, space.entities.name[row_], "", ""});
#if WITH_ERRORS
    access.pose[row_].position.x() = 1.0;     // an engine moves an entity in `connect`: error: has no member named 'pose'
#endif
  }

 private:
  Row row_{0};
};

class ASensor : public SensorOf<FootbotProximity> {
 public:
  void sense(const Space& space, std::size_t, std::size_t) override {
    static_cast<void>(space.entities.pose[Row{0}]);
#if WITH_ERRORS
    space.entities.pose[Row{0}] = Pose{};     // a sensor moves a robot: error: discards qualifiers
#endif
  }
  void report(const Space&, const ReportAccess& access) override {
    access.overflows.clear();
#if WITH_ERRORS
    access.wheels[Row{0}].left = 1.0;         // a sensor's report drives the wheels: error: has no member named 'wheels'
#endif
  }
};

class AnActuator : public ActuatorOf<FootbotLeds> {
 public:
  void apply(const Space& space, const ActuateAccess& access, BasicActuatorInstance<FootbotLeds>& instance) override {
    access.wheels[instance.row].left = space.wheels[instance.row].right;
#if WITH_ERRORS
    access.pose[instance.row] = Pose{};       // an actuator moves its robot: error: has no member named 'pose'
#endif
  }
  void afterMove(const Space&, const AfterMoveAccess& access) override {
    access.laser_spots.clear();
#if WITH_ERRORS
    access.structure.release(Row{0});         // an actuator releases a grip: error: has no member named 'structure'
#endif
  }
};

class ARule : public Rule {
 public:
  void afterTick(const Space& space, InterventionQueue&) override {
    static_cast<void>(space.properties[Row{0}]);
#if WITH_ERRORS
    space.properties[Row{0}][0] = 1.0;        // a rule charges a battery by itself: error: assignment of read-only
#endif
  }
};

/// An access object for the phase `index`.
struct IndexWriter {
  explicit IndexWriter(Space& space)
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
