/// What shines in this tick: robots with lit LEDs, and lamps. It is put together once a tick, so that a robot in the
/// dark need not ask all that is around it.
///
/// Phase    fill: in Sensor::prepare. collect: in `sense`, from any number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// How far light goes; 0: it is not felt [m].
struct LightReach {
  double of_lamps = 0.0;
  double of_leds = 0.0;
};

/// How far that of an entity goes: of what is a robot its LEDs shine, of anything else itself.
inline double reachOfLight(const EntityModel& model, const LightReach& reach) {
  return model.is_robot ? reach.of_leds : reach.of_lamps;
}

/// Whether any LED of a robot shines.
inline bool isAnyLit(Span<const Color> leds) {
  return std::any_of(leds.begin(), leds.end(), [](Color led) { return led.isLit(); });
}

class LitEntities {
 public:
  /// @param reach of the sensors: what has none is not looked at
  void fill(const Space& space, const LightReach& reach);

  /// What shines onto a sphere, by entity number. @param self who is left out @param radius of the sphere [m]
  /// @param found is cleared first; its room grows to what was needed
  void collect(const Space& space, Row self, const Eigen::Vector3d& centre, double radius, const LightReach& reach,
               std::vector<Row>& found) const;

 private:
  /// Either robots or lamps.
  struct Group {
    std::vector<PositionalIndex::Outline> small;  // at the most kFew of them; else the index is asked
    std::vector<PositionalIndex::LargeOutline> large;
    std::size_t count = 0;  // of those that are not large
  };

  static void collectFew(const Group& group, const Eigen::Vector3d& centre, double radius, std::vector<Row>& found);
  void collectMany(const Space& space, bool robots, const Eigen::Vector3d& centre, double radius,
                   std::vector<Row>& found) const;

  Group robots_;
  Group lamps_;
  std::vector<char> is_lit_;  // by place in the index
};

}  // namespace swarmanoid::devices
