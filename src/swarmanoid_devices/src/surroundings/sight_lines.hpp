/// Lines of sight from one robot to many points around it. The result equals that of Space::isOccluded, at a fraction
/// of the cost. Most lines pass all nearby entities at a distance, which their outlines in the positional index show.
/// For the other entities their silhouettes decide most cases; the engine decides the rest (Engine::blocks).
///
/// Threads  one SightLines per thread, kept between calls: its buffers grow to the size needed, and stay.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

class SightLines {
 public:
  using Place = PositionalIndex::Place;

  /// Sets the eye; called for each eye in each tick.
  /// @param self the robot that carries the eye; it hides nothing @param eye in W [m]
  /// @param reach radius of a sphere around the eye that contains all points [m]
  /// @param near result of PositionalIndex::collectPlaces for that sphere, enlarged by PositionalIndex::prismMargin
  void begin(const Space& space, Row self, const Eigen::Vector3d& eye, double reach, const std::vector<Place>& near);
  /// The same, for callers without a result of collectPlaces.
  void begin(const Space& space, Row self, const Eigen::Vector3d& eye, double reach);

  /// Whether an obstacle other than self and the owner is between the eye and a point. @param point in W [m]
  /// @pre begin was called in this tick
  bool isOccluded(const Eigen::Vector3d& point, Row owner);

 private:
  enum class Verdict { kFree, kBlocked, kUnsure };

  /// Outlines of possible obstacles, seen from above, by column so that a line is compared with several at once. They
  /// are in single precision, and enlarged by its rounding error.
  struct Batch {
    static constexpr std::size_t kSize = 32;  // one bit of a mask for each
    static constexpr std::size_t kLanes = 4;  // outlines that are compared at once

    alignas(16) std::array<float, kSize> x{};       ///< of the axes, relative to the eye [m]
    alignas(16) std::array<float, kSize> y{};       ///< relative to the eye [m]
    alignas(16) std::array<float, kSize> radius{};  ///< [m]
    std::array<const PositionalIndex::Outline*, kSize> outlines{};
    std::size_t lanes = 0;  ///< number of outlines to compare: a multiple of kLanes

    /// Mask of the outlines that a line may touch. @param way from the eye to the end of the line, seen from above [m]
    std::uint32_t meeting(const Eigen::Vector2f& way, float length) const;
  };

  /// @param margin added to all radii [m]
  void fillBatches(const std::vector<Place>& near, double margin);
  bool isBlockedByLarge(const Segment& line, Row owner) const;
  bool isBlocked(const PositionalIndex::Outline& outline, const Segment& line, Row owner) const;
  Verdict judge(const PositionalIndex::Outline& outline, const Segment& line) const;

  std::vector<Place> near_;  // scratch of begin
  const Space* space_ = nullptr;
  Row self_ = kNoRow;
  Eigen::Vector3d eye_ = Eigen::Vector3d::Zero();
  double prism_reach_ = 1.0;
  std::size_t count_ = 0;       // number of outlines in batches_
  std::vector<Batch> batches_;  // never shrinks
  std::vector<const PositionalIndex::LargeOutline*> large_;
};

}  // namespace swarmanoid::devices
