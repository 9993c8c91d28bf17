/// Whether an entity's solids hide its own LEDs, by standing between them and an eye.
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

/// What of an entity hides its LEDs.
///
/// Each shape counts without its outer kLedHeight (but never less than half of it, so that thin plates hide too): a
/// LED on a surface, or as deep in it, is seen from its own side of the body and a little beyond the edge of it, as
/// one that stands out by that much. A shape in which the LED lies deeper is a hull around it, such as the cage of an
/// eyebot's rotors or the solid of a prey whose colour is looked at, and does not hide it.
///
/// Threads  each needs LedShades of its own, and keeps them: their room grows to what was needed, and stays.
class LedShades {
 public:
  /// Looks at another entity, or in another tick. @param model measured (EntityModel::measureShapes), outlives the
  /// questions @param joints states of the model's joints, likewise
  void begin(const EntityModel& model, Span<const JointState> joints);

  /// Which of the LEDs that are asked about are hidden from an eye. @param eye in the body frame [m]
  LedSet hidden(const Eigen::Vector3d& eye, const LedSet& asked);

  /// Where somebody's eyes are: in an upright cylinder of the body frame.
  struct Eyes {
    Eigen::Vector2d axis = Eigen::Vector2d::Zero();  ///< of the cylinder, seen from above [m]
    double radius = 0.0;                             ///< [m]
    double lowest = 0.0;                             ///< along body z [m]
    double highest = 0.0;                            ///< likewise
  };
  /// LEDs for which the answer is the same from all eyes.
  struct SameForAll {
    LedSet hidden;
    LedSet free;
  };
  /// For somebody with many eyes, who need not ask about these LEDs for each of them. Some LEDs of which the same is
  /// true may be left out.
  SameForAll sameForAll(const Eyes& eyes);

 private:
  /// A shape without its skin, where its joint has turned it.
  struct Shade {
    bool is_placed = false;   // most shapes stand before no LED of their own, and need not be
    bool is_aligned = false;  // its frame has the directions of the body
    CollisionShape::Kind kind = CollisionShape::Kind::kBox;
    Eigen::Vector3d half_extent;
    Eigen::Vector3d position;
    Eigen::Matrix3d to_shape;  // from the directions of the body
  };
  /// The lines from eyes to all LEDs.
  struct Lines {
    double way_in = 0.0;   ///< to the body z axis at least, seen from above [m]
    double length = 0.0;   ///< at most so long, seen from above [m]
    double lowest = 0.0;   ///< where they begin, along body z [m]
    double highest = 0.0;  ///< likewise
  };
  using Column = std::array<double, EntityModel::kMaxLeds>;
  /// The ways from an eye to some LEDs in the frame of a shape, by coordinate, so that several are looked at at once.
  struct Steps {
    std::size_t count = 0;
    std::array<std::uint8_t, EntityModel::kMaxLeds> led;
    Column x;  // m
    Column y;  // likewise
    Column z;  // likewise
  };
  /// The LEDs of which it is sure at once that a shape hides them, and that it does not.
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
