/// Entities that shine in this tick: robots with lit LEDs, and lamps. The list is built once a tick, so that a robot in
/// the dark need not check all entities around it.
///
/// Phase    fill: in Sensor::prepare. collect: in `sense`, from any number of threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// Maximum range of light; 0: no response to that kind of source [m].
struct LightReach {
  double of_lamps = 0.0;
  double of_leds = 0.0;
};

/// Light range of an entity: `of_leds` for robots, `of_lamps` for everything else.
inline double reachOfLight(const EntityModel& model, const LightReach& reach) {
  return model.is_robot ? reach.of_leds : reach.of_lamps;
}

/// Whether any LED of a robot is lit.
inline bool isAnyLit(Span<const Color> leds) {
  return std::any_of(leds.begin(), leds.end(), [](Color led) { return led.isLit(); });
}

class LitEntities {
 public:
  /// @param reach of the sensors; kinds of source with range 0 are skipped
  void fill(const Space& space, const LightReach& reach);

  /// Collects the entities whose light reaches a sphere, by entity number.
  /// @param self is left out @param radius of the sphere [m]
  /// @param found is cleared first; its capacity grows to the size needed
  void collect(const Space& space, Row self, const Eigen::Vector3d& centre, double radius, const LightReach& reach,
               std::vector<Row>& found) const;

 private:
  /// Either robots or lamps.
  struct Group {
    std::vector<PositionalIndex::Outline> small;  // at most kFew; with more, the index is searched instead
    std::vector<PositionalIndex::LargeOutline> large;
    std::size_t count = 0;  // number of entities that are not large
  };

  static void collectFew(const Group& group, const Eigen::Vector3d& centre, double radius, std::vector<Row>& found);
  void collectMany(const Space& space, bool robots, const Eigen::Vector3d& centre, double radius,
                   std::vector<Row>& found) const;

  Group robots_;
  Group lamps_;
  std::vector<char> is_lit_;  // by place in the index
};

}  // namespace swarmanoid::devices
