/// Computes which LEDs of an entity are hidden from an eye by the entity's own solids.
#pragma once

#include <Eigen/Core>
#include <array>
#include <bitset>
#include <cstdint>
#include <vector>

#include "swarmanoid_interface/span.hpp"
#include "swarmanoid_space/models/entity_model.hpp"
#include "swarmanoid_space/state/joints.hpp"

namespace swarmanoid {

/// How far LEDs stand out of the surfaces on which they sit [m].
constexpr double kLedHeight = 0.005;

/// LEDs of one entity: bit k belongs to EntityModel::led_positions[k].
using LedSet = std::bitset<EntityModel::kMaxLeds>;

/// Calls visit(number of the LED) for those in the set, in their order.
template <class Visit>
void visitLeds(const LedSet& leds, Visit visit) {
  for (std::uint64_t left = leds.to_ullong(); left != 0; left &= left - 1) {
    visit(static_cast<std::size_t>(__builtin_ctzll(left)));
  }
}

/// The solids of an entity that hide its LEDs.
///
/// Each shape is shrunk by kLedHeight (but at most to half of its size, so that thin plates hide too). So a LED on a
/// surface, or up to kLedHeight below it, is visible from its own side of the body and slightly beyond the edge, like a
/// LED that protrudes by that height. A shape in which the LED lies deeper is a hull around it, such as the cage of an
/// eyebot's rotors or the solid of a coloured prey, and does not hide it.
///
/// Threads  each thread needs its own LedShades. Reuse the object: its memory grows to the required size and stays.
class LedShades {
 public:
  /// Selects an entity, or another tick. @param model measured (EntityModel::measureShapes) @param joints states of the
  /// model's joints. Both must outlive the queries.
  void begin(const EntityModel& model, Span<const JointState> joints);

  /// The LEDs in `asked` that are hidden from an eye. @param eye in the body frame [m]
  LedSet hidden(const Eigen::Vector3d& eye, const LedSet& asked);

  /// Region of an observer's eyes: an upright cylinder in the body frame.
  struct Eyes {
    Eigen::Vector2d axis = Eigen::Vector2d::Zero();  ///< of the cylinder, seen from above [m]
    double radius = 0.0;                             ///< [m]
    double lowest = 0.0;                             ///< along body z [m]
    double highest = 0.0;                            ///< along body z [m]
  };
  /// LEDs with the same answer for all eyes.
  struct SameForAll {
    LedSet hidden;
    LedSet free;
  };
  /// For observers with many eyes: these LEDs need no query for each eye. Conservative: some LEDs with the same answer
  /// for all eyes may be missing.
  SameForAll sameForAll(const Eyes& eyes);

 private:
  /// A shape without its outer layer, turned by its joint.
  struct Shade {
    bool is_placed = false;   // computed on demand: most shapes hide no LED of their own entity
    bool is_aligned = false;  // its axes are parallel to those of the body
    CollisionShape::Kind kind = CollisionShape::Kind::kBox;
    Eigen::Vector3d half_extent;
    Eigen::Vector3d position;
    Eigen::Matrix3d to_shape;  // rotation from body axes
  };
  /// Bounds of the lines from eyes to all LEDs.
  struct Lines {
    double way_in = 0.0;   ///< least distance of the eyes from body z, seen from above [m]
    double length = 0.0;   ///< maximum length, seen from above [m]
    double lowest = 0.0;   ///< of the eyes, along body z [m]
    double highest = 0.0;  ///< of the eyes, along body z [m]
  };
  using Column = std::array<double, EntityModel::kMaxLeds>;
  /// The vectors from an eye to some LEDs in the frame of a shape, by coordinate, so that loops over LEDs are
  /// vectorised.
  struct Steps {
    std::size_t count = 0;
    std::array<std::uint8_t, EntityModel::kMaxLeds> led;
    Column x;  // m
    Column y;  // m
    Column z;  // m
  };
  /// The LEDs that a shape certainly hides, and those that it certainly does not hide.
  struct Sure {
    std::uint64_t hidden = 0;
    std::uint64_t free = 0;
  };

  Lines linesFrom(const Eyes& eyes) const;
  bool isPassedBy(std::size_t shape, const Lines& lines) const;
  const Shade& shadeOf(std::size_t shape);
  void addHidden(const Shade& shade, const Eigen::Vector3d& eye, const LedSet& asked, LedSet& hidden) const;
  Steps stepsTo(const LedSet& asked, const Shade& shade, const Eigen::Vector3d& eye) const;
  static Sure behindCylinder(const Shade& shade, const Eigen::Vector3d& start, const Steps& steps);
  Sure behindCylinderForAll(const Shade& shade, const Eyes& eyes) const;
  Sure besideSphere(const Shade& shade, const Eigen::Vector3d& start, const Steps& steps) const;

  const EntityModel* model_ = nullptr;
  Span<const JointState> joints_;
  std::vector<Shade> shades_;
};

}  // namespace swarmanoid
