/// Lines of sight from one robot to many points around it: which are free is what Space::isOccluded says, at a fraction
/// of the cost. Most lines pass by everything that is near, which is known by its outline in the positional index.
/// Where one does not, the silhouettes of that one thing say most of the time whether it stands in the way; else its
/// engine is asked (Engine::blocks).
///
/// Threads  each needs a SightLines of its own, and keeps it: its room grows to what was needed, and stays.
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

  /// Looks from another eye, or in another tick. @param self whose eye it is, which hides nothing @param eye in W [m]
  /// @param reach of a sphere around the eye that all points are in [m]
  /// @param near what PositionalIndex::collectPlaces finds in that sphere, made larger by PositionalIndex::prismMargin
  void begin(const Space& space, Row self, const Eigen::Vector3d& eye, double reach, const std::vector<Place>& near);
  /// The same, for those who have not asked the index themselves.
  void begin(const Space& space, Row self, const Eigen::Vector3d& eye, double reach);

  /// Whether something other than self and the owner stands between the eye and a point. @param point in W [m]
  /// @pre begin was called in this tick
  bool isOccluded(const Eigen::Vector3d& point, Row owner);

 private:
  enum class Verdict { kFree, kBlocked, kUnsure };

  /// Outlines of what could hide something, seen from above, column by column so that a line is compared with several
  /// at once: in single precision, and larger by what that rounds.
  struct Batch {
    static constexpr std::size_t kSize = 32;  // a bit of a word each
    static constexpr std::size_t kLanes = 4;  // that are compared at once

    alignas(16) std::array<float, kSize> x{};       ///< of the axes, from the eye [m]
    alignas(16) std::array<float, kSize> y{};       ///< likewise
    alignas(16) std::array<float, kSize> radius{};  ///< [m]
    std::array<const PositionalIndex::Outline*, kSize> outlines{};
    std::size_t lanes = 0;  ///< how many are looked at: a multiple of kLanes

    /// The bits of those that a line may pass by too near. @param way from the eye to its end, seen from above [m]
    std::uint32_t meeting(const Eigen::Vector2f& way, float length) const;
  };

  /// @param margin by which all are made larger [m]
  void fillBatches(const std::vector<Place>& near, double margin);
  bool isBlockedByLarge(const Segment& line, Row owner) const;
  bool isBlocked(const PositionalIndex::Outline& outline, const Segment& line, Row owner) const;
  Verdict judge(const PositionalIndex::Outline& outline, const Segment& line) const;

  std::vector<Place> near_;  // scratch of begin
  const Space* space_ = nullptr;
  Row self_ = kNoRow;
  Eigen::Vector3d eye_ = Eigen::Vector3d::Zero();
  double prism_reach_ = 1.0;
  std::size_t count_ = 0;       // of the outlines in batches_
  std::vector<Batch> batches_;  // as many as there have ever been
  std::vector<const PositionalIndex::LargeOutline*> large_;
};

}  // namespace swarmanoid::devices
